// SPDX-License-Identifier: Apache-2.0
// Two rainbows in turbulent fog over a floor with a bump map and a ball of stirred film.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 1.2, 0> angle 70 }
light_source { <-40, 60, -80>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
fog { distance 60 rgb <0.7, 0.7, 0.8> turbulence 0.6 turb_depth 0.4 octaves 3 }
#declare Bow = color_map { [0 rgbt <1, 0.2, 0.2, 1>] [0.3 rgbt <1, 0.6, 0.1, 0.4>] [0.7 rgbt <0.1, 0.9, 0.3, 0.4>] [1 rgbt <0.3, 0.2, 1, 1>] }
rainbow { direction <0, -0.1, 1> angle 30 width 8 distance 8 color_map { Bow } arc_angle 160 falloff_angle 120 }
rainbow { direction <0.2, -0.1, 1> angle 38 width 5 distance 12 jitter 0.02 color_map { Bow } }
plane { y, 0 pigment { rgb <0.5, 0.6, 0.4> } normal { bump_map { function 32, 32 { sin(x * 12) * cos(y * 9) } bump_size 3 interpolate 2 } rotate 90*x scale 2 } }
sphere { <0.8, 0.9, 0>, 0.9 pigment { rgb 0.6 } finish { ambient 0.1 diffuse 0.8 irid { 0.4 thickness 0.3 turbulence 0.4 } } }
