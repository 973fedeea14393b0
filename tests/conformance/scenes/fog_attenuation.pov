// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 media_attenuation on }
fog { distance 25 rgb <0.8, 0.3, 0.2> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { <-1.2, 0, 0>, 0.8 pigment { rgb <0.9, 0.2, 0.1> } }
// No fog inside of what is not hollow.
box { <0.3, -1, -0.5>, <1.5, 0.6, 2> pigment { rgbt <0.2, 0.7, 0.3, 0.7> } rotate 20*y }
sphere { <1, 0.9, 1>, 0.8 hollow pigment { rgbt <0.2, 0.7, 0.3, 0.7> } }
