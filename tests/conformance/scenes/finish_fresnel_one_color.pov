// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
sky_sphere { pigment { rgb <0.3, 0.5, 0.9> } }
plane { y, -1 pigment { rgb 0.3 } finish { reflection { 0.8 fresnel } } interior { ior 1.5 } }
sphere { 0, 1 pigment { rgb <0.1, 0.2, 0.4> } finish { reflection { 0.5 fresnel } } interior { ior 1.8 } }
