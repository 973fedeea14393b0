// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 normal { wood 0.4 sine_wave scale 0.2 } }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { <-1.2, 0, 0>, 0.8 pigment { rgb <0.9, 0.2, 0.1> } }
box { <0.3, -1, -0.5>, <1.5, 0.6, 0.9> pigment { rgb <0.2, 0.7, 0.3> } rotate 20*y }
cylinder { <-0.2, -1, 1.5>, <-0.2, 1.6, 1.5>, 0.3 pigment { rgb <0.2, 0.3, 0.9> } }
