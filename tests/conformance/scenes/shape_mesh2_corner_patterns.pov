// SPDX-License-Identifier: Apache-2.0
// Patterns and finishes that blend between the corners of triangles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.2, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
mesh2 {
    vertex_vectors { 5, <-1.6, -0.8, 0>, <1.6, -0.8, 0>, <1.4, 1.3, 0.6>, <-1.4, 1.3, 0.6>, <0, 0.3, -0.4> }
    texture_list { 4,
        texture { pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.9, 0.1>] } scale 0.3 } }
        texture { pigment { checker rgb <0.1, 0.3, 0.9> rgb <0.2, 0.9, 0.9> scale 0.25 } finish { ambient 0.3 } }
        texture { pigment { rgb <0.2, 0.8, 0.2> } finish { phong 1 phong_size 5 } }
        texture { pigment { rgb <0.9, 0.9, 0.9> } finish { diffuse 0.3 } }
    }
    face_indices { 4, <0, 1, 4>, 0, 1, 2, <1, 2, 4>, 1, 3, 2, <2, 3, 4>, 3, 3, 2, <3, 0, 4>, 3, 0, 2 }
}
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Rings = texture { pigment { onion color_map { [0 rgb 1] [1 rgb 0] } scale 0.2 } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
mesh { triangle { <-2.6, -0.9, 0.5>, <-1.8, -0.9, 0.5>, <-2.2, 0.6, 0.5> texture_list { Red Rings Blue } } }
