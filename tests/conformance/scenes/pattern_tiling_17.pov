// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Tilings 17 to 24, a strip each; black where a tile's border begins, white at its sides.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 10, 0> look_at 0 right x*16 up y*12 }
#macro Patch(Number, Column, Row)
    box {
        <0, -0.1, 0>, <3.9, 0, 5.9>
        pigment { tiling Number color_map { [0 rgb <0.1, 0.2, 0.3>] [1 rgb <1, 0.9, 0.8>] } scale 0.7 translate <1.3, 0, 2.2> }
        finish { ambient 1 diffuse 0 }
        translate <4*Column - 8, 0, 6*Row - 6>
    }
#end
#for (I, 0, 7)
    Patch(17 + I, mod(I, 4), floor(I/4))
#end
