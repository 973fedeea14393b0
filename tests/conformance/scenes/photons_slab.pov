// SPDX-License-Identifier: Apache-2.0
// Light through a green slab, which povray's photons bring without a shadow of the light's own, and off a tilted mirror.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.01 gather 200, 2000 radius 0.5 } }
camera { location <0, 3, -7> look_at <0, 1, 0> angle 50 }
light_source { <0, 6, -1> rgb 0.8 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.6 } }
box {
  <-1.5, 2, -1>, <0.5, 2.1, 1>
  pigment { rgbf <0.3, 0.9, 0.3, 0.8> }
  finish { ambient 0 diffuse 0 }
  interior { ior 1.3 }
  photons { target refraction on collect off }
}
