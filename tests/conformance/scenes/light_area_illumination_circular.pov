// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <2, 3, -1>, rgb 1 area_light 3*x, 3*z, 5, 5 circular adaptive 1 area_illumination on fade_distance 4 fade_power 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { <-1.2, 0, 0>, 0.8 pigment { rgb <0.9, 0.2, 0.1> } finish { specular 0.8 roughness 0.02 } }
box { <0.3, -1, -0.5>, <1.5, 0.6, 0.9> pigment { rgb <0.2, 0.7, 0.3> } rotate 20*y }
