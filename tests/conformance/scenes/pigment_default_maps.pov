// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { radial frequency 3 } }
sphere { <-0.9, 0, 0>, 0.9 pigment { radial rotate 90*x } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { marble scale 0.4 rotate 20*z } }
