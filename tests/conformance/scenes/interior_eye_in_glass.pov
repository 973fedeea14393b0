// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.2, -0.3> look_at <0, 0, 3> angle 60 }
light_source { <5, 10, -5>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.3 pigment { checker rgb 1, rgb <0.2, 0.5, 0.2> } finish { ambient 0.3 } }
sphere { <0.8, 0, 3>, 0.7 pigment { rgb <0.9, 0.4, 0.2> } }
sphere { 0, 1 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.3 } no_shadow }
