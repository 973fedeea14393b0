#version 3.6;
mesh2 { vertex_vectors { 4, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 1, 0>, } normal_vectors { 1, <0, 0, 1> } uv_vectors { 2, <0, 0>, <1, 1> }
 texture_list { 2, texture { pigment { rgb x } } texture { pigment { rgb y } } }
 face_indices { 2, <0, 1, 2>, 0, 1, 0, <0, 2, 3>, 1 } normal_indices { 2, <0, 0, 0>, <0, 0, 0> } uv_indices { 2, <0, 1, 1>, <0, 0, 1> } }
mesh { triangle { 0, x, y } smooth_triangle { 0, z, x, z, y, z uv_vectors <0, 0>, <1, 0>, <0, 1> } inside_vector z }
