// SPDX-License-Identifier: Apache-2.0
// Thin films of stirred thickness.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 100*x up 100*3/4*y }
light_source { <-60, 80, -100>, rgb 1 parallel point_at 0 }
plane { z, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 irid { 0.5 thickness 0.03 turbulence 0.5 } } }
