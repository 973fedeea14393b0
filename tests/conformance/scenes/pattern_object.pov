// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
#declare Thing = union { sphere { 0, 0.7 } box { <0.2, -2, -0.2>, <2, 2, 0.2> } }
plane { y, -1 pigment { object { Thing rgb 1 rgb <0.8, 0.3, 0.2> } scale 1.5 } }
sphere { <-0.9, 0, 0>, 0.9 pigment { object { Thing pigment { checker rgb 1 rgb 0.2 scale 0.2 } pigment { rgb <0.3, 0.8, 0.3> } } translate -0.2*z } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { object { torus { 0.5, 0.2 rotate 90*x } rgb <0.3, 0.4, 0.9> rgb <1, 0.8, 0.3> } translate <0.9, 0, -0.5> } }
