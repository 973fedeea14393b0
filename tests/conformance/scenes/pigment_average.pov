// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { average pigment_map { [1 checker rgb 1 rgb 0] [2 gradient x color_map { [0 rgb x] [1 rgb z] }] } } }
sphere { <-0.9, 0, 0>, 0.9 pigment { average pigment_map { [1 gradient y] [1 radial frequency 4] [1 rgb <1, 0.5, 0>] } } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { gradient y pigment_map { [0.2 average pigment_map { [1 rgb x] [1 rgb y] }] [0.8 wood scale 0.2] } translate -0.3*y } }
