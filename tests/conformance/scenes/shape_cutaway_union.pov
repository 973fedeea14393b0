// SPDX-License-Identifier: Apache-2.0
// What a cut shows of a union: each part's texture, and the mean of those that overlap there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -4> look_at <0, 0, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
difference {
    union {
        sphere { -0.5*x, 0.9 pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.9, 0.1>] } scale 0.4 } }
        sphere { 0.5*x, 0.9 texture { pigment { rgb <0.1, 0.3, 0.9> } finish { phong 0.5 ambient 0.3 } } }
        box { <-0.2, -0.9, -0.8>, <0.2, 0.8, 0.8> pigment { rgb <0.2, 0.8, 0.2> } rotate 30*y }
    }
    box { <-2, 0.1, -2>, <2, 2, 2> rotate 10*z }
    cutaway_textures
}
