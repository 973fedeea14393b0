// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { pigment_pattern { checker rgb 0.2 rgb 0.8 scale 0.5 rotate 30*y } pigment_map { [0 rgb <1, 0.6, 0.3>] [1 gradient x scale 0.3] } translate 0.2 } }
sphere { <-0.9, 0, 0>, 0.9 pigment { pigment_pattern { gradient y color_map { [0 rgb x] [1 rgb y] } scale 0.7 } color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { pigment_pattern { wood scale 0.3 } color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } rotate 20*x } }
