// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
#default { pigment { rgb <0.2, 0.6, 0.9> } finish { ambient 0.3 phong 0.7 } }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { -x, 0.8 }
sphere { x, 0.8 pigment { rgb x } }
