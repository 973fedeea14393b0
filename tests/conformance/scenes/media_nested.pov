// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Red = interior { media { absorption <0, 0.5, 0.5> } }
sphere { 0.3*y, 1.3 pigment { rgbt 1 } hollow interior { Red } }
box { <-0.2, -0.8, -0.6>, <2, 0.8, 0.6> pigment { rgbt 1 } hollow interior { media { absorption <0.8, 0.3, 0> } } }
// What is not hollow holds no media.
sphere { <-0.5, 0.5, 0>, 0.5 pigment { rgbt <1, 1, 1, 0.9> } }
