// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
#declare P = function { pattern { gradient x triangle_wave scale 0.5 } }
plane { y, -1 pigment { function { x*x*0.2 + 0.3*sin(z) + 0.4 } color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } } }
sphere { <-0.9, 0, 0>, 0.9 pigment { function { abs(x)*y + 1.3 } triangle_wave color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { function { P(x, y, z) } color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } scale 1.3 rotate 30*z } }
