// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { rgb <0.6, 0.7, 0.8> } normal { bump_map { function 16, 16 { 0.5 + 0.5 * sin(x * 18) * cos(y * 12) } bump_size 2 } rotate 90*x } }
sphere { <-0.9, 0, 0>, 0.9 pigment { rgb <0.9, 0.7, 0.5> } normal { bump_map { function 16, 16 { 0.5 + 0.5 * sin(x * 18) * cos(y * 12) } interpolate 2 bump_size 3 } scale 0.8 } finish { phong 0.5 } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { rgb <0.5, 0.8, 0.6> } normal { bump_map { function 16, 16 { 0.5 + 0.5 * sin(x * 18) * cos(y * 12) } } scale 0.5 } }
