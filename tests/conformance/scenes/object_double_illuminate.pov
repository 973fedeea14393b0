// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <3, 5, 6>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
disc { <-1.3, 0.2, 0>, z, 0.9 pigment { rgb <0.9, 0.5, 0.2> } double_illuminate }
union {
    disc { <0.4, 0.2, 0.2>, -z, 0.8 pigment { rgb <0.3, 0.9, 0.4> } finish { specular 0.8 roughness 0.1 } rotate 25*y }
    mesh { triangle { <1, -0.8, 0>, <2.4, -0.8, 0.3>, <1.7, 1, 0.1> } pigment { rgb 0.8 } finish { diffuse 0.6, 0.2 } }
    double_illuminate
}
cylinder { <0.2, -1, 1>, <0.2, 1.5, 1>, 0.1 pigment { rgb 0.5 } }
