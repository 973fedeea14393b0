// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
#declare P = function { pattern { wood scale 0.3 } }
plane { y, -1 pigment { rgb <0.6, 0.7, 0.8> } normal { function { sin(x*9)*0.4 + 0.5 } 0.6 } }
sphere { <-0.9, 0, 0>, 0.9 pigment { rgb <0.9, 0.7, 0.5> } normal { function { pow(sin(y*8)*sin(x*8), 2) } 1 } finish { phong 0.5 } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { rgb <0.5, 0.8, 0.6> } normal { function { P(x, y, z) } 0.5 } }
