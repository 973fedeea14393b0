// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 texture { gradient x texture_map { [0 pigment { checker rgb 1 rgb 0.2 scale 0.3 warp { repeat z*0.5 flip z } }] [1 pigment { wood scale 0.4 }] } warp { repeat x*0.8 } } }
sphere { <-0.9, 0, 0>, 0.9 pigment { gradient y pigment_map { [0 gradient x scale 0.4] [1 wood scale 0.3] } warp { repeat y*0.6 flip y } rotate 20*z } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { rgb <0.8, 0.7, 0.6> } normal { gradient x 0.6 sine_wave scale 0.2 warp { spherical } translate 0.9*x } }
