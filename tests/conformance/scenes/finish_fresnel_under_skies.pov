// SPDX-License-Identifier: Apache-2.0
// The eye is inside of two spheres that stand for the sky: what leaves glass there isn't thrown back by Fresnel.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 1.4, -4> look_at <0, 0.4, 0> angle 46 right 1.333*x }
light_source { <40, 70, -60>, rgb 1 }
sphere { 0, 5000 hollow pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.5>] [1 rgb <0.2, 0.3, 0.7>] } scale 3000 }
  finish { ambient 1 diffuse 0 } }
sphere { 0, 4000 hollow pigment { rgbt <1, 1, 1, 0.8> } finish { ambient 0.6 diffuse 0 } }
plane { y, -0.6 pigment { checker rgb 0.9, rgb <0.3, 0.1, 0.1> } }
#declare Glass = texture { pigment { rgbf <0.95, 1, 0.95, 1> }
  finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy } }
box { <-0.7, -0.5, -0.5>, <0.5, 1.2, 0.6> texture { Glass } interior { ior 1.5 } rotate 35*y translate -0.5*x }
sphere { <1.2, 0.2, 0>, 0.7 texture { Glass } interior { ior 1.5 } }
