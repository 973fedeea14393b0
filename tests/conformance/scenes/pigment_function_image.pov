// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { image_map { function 8, 8 { pigment { gradient x color_map { [0 rgb x] [1 rgb y] } } } } rotate 90*x } }
sphere { <-0.9, 0, 0>, 0.9 pigment { image_map { function 16, 8 { abs(x - y) } map_type 1 interpolate 2 } } }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { image_pattern { function 8, 8 { pattern { spherical translate x } } } color_map { [0 rgb <0.2, 0.3, 0.8>] [1 rgb <1, 0.8, 0.3>] } } }
