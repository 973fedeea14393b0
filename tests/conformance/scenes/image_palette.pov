// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// A picture with a palette of four colours: chooses among two textures, and lets light through where it has one of them.
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { gradient z color_map { [0 rgb 0.3] [1 rgb 0.9] } scale 4 } }
box {
    <0, 0, 0>, <1, 1, 0.2>
    texture {
        material_map {
            png "palette.png"
            texture { pigment { rgb <1, 0.3, 0.2> } }
            texture { pigment { rgb <0.2, 0.4, 1> } finish { phong 1 reflection 0.3 } }
        }
        scale 0.97  // the box's sides would lie on the picture's border, where rounding decides
        translate 0.01
    }
    scale 2
    translate <-2.1, -0.9, 0>
}
box {
    <0, 0, 0>, <1, 1, 0.2>
    pigment { image_map { png "palette.png" transmit 1, 0.7 transmit 3, 1 filter 2, 0.8 } scale 0.97 translate 0.01 }
    scale 2
    translate <0.1, -0.9, 0>
}
