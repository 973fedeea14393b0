// SPDX-License-Identifier: Apache-2.0
// Smoke that only photons light: a mirror throws a beam through it.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.04 media 60 gather 50, 300 radius 0, 1, 0.45 } }
camera { location <0, 6, -1> look_at <0.3, 0, 0> angle 50 }
light_source { <-20, 0, 0> rgb 1 spotlight point_at 0 radius 2 falloff 2.2 }
box { <-1.5, -1.2, -2.4>, <2, 1.2, 1.2> hollow pigment { rgbt 1 } interior { media { scattering { 1, rgb 0.3 extinction 0 } samples 4 } } photons { target refraction on } }
box { <-0.1, -0.8, -1.4>, <0, 0.8, 1.4> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection <1, 0.6, 0.3> } rotate 50*y translate 0.5*x photons { reflection on collect off } }
