// SPDX-License-Identifier: Apache-2.0
// Blobs of balls and cylinders, alone and in groups, with negative components, and texture coordinates.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, 0.5, 0> angle 45 }
light_source { <5, 10, -10> 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.3 } }
blob {
    threshold 0.6
    sphere { <-2.6, 0, 0>, 1, 1 }
    sphere { <-1.8, 0.3, 0>, 1, 1 }
    cylinder { <-2.6, 0, -0.5>, <-1.6, -0.6, -1>, 0.5, 1 }
    sphere { <-2.2, 0.3, -0.8>, 0.5, -0.8 scale <1, 1.2, 1> }
    pigment { rgb <0.6, 0.9, 0.5> }
}
difference {
    blob { threshold 0.5 sphere { 0, 1.2, 1 } cylinder { <0, 0, 0>, <1.2, 0.8, 0>, 0.7, 1 } }
    box { <-0.2, 0.1, -2>, <2, 2, 2> pigment { rgb <0.9, 0.9, 0.3> } }
    translate <1, -0.2, -1> pigment { rgb <0.8, 0.5, 0.9> }
}
sphere { 0, 0.6 pigment { uv_mapping checker rgb 0.9, rgb <0.8, 0.2, 0.1> scale 0.125 } translate <0, -0.4, -3> }
torus { 0.6, 0.25 pigment { uv_mapping checker rgb 0.9, rgb <0.1, 0.2, 0.8> scale 0.125 } translate <2.6, -0.7, -2.6> }
box { -0.4, 0.4 pigment { uv_mapping checker rgb 0.9, rgb <0.1, 0.7, 0.3> scale 0.08 } rotate 30*y translate <-2.6, -0.6, -2.6> }
