// SPDX-License-Identifier: Apache-2.0
// Areas that turn to what they light: where few of their lights stand tells how.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <2, 5, -3>, rgb 0.6 area_light 2*x, 2*z, 3, 3 circular orient }
light_source { <-6, 2, 1>, rgb 0.4 area_light 1.5*y, 1.5*z, 2, 2 circular orient }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.7 } }
sphere { <-1.2, 0, 0>, 0.3 pigment { rgb <0.9, 0.2, 0.1> } }
box { <0.3, -1, -0.5>, <1.5, 0.6, 0.9> pigment { rgb <0.2, 0.7, 0.3> } rotate 20*y }
cylinder { <-0.2, -1, 1.5>, <-0.2, 1.6, 1.5>, 0.1 pigment { rgb <0.2, 0.3, 0.9> } }
