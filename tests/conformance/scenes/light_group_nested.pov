// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <-4, 6, -5>, rgb <0, 0, 0.8> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Ball = sphere { 0, 0.45 pigment { rgb 1 } }
#declare Red = light_source { <4, 6, -5>, rgb <0.8, 0, 0> }
#declare Green = light_source { <0, 7, -5>, rgb <0, 0.8, 0> }
#declare Group = light_group { light_source { Red } object { Ball } }
// Written out in the outer one: without its lights.
light_group { light_source { Green } light_group { light_source { Red } object { Ball } global_lights on translate -1.8*x } }
// Declared: with them. The outermost one says whether the scene's own lights count.
light_group { light_group { Group } light_source { Green } global_lights on translate -0.6*x }
light_group { union { object { Group } object { Ball translate 0.9*y } } light_source { Green } translate 0.6*x }
// A light in a union is the scene's.
difference {
    light_group { sphere { <1.8, 0, 0>, 0.6 pigment { rgb 1 } } light_source { Red } global_lights off }
    light_group { sphere { <1.8, 0.3, -0.4>, 0.5 pigment { rgb 1 } } light_source { Green } global_lights off }
}
light_group { union { object { Ball scale 0.5 translate <0, -0.7, -1.2> } light_source { <0, 5, -9>, rgb 0.3 } } light_source { Red } }
