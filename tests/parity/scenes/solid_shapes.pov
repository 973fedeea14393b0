// SPDX-License-Identifier: Apache-2.0
// Each kind of exact shape by itself, placed by transforms of all sorts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, 0.5, 0> angle 45 }
light_source { <5, 10, -10> 1 }
light_source { <-8, 6, -4> rgb <0.4, 0.4, 0.6> }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.3 } }
cone { <-3.4, -1, 0>, 0.8, <-3, 1.4, 0.4>, 0.1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 } }
cylinder { <3, -1, 1>, <3.5, 1, 1.2>, 0.5 open pigment { rgb <0.3, 0.8, 0.3> } }
torus { 1, 0.3 rotate 70*x translate <-1.8, 0.4, -2.2> pigment { rgb <0.2, 0.8, 0.8> } finish { reflection 0.3 } }
disc { <0, 1.8, 1.5>, <0.2, 1, -0.5>, 0.9, 0.3 pigment { rgb <1, 0.5, 0> } }
sphere { 0, 0.5 scale <1, 2, 0.6> rotate 30*z translate <0.3, 0.4, -1.2> pigment { rgb <0.6, 0.9, 0.5> } }
box { -0.5, 0.5 rotate <20, 30, 40> translate <1.8, -0.2, -2> pigment { rgb <0.9, 0.9, 0.4> } }
quadric { <1, 0.5, 1>, <0.2, 0, 0>, <0, -0.3, 0>, -0.4 translate <1.6, 0.4, 1> pigment { rgb <0.7, 0.7, 1> } }
