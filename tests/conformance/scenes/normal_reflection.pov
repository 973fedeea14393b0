// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { <-0.9, 0, 0>, 0.9 pigment { rgb 0.2 } normal { gradient x 0.8 sine_wave scale 0.5 } finish { reflection 0.6 } }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { rgbt 0.9 } normal { gradient y 0.8 sine_wave scale 0.5 } finish { reflection 0.1 } interior { ior 1.3 } }
