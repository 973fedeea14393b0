// SPDX-License-Identifier: Apache-2.0
// Light that a prism spreads into its colours on a wall.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { spacing 0.004 gather 200, 2000 radius 0.25 } }
camera { location <1, 6, 0> look_at <4, 0.6, -2.5> angle 50 }
light_source { <-40, 1, 0> rgb 1.5 spotlight point_at <0, 1, 0> radius 0.4 falloff 0.45 }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.1 } }
box { <5, 0, -7>, <5.2, 3, 2> pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.7 } }
prism {
  linear_spline 0.5, 1.5, 4, <-0.7, -0.6>, <0.7, -0.6>, <0, 0.7>, <-0.7, -0.6>
  pigment { rgbf 0.98 }
  finish { ambient 0 diffuse 0 }
  interior { ior 1.5 dispersion 1.1 dispersion_samples 14 }
  photons { target refraction on collect off }
}
