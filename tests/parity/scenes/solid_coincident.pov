// SPDX-License-Identifier: Apache-2.0
// Objects whose surfaces lie at one place: what is left comes before what is entered, then what was written first.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 5, -7> look_at <0, 0, 0.5> angle 55 }
light_source { <-6, 9, -5> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }

// Inlaid: tops at the height of a board that is written later.
#declare X = -2; #while (X <= 2)
  box { <X, -0.5, -1>, <X + 0.5, 0, 0> pigment { rgb <1, 0.2, 0.1> } }
  cylinder { <X + 0.75, -0.5, -0.5>, <X + 0.75, 0, -0.5>, 0.2 pigment { rgb <0.1, 0.8, 0.2> } }
#declare X = X + 1; #end
box { <-3, -1, -1.5>, <3, 0, 1.5> pigment { rgb <0.9, 0.8, 0.5> } finish { reflection 0.2 } }
// Hidden: written after the board.
box { <-2.8, -0.5, 0.5>, <2.8, 0, 1> pigment { rgb <0.1, 0.1, 0.9> } }
cylinder { <0, -0.5, -1.25>, <0, 0, -1.25>, 0.2 pigment { rgb <0.1, 0.1, 0.9> } }
// A plane at the board's height, and one of a solid's.
plane { y, 0 pigment { checker rgb 0.3, rgb 0.6 } }
intersection { box { <-1, 0, 1.6>, <1, 1, 2.6> } plane { y, 0.7 } pigment { rgb <0.8, 0.3, 0.8> } }
box { <-0.5, 0, 1.6>, <0.5, 0.7, 2.2> pigment { rgb <0.2, 0.9, 0.9> } }
// Glass that touches a ball of the same size in it, and a box standing against another.
sphere { <-2, 0.6, 2>, 0.6 pigment { rgbt <1, 0.9, 0.9, 0.8> } interior { ior 1.4 } }
sphere { <-2, 0.6, 2>, 0.6 pigment { rgb <0.9, 0.9, 0.2> } }
box { <2, 0, 1.6>, <2.5, 0.8, 2.2> pigment { rgbt <0.6, 0.9, 0.9, 0.7> } interior { ior 1.3 } }
box { <2.5, 0, 1.6>, <3, 0.8, 2.2> pigment { rgb <0.9, 0.5, 0.2> } }
