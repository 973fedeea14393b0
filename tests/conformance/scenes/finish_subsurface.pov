// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 0.5 mm_per_unit 10 subsurface { samples 1500, 150 } }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 0.9 }
plane { y, -1 pigment { rgb 0.3 } }
sphere { -x * 0.5, 1 pigment { rgb <0.8, 0.5, 0.2> } finish { diffuse 0.7 specular 0.3 subsurface { translucency <3, 1.5, 0.5> } } interior { ior 1.4 } }
box { <0.4, -0.99, -1.2>, <1.3, 0.2, -0.6> rotate y * 10 pigment { rgb <0.4, 0.7, 0.9> } finish { diffuse 0.9 subsurface { translucency <0.5, 1, 2> } } interior { ior 1.5 } }
