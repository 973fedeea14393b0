// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <3, 5, 6>, rgb 1 }
light_source { <-3, 2, -6>, rgb <0.1, 0.1, 0.3> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Paper = finish { diffuse 0.6, 0.35 }
disc { <-1.3, 0.2, 0>, z, 0.9 pigment { rgb <0.9, 0.5, 0.2> } finish { Paper } }
disc { <0.4, 0.2, 0.2>, -z, 0.8 pigment { rgb <0.3, 0.9, 0.4> } finish { Paper brilliance 2 phong 0.5 } rotate 25*y }
disc { <1.7, 0.2, 0>, -z, 0.7 pigment { rgb 0.8 } finish { Paper } texture { pigment { rgbt <0, 0, 1, 0.5> } finish { diffuse 0.2, 0.5 } } }
sphere { <0.4, 0.6, 1>, 0.3 pigment { rgb 1 } no_shadow finish { Paper } }
cylinder { <0.2, -1, 1>, <0.2, 1.5, 1>, 0.1 pigment { rgb 0.5 } }
