// SPDX-License-Identifier: Apache-2.0
// Components of a blob with textures of their own, blended by their strengths; one has the blob's.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.2, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
blob {
    threshold 0.4
    sphere { -0.7*x, 1.1, 1 pigment { gradient y color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.9, 0.1>] } scale 0.3 } rotate 40*z }
    sphere { 0.8*x, 1, 1.2 texture { pigment { rgb <0.1, 0.3, 0.9> } finish { phong 0.8 phong_size 20 } } }
    cylinder { -0.8*y, 1.1*y, 0.6, 1 }
    sphere { <0, 0, -0.9>, 0.6, -0.6 pigment { rgb 0 } }
    pigment { rgb <0.3, 0.9, 0.3> } finish { ambient 0.2 }
}
