// SPDX-License-Identifier: Apache-2.0
// A random number for each cube.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 20*x up 20*3/4*y }
light_source { <-60, 80, -100>, rgb 1 parallel point_at 0 }
plane { z, 0 pigment { cells color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.2>] } scale 0.4 translate 0.1*z } finish { ambient 1 diffuse 0 } }
