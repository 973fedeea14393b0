// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Blue = texture { pigment { rgb z } }
mesh { triangle { <-1,-0.7,0>, <1,-0.7,0>, <0,0,-0.9> } triangle { <1,-0.7,0>, <0,1,0.2>, <0,0,-0.9> texture { Blue } } triangle { <0,1,0.2>, <-1,-0.7,0>, <0,0,-0.9> } texture { pigment { rgb <0.9, 0.4, 0.2> } finish { phong 0.6 } } }
