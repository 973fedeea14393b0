// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Tilings as normals, as as a choice among textures, and with a wave form.
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0, 0.5> }
light_source { <6, 7, -8>, rgb 1 }
plane {
    y, -1
    texture {
        tiling 7
        texture_map {
            [0.5 pigment { rgb <0.8, 0.3, 0.2> } finish { specular 0.5 }]
            [0.5 pigment { checker rgb 0.9, rgb 0.5 scale 0.3 }]
        }
        scale 0.8
    }
}
sphere { <-2.1, 0, 0>, 1 pigment { rgb 0.8 } normal { tiling 6, 0.6 scale 0.3 } }
sphere { <0, 0, 0>, 1 pigment { tiling 16 frequency 2 sine_wave scale 0.25 color_map { [0 rgb <0, 0, 0.5>] [1 rgb <1, 1, 0.6>] } } }
sphere { <2.1, 0, 0>, 1 pigment { tiling 5 scale 0.4 } }
