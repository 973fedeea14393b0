// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
union { sphere { -0.5*x, 0.7 } box { <0, -0.5, -0.5>, <1, 0.5, 0.5> pigment { rgb z } } cone { 0.4*y, 0.6, 1.3*y, 0 } rotate 20*y pigment { rgb <0.9, 0.4, 0.2> } finish { phong 0.6 } }
