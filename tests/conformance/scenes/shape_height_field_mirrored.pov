// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 1, -1> look_at <0.5, -0.1, 0.4> angle 45 }
light_source { <5, 10, -5>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
height_field { function 256, 256 { pigment { checker rgb 0, rgb 1 scale 1/4 } } scale <0.5, -0.2, 1> pigment { rgb <0.9, 0.5, 0.3> } }
height_field { function 256, 256 { pigment { checker rgb 0, rgb 1 scale 1/4 } } scale <0.5, -0.2, 1> translate 0.5*x pigment { rgbf 1 } finish { reflection { 0, 1 fresnel } } interior { ior 1.2 } }
