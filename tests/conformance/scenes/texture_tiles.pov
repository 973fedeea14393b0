// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 texture { tiles { texture { pigment { rgb <0.9, 0.4, 0.2> } } tile2 texture { pigment { rgb <0.3, 0.5, 0.9> } } }
    translate 0.01*y } }
