// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { rgb <0.6, 0.7, 0.8> } normal { quilted 0.8 scale 0.7 } }
sphere { <-0.9, 0, 0>, 0.9 pigment { rgb <0.9, 0.7, 0.5> } normal { quilted 1 control0 0.2 control1 0.7 scale 0.4 } finish { phong 0.5 } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { rgb <0.5, 0.8, 0.6> } normal { quilted 0.6 control0 0 control1 1 scale 0.4 rotate 20*y } }
