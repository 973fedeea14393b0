// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Pavements as normals and as a choice among textures; one that names no numbers is of triangles.
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0, 0.5> }
light_source { <6, 7, -8>, rgb 1 }
plane {
    y, -1
    texture {
        pavement number_of_sides 6 number_of_tiles 4 pattern 2 form 2
        texture_map {
            [0.5 pigment { rgb <0.8, 0.3, 0.2> } finish { specular 0.5 }]
            [0.5 pigment { rgb 0.7 }]
        }
        scale 0.8
    }
}
box { <-3, -0.8, -0.4>, <-1.2, 0.2, 1.4> pigment { rgb 0.8 } normal { pavement 0.3 number_of_sides 4 number_of_tiles 5 pattern 3 scale 0.4 } }
sphere { <0, 0, 0>, 1 pigment { pavement triangle_wave scale 0.5 color_map { [0 rgb <0, 0, 0.5>] [1 rgb <1, 1, 0.6>] } } }
