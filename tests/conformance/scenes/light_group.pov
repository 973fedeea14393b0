// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <-4, 6, -5>, rgb <0.2, 0.3, 0.8> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
light_group {
    light_source { <4, 6, -5>, rgb <0.8, 0.2, 0> }
    sphere { <-1.5, 0, 0>, 0.7 pigment { rgb 1 } finish { phong 0.5 } }
}
light_group {
    sphere { <-0.1, -0.3, -0.6>, 0.5 pigment { rgb 1 } }
    light_source { <0, 7, -5>, rgb <0, 0.7, 0.1> }
    light_source { <4, 6, -5>, rgb -0.3 }
    global_lights on
}
box { <0.6, -1, -0.5>, <1.6, 0.6, 0.9> pigment { rgb 1 } rotate 20*y }
