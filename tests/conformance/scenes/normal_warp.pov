// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { rgb <0.6, 0.7, 0.8> } normal { gradient x 0.7 sine_wave scale 0.3 warp { repeat z*0.5 flip x } } }
sphere { <-0.9, 0, 0>, 0.9 pigment { rgb <0.9, 0.7, 0.5> } normal { wood 0.5 sine_wave scale 0.3 warp { black_hole <0, 0, -0.9>, 0.8 inverse } } finish { phong 0.5 } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { rgb <0.5, 0.8, 0.6> } normal { gradient y 0.6 sine_wave scale 0.1 rotate 30*z warp { repeat x*0.5 flip x } } }
