// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Magnets with each way to colour what lies within and without, where single places don't follow from chance.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right x*16 up y*12 }
#declare Place = 0;
#macro Patch(Interior, Exterior, Factor)
    box {
        <0, 0, 0>, <3.9, 3.9, 0.1>
        pigment {
            magnet 2 julia <0.3, 0.4> 20
            interior Interior, Factor
            exterior Exterior, Factor
            color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0>] [1 rgb 1] }
            scale 0.8
            translate 2
        }
        finish { ambient 1 diffuse 0 }
        translate <4*mod(Place, 4) - 8, 4*floor(Place/4) - 6, 0>
    }
    #declare Place = Place + 1;
#end
Patch(0, 0, 0.6) Patch(1, 1, 1) Patch(2, 2, 2) Patch(3, 3, 1) Patch(4, 4, 1) Patch(5, 5, 1) Patch(6, 6, 1) Patch(0, 7, 3)
Patch(1, 8, 3) Patch(6, 1, 1)
#macro Whole(Exterior)
    box {
        <0, 0, 0>, <3.9, 3.9, 0.1>
        pigment { magnet 1 mandel 20 exterior Exterior, 4 color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0>] [1 rgb 1] } translate 2 }
        finish { ambient 1 diffuse 0 }
        translate <4*mod(Place, 4) - 8, 4*floor(Place/4) - 6, 0>
    }
    #declare Place = Place + 1;
#end
Whole(1) Whole(8)
