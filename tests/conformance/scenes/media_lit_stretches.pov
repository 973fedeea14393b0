// SPDX-License-Identifier: Apache-2.0
// Spots and a cylinder that overlap, one light without shadows, which media don't scatter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 45 }
light_source { <0, 6, 0> rgb 0.4 shadowless }
light_source { <-3, 5, 0> rgb <2, 1, 0.5> spotlight point_at <0, -1, 1> radius 8 falloff 14 }
light_source { <3, 5, 0> rgb <0.5, 1, 2> spotlight point_at <0, -1, 0> radius 12 falloff 12 tightness 0 }
light_source { <0, 5, 1> rgb 0.5 cylinder point_at <0, -1, 1> radius 0.5 falloff 0.7 }
plane { y, -1 hollow pigment { rgb 0.7 } }
plane { -z, -4 hollow pigment { rgb <0.5, 0.6, 0.9> } }
sphere { <-1, 0.6, 0.7>, 0.4 pigment { rgb <1, 0.4, 0.4> } }
media { scattering { 1, 0.06 } emission 0.01 samples 8 }
