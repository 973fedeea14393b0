// SPDX-License-Identifier: Apache-2.0
// Radiosity by bent normals: slopes of a sheet turn to the bright or to the dark side of the sky.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { recursion_limit 1 count 1600 error_bound 0.3 normal on pretrace_end 0.01 } }
camera { orthographic location <0, 8, 0> look_at 0 right 20*x up 15*z }
sphere { 0, 50 hollow no_image pigment { gradient x color_map { [0 rgb 0.2] [1 rgb <0.8, 0.7, 0.5>] } translate -0.5*x scale 100 } finish { emission 1 diffuse 0 } }
box { <-4, -0.1, -3>, <4, 0, 3> pigment { rgb 1 } normal { gradient x, 0.8 triangle_wave scale 4 } finish { diffuse 0.8 } }
