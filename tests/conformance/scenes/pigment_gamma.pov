// SPDX-License-Identifier: Apache-2.0
// Components of a pigment by a function, to a power each.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.4, -4> look_at <0, 0.2, 0> angle 46 right 1.333*x }
light_source { <40, 70, -60>, rgb 1 }
background { rgb 0.4 }
#declare Plain = pigment { marble color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.3, 0.8, 0.4>] [1 rgb <0.1, 0.1, 0.9>] } scale 0.6 rotate <10, 30, 70> }
#declare Parts = function { pigment { Plain } }
#declare Bent = pigment { average pigment_map {
  [function { pow(Parts(x, y, z).x, 2.2) } color_map { [0 red 0] [1 red 3] }]
  [function { pow(Parts(x, y, z).y, 2.2) } color_map { [0 green 0] [1 green 3] }]
  [function { Parts(x, y, z).z } color_map { [0 blue 0] [1 blue 3] }] } }
sphere { 0.2*y, 1.1 pigment { Bent } }
plane { y, -1 pigment { Bent scale 2 } }
