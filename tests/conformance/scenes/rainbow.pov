// SPDX-License-Identifier: Apache-2.0
// Arcs that fade out or end, colours that let light through or tint it, two bows in one place, a wall half-way and a
// mirror.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 2, 0> angle 90 }
background { rgb <0.3, 0.4, 0.6> }
light_source { <10, 20, -10> 1 }
#declare Colors = color_map {
    [0 rgb <0.6, 0.2, 1> transmit 1] [0.3 rgb <0.2, 0.2, 1> transmit 0.5] [0.6 rgbf <0.2, 1, 0.2, 0.6>] [1 rgb <1, 0.2, 0.2>] }
rainbow { angle 42 width 8 distance 10 direction <0, -0.1, 1> color_map { Colors } arc_angle 140 falloff_angle 60 }
rainbow { angle 30 width 6 direction <0, 0.2, 1> color_map { Colors } up <1, 1, 0> arc_angle 90 }
rainbow { angle 27 width 8 direction <0, 0.2, 1> color_map { Colors } up <1, 1, 0> arc_angle 200 falloff_angle 100 }
fog { distance 60 rgbt <0.8, 0.8, 0.9, 0.7> }
plane { y, 0 hollow pigment { rgb <0.4, 0.5, 0.3> } }
box { <2, 0, 4>, <5, 5, 5> pigment { rgb 0.5 } }
sphere { <-2, 1.5, 0>, 1 pigment { rgb 0.1 } finish { reflection 0.8 } }
