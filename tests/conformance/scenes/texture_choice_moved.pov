// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// A choice between two plain textures of different finishes moves with its object, though neither has a pattern.
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
#declare Tiled = texture {
    checker
    texture { pigment { rgb <1, 0.3, 0.2> } }
    texture { pigment { rgb <0.2, 0.4, 1> } finish { phong 1 } }
    scale 0.37
}
box { <0, 0, 0>, <1, 1, 0.2> texture { Tiled } translate <-1.41, -0.61, 0> scale 1.5 }
box { <0, 0, 0>, <1, 1, 0.2> texture { Tiled } scale 1.5 rotate 30*z translate <0.93, -0.9, 0> }
