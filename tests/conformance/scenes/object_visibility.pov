// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
plane { -z, -3 pigment { rgb 0.1 } finish { reflection 0.7 } }
sphere { <-1.2, 0, 0>, 0.6 pigment { rgb <0.9, 0.2, 0.1> } no_image }
sphere { <0, 0, 0>, 0.6 pigment { rgb <0.2, 0.9, 0.1> } no_reflection }
sphere { <1.2, 0, 0>, 0.6 pigment { rgb <0.2, 0.2, 0.9> } no_shadow }
box { <-2, -0.8, -2>, <2, 0.2, -1.8> pigment { rgbf 0.95 } }
