// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Thin films colour what is mirrored, too: by reflection, and where all light is thrown back within glass.
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 3, -7> look_at <0, 0, 0> angle 40 }
light_source { <4, 7, -8>, rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Film = finish { diffuse 0.2 ambient 0 irid { 0.5 thickness 0.6 } };
box { -0.7, 0.7 pigment { rgb 0.3 } finish { Film reflection 0.7 } rotate 30*y translate -1.8*x }
box { -0.7, 0.7 pigment { rgbf 1 } finish { Film } interior { ior 1.5 } rotate 30*y }
sphere { 1.8*x, 0.8 pigment { rgb 0.2 } finish { Film reflection { 0.2, 0.8 } } }
