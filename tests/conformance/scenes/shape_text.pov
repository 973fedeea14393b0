// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 }
light_source { <4, 7, -8>, rgb 1 }
plane { z, 2 pigment { checker rgb 0.9, rgb 0.3 } }
text { ttf "cyrvetic.ttf" "1107g" 0.4, 0 translate <-2.4, 0.8, 0> pigment { rgb <0.9, 0.4, 0.2> } }
text { ttf "timrom" "AVATo &1" 0.2, 0 translate <-2.4, -0.4, 0> pigment { rgb <0.2, 0.4, 0.9> } }
text { internal 3 " 01" 0.3, <0.2, -0.1, 0.1> rotate 30*y translate <-1.4, -1.6, 0> pigment { rgb <0.3, 0.8, 0.3> } }
