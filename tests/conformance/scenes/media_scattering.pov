// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
box { -1, 1 pigment { rgbt 1 } hollow interior { media { scattering { 1, <0.3, 0.2, 0.5> } } } translate -1.1*x }
sphere { 1.2*x, 0.9 pigment { rgbt 1 } hollow interior { media { scattering { 5, 0.4 eccentricity 0.3 extinction 0.5 } } } }
