// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Yellow = texture { pigment { rgb <0.9, 0.9, 0> } }
#declare Cyan = texture { pigment { rgb <0, 0.9, 0.9> } }
#declare Magenta = texture { pigment { rgb <0.9, 0, 0.9> } }
mesh2 {
  vertex_vectors { 4, <-1.5, -0.8, 0>, <1.5, -0.8, 0.5>, <0, 1.6, 0.4>, <1.8, 1.2, -0.6> }
  texture_list { 4, texture { pigment { rgb <0.9, 0.1, 0.1> } } texture { pigment { rgb <0.1, 0.8, 0.2> } }
    texture { pigment { rgb <0.1, 0.2, 0.9> } } texture { pigment { rgb 0.9 } } }
  face_indices { 2, <0, 1, 2>, 0, 1, 2, <2, 1, 3>, 2, 1, 3 }
}
mesh { triangle { <-2.2, -0.9, -1>, <-1.2, -0.9, -1.2>, <-1.8, 0.6, -1>
  texture_list { Yellow Cyan Magenta } } }
