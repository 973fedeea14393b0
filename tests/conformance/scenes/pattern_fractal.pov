// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { mandel 30 color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } rotate 90*x } }
sphere { <-0.9, 0, 0>, 0.9 pigment { julia <0.353, 0.288>, 30 interior 1, 1 color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } translate -0.2*x } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { magnet 1 mandel 20 exterior 6, 0.02 color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } } }
