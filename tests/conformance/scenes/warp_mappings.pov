// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb <0.2, 0.3, 0.8> scale <0.05, 0.2, 0.2> warp { cylindrical orientation z dist_exp 0 } } }
sphere { <-0.9, 0, 0>, 0.9 pigment { checker rgb 1 rgb <0.8, 0.3, 0.2> scale 0.1 warp { spherical } } rotate 20*z }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> pigment { hexagon rgb 1 rgb 0.5 rgb <0.9, 0.4, 0.2> rotate 90*x scale 0.07 warp { cubic } scale 0.8 translate <0.9, 0, 0> } }
