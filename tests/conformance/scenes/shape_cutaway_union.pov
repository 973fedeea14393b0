// SPDX-License-Identifier: Apache-2.0
// What cuts show of unions: each part's texture, the mean of those that overlap there, and black of parts that have none.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.5, -6> look_at <0, 0, 0> angle 60 }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Parts = union {
    sphere { -0.4*x, 0.8 pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.9, 0.1>] } scale 0.3 } rotate 30*z }
    difference {
        sphere { 0.5*x, 0.8 }
        box { <0.4, -1, -0.2>, <2, 2, 0.2> }
        texture { pigment { rgb <0.1, 0.3, 0.9> } finish { phong 0.8 ambient 0.3 } }
    }
    box { <-0.2, -1, -0.9>, <0.2, 1, 0.9> }
    cylinder { -1.2*x, 1.2*x, 0.25 pigment { rgb <0.3, 0.9, 0.4> } }
}
difference { object { Parts } plane { -y, -0.1 } cutaway_textures rotate 20*y scale 0.9 translate -2.2*x }
intersection { object { Parts rotate 40*y } box { -0.75, 0.75 } cutaway_textures translate 0.2*x }
difference { object { Parts } sphere { <0, 0.6, -0.5>, 0.7 } cutaway_textures translate 2.4*x }
