// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { 0, 1 texture { gradient y texture_map { [0.3 pigment { rgb x }] [0.7 pigment { checker rgb 1, rgb 0 scale 0.2 }] } translate 0.5*y } }
