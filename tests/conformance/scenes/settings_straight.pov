// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
background { rgb <0.3,0.4,0.6> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare G = texture { pigment { rgbf <0.9, 0.95, 1, 0.9> } }
#declare i=0; #while (i<8) box { <-1,-1,0>,<1,1,0.1> translate z*i pigment { rgbt <1,1,1,0.9> } } #declare i=i+1; #end
