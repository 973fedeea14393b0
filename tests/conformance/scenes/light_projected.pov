// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <2, 4, -6>, rgb 0.2 shadowless }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Mask = union { sphere { <-1, 2, 0>, 0.5 } box { <0.3, 1.8, -0.6>, <1.4, 2.2, 0.4> } }
light_source { <0, 6, -0.5>, rgb 1 projected_through { Mask rotate -15*y } }
box { <-1.1, 3, -0.3>, <-0.8, 3.2, 0.3> pigment { rgb <1, 0, 0> } }
sphere { <0.9, -0.5, -0.2>, 0.4 pigment { rgb <1, 0.8, 0> } }
sphere { <-0.7, -0.7, 0>, 0.3 pigment { rgb <0, 0.8, 1> } }
