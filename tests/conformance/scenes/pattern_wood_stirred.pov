// SPDX-License-Identifier: Apache-2.0
// Little turbulence far from the middle: the grain is small, but not what it does to the rings.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -100*z direction z right 80*x up 60*y }
plane { z, 0 pigment { wood turbulence <0.004, 0.003, 0.3> octaves 2 frequency 0.2 color_map { [0 rgb <0.9, 0.7, 0.4>] [1 rgb <0.6, 0.4, 0.2>] } }
  finish { ambient 1 diffuse 0 } }
