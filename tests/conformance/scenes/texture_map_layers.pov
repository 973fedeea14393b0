// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
#declare Layered = texture { pigment { rgb <0.9, 0.8, 0.6> } finish { phong 0.8 } } texture { pigment { gradient y color_map { [0 rgbt <0, 0, 0, 0.2>] [1 rgbt <1, 0, 0, 1>] } scale 0.4 } finish { diffuse 0.4 } }
plane { y, -1 texture { gradient x texture_map { [0.3 Layered] [0.7 pigment { rgb <0.2, 0.4, 0.8> }] } } }
sphere { <-0.9, 0, 0>, 0.9 texture { Layered scale 0.7 } }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> texture { object { sphere { <0.9, 0, -0.5>, 0.6 } texture { Layered } texture { pigment { rgbt <1, 0.5, 0.2, 0.6> } finish { phong 0.6 } } } } }
