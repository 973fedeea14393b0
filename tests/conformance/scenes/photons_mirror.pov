// SPDX-License-Identifier: Apache-2.0
// A patch of light that a coloured mirror throws on the floor: dull, shiny and brilliant finishes get it, one object
// doesn't collect it.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.008 gather 200, 3000 radius 0.4 } }
camera { location <0, 5, -5> look_at <1.5, 0, 0> angle 50 }
light_source { <-5, 3, 0> rgb 0.7 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0.02 diffuse 0.5 specular 0.3 roughness 0.1 brilliance 1.5 } }
box { <-2, 0, -0.5>, <2.5, 0.3, 0.1> pigment { rgb <1, 0.5, 0.5> } finish { ambient 0 diffuse 0.5 } photons { collect off } }
box {
  <-0.05, -2.2, -1.5>, <0.05, 1.5, 1.5>
  pigment { rgb 0 }
  finish { ambient 0 diffuse 0 reflection <0.9, 0.6, 0.3> }
  photons { target reflection on refraction off collect off }
  rotate 35*z
  translate <3, 3, 0>
}
