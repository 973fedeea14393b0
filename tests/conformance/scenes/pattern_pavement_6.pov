// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Pavements of hexagons, with each look of their corners.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 10, 0> look_at 0 right x*16 up y*12 }
#macro Patch(Place, Sides, Tiles, Pattern, Exterior, Interior, Form)
    box {
        <0, -0.1, 0>, <3.9, 0, 5.9>
        pigment {
            pavement number_of_sides Sides number_of_tiles Tiles pattern Pattern exterior Exterior interior Interior form Form
            color_map { [0 rgb <0.5, 0.2, 0.1>] [1 rgb <1, 0.9, 0.8>] }
            scale 0.9
            translate <1.31, 0, 2.23>
        }
        finish { ambient 1 diffuse 0 }
        translate <4*mod(Place, 4) - 8, 0, 6*floor(Place/4) - 6>
    }
#end
Patch(0, 6, 1, 1, 0, 0, 2)
Patch(1, 6, 2, 1, 0, 1, 1)
Patch(2, 6, 3, 2, 0, 2, 0)
Patch(3, 6, 4, 3, 0, 0, 0)
Patch(4, 6, 4, 6, 0, 1, 2)
Patch(5, 6, 5, 4, 0, 2, 1)
Patch(6, 6, 5, 15, 0, 0, 2)
Patch(7, 6, 5, 22, 0, 2, 2)
