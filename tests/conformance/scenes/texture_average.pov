// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
// Not from 1.5 as in other scenes: the whole row below the horizon would lie where a gradient jumps.
camera { location <0, 1.6, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 texture { average texture_map { [1 pigment { checker rgb 1 rgb 0.1 }] [3 pigment { gradient z } finish { ambient 0.4 }] } } }
sphere { <-0.9, 0, 0>, 0.9 texture { average texture_map { [pigment { rgb <0.9, 0.3, 0.2> } finish { phong 1 }] [pigment { rgb <0.2, 0.3, 0.9> } normal { gradient y 0.5 sine_wave scale 0.2 }] } } }
box { <0.2, -0.8, -0.5>, <1.6, 0.8, 0.6> texture { tiles { texture { pigment { rgb 0.9 } finish { phong 0.4 } } tile2 texture { pigment { rgb <0.1, 0.3, 0.2> } finish { reflection 0.2 } } } scale 0.4 } }
