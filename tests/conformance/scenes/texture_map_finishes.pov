// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 texture { gradient x texture_map { [0.3 pigment { rgb <0.9, 0.7, 0.2> } finish { reflection 0.3 }] [0.7 pigment { rgb <0.2, 0.4, 0.8> } finish { ambient 0.4 diffuse 0.3 }] } } }
sphere { <-0.9, 0, 0>, 0.9 texture { wood texture_map { [0.4 pigment { rgb <0.8, 0.5, 0.3> } finish { phong 0.9 }] [0.6 pigment { rgb <0.3, 0.3, 0.3> } finish { specular 0.8 roughness 0.01 diffuse 0.9 } normal { gradient y 0.4 sine_wave scale 0.1 }] } scale 0.5 } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> texture { checker texture { pigment { rgb <1, 0.3, 0.2> } finish { emission 0.3 } } texture { gradient y texture_map { [0 pigment { rgb 1 } finish { diffuse 0.4 }] [1 pigment { rgb <0.3, 0.6, 0.3> } finish { phong 0.6 brilliance 2 }] } } scale 0.4 } }
