// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Window = mesh2 {
    vertex_vectors { 4, <-2, -1.5, -4>, <2, -1.5, -4>, <2, 1.5, -4>, <-2, 1.5, -4> }
    normal_vectors { 4, <-0.2, -0.15, 1>, <0.2, -0.15, 1>, <0.2, 0.15, 1>, <-0.2, 0.15, 1> }
    uv_vectors { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
    face_indices { 2, <0, 1, 2>, <0, 2, 3> }
}
camera { mesh_camera { 1 3 mesh { Window } smooth } location <0, 0, 0.01> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { <-1.2, 0, 0>, 0.8 pigment { rgb <0.9, 0.2, 0.1> } }
box { <0.3, -1, -0.5>, <1.5, 0.6, 0.9> pigment { rgb <0.2, 0.7, 0.3> } rotate 20*y }
cylinder { <-0.2, -1, 1.5>, <-0.2, 1.6, 1.5>, 0.3 pigment { rgb <0.2, 0.3, 0.9> } }
