// SPDX-License-Identifier: Apache-2.0
// Matt light, darkened at random.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 20*x up 20*3/4*y }
light_source { <-60, 80, -100>, rgb 1 parallel point_at 0 }
plane { z, 0 pigment { rgb 0.7 } finish { ambient 0.1 diffuse 0.8 crand 0.3 } }
