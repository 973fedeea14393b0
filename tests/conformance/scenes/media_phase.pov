// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Glass = material { texture { pigment { rgbt 1 } } }
sphere { <-1.8, 0, 0>, 0.6 material { Glass } hollow interior { media { scattering { 2, 0.4 } } } }
sphere { <-0.6, 0, 0>, 0.6 material { Glass } hollow interior { media { scattering { 3, 0.4 } } } }
sphere { <0.6, 0, 0>, 0.6 material { Glass } hollow interior { media { scattering { 4, 0.4 } } } }
sphere { <1.8, 0, 0>, 0.6 material { Glass } hollow interior { media { scattering { 5, 0.4 eccentricity -0.4 } } } }
