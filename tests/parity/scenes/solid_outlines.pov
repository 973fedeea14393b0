// SPDX-License-Identifier: Apache-2.0
// Shapes made of outlines and polynomials, alone and in groups.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, 0.5, 0> angle 45 }
light_source { <5, 10, -10> 1 }
light_source { <-8, 6, -4> rgb <0.4, 0.4, 0.6> }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.3 } }
polygon { 10, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>, <0.3, 0.3>, <0.7, 0.3>, <0.7, 0.7>, <0.3, 0.7>, <0.3, 0.3>
    scale 1.2 rotate <20, 30, 0> translate <-3.4, 0.6, 0> pigment { rgb <0.9, 0.3, 0.2> } }
prism { linear_spline -0.3, 0.3, 8, <0, 0>, <1, 0>, <0.6, 1>, <0, 0>, <0.3, 0.2>, <0.7, 0.2>, <0.5, 0.6>, <0.3, 0.2>
    rotate <-60, 20, 0> translate <-2, -0.8, -1> pigment { rgb <0.3, 0.8, 0.3> } }
prism { bezier_spline 0, 0.8, 8, <0, 0>, <0, 0.7>, <0.9, 0.7>, <0.9, 0>, <0.9, 0>, <0.9, -0.7>, <0, -0.7>, <0, 0> open
    rotate -30*x translate <-2.3, -0.8, -3> pigment { rgb <0.3, 0.5, 0.9> } }
difference {
    prism { cubic_spline 0, 1, 7, <1, -1>, <0, 0>, <1, 1>, <2, 0>, <1, -1>, <0, 0>, <1, 1> }
    cylinder { <1, -1, 0>, <1, 2, 0>, 0.4 }
    translate <-0.6, -1, 1> pigment { rgb <0.9, 0.8, 0.3> }
}
text { ttf "crystal.ttf" "Oa" 0.3, 0 translate <-0.5, 1.8, 0> pigment { rgb <0.2, 0.8, 0.8> } }
sor { 6, <0, -1>, <0.4, 0>, <0.7, 0.4>, <0.3, 0.9>, <0.4, 1.4>, <0.6, 1.8> open
    scale 0.9 translate <0.4, -1, -2.4> pigment { rgb <1, 0.5, 0> } }
lathe { bezier_spline 4, <0.2, 0>, <1, 0.3>, <0.2, 0.6>, <0.5, 1.2> translate <1.8, -0.9, -2.4> pigment { rgb <0.6, 0.9, 0.5> } }
lathe { linear_spline 5, <0.3, 0>, <0.8, 0>, <0.8, 0.4>, <0.3, 0.7>, <0.3, 0> rotate 20*z translate <3.2, -0.4, -1.4> pigment { rgb <0.8, 0.6, 0.9> } }
intersection {
    lathe { quadratic_spline 4, <0, -0.2>, <0.6, 0>, <0.7, 0.5>, <0.2, 1> }
    plane { z, 0 rotate 30*y }
    translate <3.3, -0.4, 1> pigment { rgb <0.9, 0.9, 0.4> }
}
quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -1.04, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0.96, 0, 0, 0, 0, 1, 0, -1.04, 0, 0.2304>
    rotate 50*x scale 0.8 translate <1.4, 1.2, 1> pigment { rgb <0.7, 0.7, 1> } }
cubic { <0, 0, 0, 1, 0, 0, 0, 0, 0, 0, -1, 0, 0, -1, 0, 0, 0, 0, 0, 0> clipped_by { sphere { 0, 0.8 } }
    rotate 40*x translate <2.8, 1.4, 1> pigment { rgb <0.4, 0.7, 0.9> } }
