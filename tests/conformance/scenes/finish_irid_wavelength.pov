// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <0.6, 0.5, 0.35> }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
light_source { <-4, 3, -8>, rgb 0.3 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { -0.9*x, 0.85 pigment { rgb <0.9, 0.6, 0.5> } finish { phong 0.4 irid { 0.4 thickness 0.5 } } }
sphere { <0.9, 0, 0>, 0.85 pigment { rgb 0.9 } normal { gradient y, 0 scale 0.5 } finish { diffuse 0.5 irid { 0.25 thickness 2 } } }
