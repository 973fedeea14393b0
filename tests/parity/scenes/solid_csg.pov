// SPDX-License-Identifier: Apache-2.0
// Everything that shapes are put together by: holes, common parts, merged glass, clips, insides turned out, faces that
// coincide, textures of cuts and of insides, and bounds that hide what lies off them.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 5, -9> look_at <0, 0.3, 0> angle 45 }
light_source { <5, 10, -10> 1 }
light_source { <-8, 6, -4> rgb <0.4, 0.4, 0.6> }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.3 } }
difference {
    box { -1, 1 pigment { rgb <0.9, 0.8, 0.2> } }
    sphere { <0.3, 0.6, -1>, 1 pigment { rgb <0.2, 0.3, 0.9> } }
    union { cylinder { -2*x, 2*x, 0.4 } cylinder { -2*y, 2*y, 0.4 } pigment { rgb <0.2, 0.9, 0.3> } }
    rotate 20*y
}
intersection {
    sphere { <1.8, 0, -2>, 0.8 }
    plane { x + y, 0 rotate 10*y translate <1.9, 0.2, -2> }
    torus { 0.6, 0.4 translate <1.8, 0, -2> inverse }
    pigment { rgb <0.9, 0.4, 0.9> }
}
merge {
    sphere { <2.6, -0.4, -3.4>, 0.5 }
    sphere { <3.1, -0.4, -3.4>, 0.5 }
    cylinder { <2.6, -0.4, -3.4>, <3.1, -0.4, -3.4>, 0.2 }
    pigment { rgbt <1, 0.6, 0.3, 0.6> }
    interior { ior 1.3 }
}
sphere { 0, 0.5 scale <1, 2, 0.6> translate <-2.2, 1.5, -0.2> clipped_by { plane { y, 1.8 } } pigment { rgb <0.6, 0.9, 0.5> }
    interior_texture { pigment { rgb <1, 0.2, 0.2> } } }
quadric { <1, 0, 1>, <0, 0, 0>, <0, -0.3, 0>, 0 clipped_by { box { <-1, -1, -1>, <1, 1.2, 1> } } translate <3.6, -1, 2>
    pigment { rgb <0.7, 0.7, 1> } }
difference {  // faces that coincide
    box { <-3.4, -1, -3>, <-2.2, 0, -1.8> }
    box { <-3, -0.5, -3>, <-2.6, 0, -1.8> pigment { rgb <0.3, 0.3, 0.9> } }
    pigment { rgb <0.9, 0.5, 0.3> }
}
difference {
    union { sphere { <-0.4, 0, 0>, 0.5 } sphere { <0.4, 0, 0>, 0.5 } pigment { gradient x color_map { [0 rgb x] [1 rgb y] } } }
    plane { z, -0.2 }
    cutaway_textures
    translate <-0.4, -0.4, -3.4>
}
union {
    cone { <0, 0, 0>, 0.4, <0, 1, 0>, 0 }
    torus { 0.4, 0.1 }
    clipped_by { plane { x, 0.1 } }
    rotate -40*y
    translate <2.6, -0.9, -0.6>
    pigment { rgb <0.2, 0.7, 0.9> }
}
quadric { <0, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.01 bounded_by { box { <2, -1, -0.2>, <3, 1, 0.2> } } translate 3*z
    pigment { rgb <0.5, 0.5, 0.2> } }
