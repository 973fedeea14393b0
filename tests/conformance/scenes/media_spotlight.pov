// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <-1, 3.5, 1>, rgb 3 spotlight point_at <0, -1, 0> radius 12 falloff 20 }
light_source { <3, 6, -6>, rgb 0.3 media_interaction off media_attenuation on }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
plane { -z, -6 pigment { rgb 0.4 } hollow }
box { <-0.4, 0.6, -0.4>, <0.2, 0.9, 0.2> pigment { rgb <0.9, 0.2, 0.1> } }
media { scattering { 1, 0.06 extinction 0.5 } samples 20 intervals 3 }
