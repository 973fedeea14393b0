// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Coordinates on surfaces: of pigments, of textures that are a choice, of normals; on spheres, a box and a torus.
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -5> look_at <0, 0.1, 0> }
light_source { <4, 7, -8>, rgb 1 }
sphere { 0, 0.8 pigment { uv_mapping checker rgb 0.2, rgb 1 scale 0.13 } rotate 30*y translate <1.3, 0.7, 0> }
sphere {
    0, 0.8
    texture {
        uv_mapping
        checker
        texture { pigment { rgb <1, 0.3, 0.2> } }
        texture { pigment { rgb <0.2, 0.4, 1> } finish { phong 1 } }
        scale 0.13
    }
    translate <-1.3, 0.7, 0>
}
sphere { <0, -1, -0.5>, 0.6 pigment { rgb 0.8 } normal { uv_mapping gradient x 0.8 sine_wave scale 0.05 } }
box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> pigment { uv_mapping gradient x color_map { [0 rgb 1] [1 rgb <0.2, 0.5, 0.2>] } scale 0.11 } translate <-1.5, -1, 0> }
torus { 0.6, 0.25 pigment { uv_mapping checker rgb <1, 0.8, 0.3>, rgb 0.2 scale 0.09 } rotate -40*x translate <1.5, -1, 0> }
