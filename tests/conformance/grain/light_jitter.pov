// SPDX-License-Identifier: Apache-2.0
// Few lights of an area, each off its place at random for each point.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -1> right 4*x up 3*y }
light_source { <0, 0, -10>, rgb 1 area_light 3*x, 3*y, 3, 3 jitter }
plane { z, 0 pigment { rgb 0.8 } }
box { <-9, -9, -5>, <0, 9, -4.9> }
