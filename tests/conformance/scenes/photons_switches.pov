// SPDX-License-Identifier: Apache-2.0
// Where photons stand for light that gets through: on what collects them only, behind targets that refract them, if
// neither object nor light denies it, and not behind what they pass through. Few of them come to where they'd be seen.
#version 3.7;
global_settings { assumed_gamma 1 photons { count 100 radius 0.001 } }
camera { location <0, 7, -6> look_at 0 angle 50 }
light_source { <0, 10, 0> rgb 1 }
box { <-9, -1, -9>, <9, 0, 0.1> pigment { rgb 1 } finish { ambient 0 diffuse 0.6 } }
box { <-9, -1, 0.1>, <9, 0, 9> pigment { rgb <1, 1, 0.8> } finish { ambient 0 diffuse 0.6 } photons { collect off } }
#macro Slab(X)
  box { <X - 0.5, 1, -0.5>, <X + 0.5, 1.1, 0.5> pigment { rgbf <0.5, 0.8, 0.9, 0.9> } finish { ambient 0 diffuse 0 } }
#end
object { Slab(-3) photons { target refraction on } }
object { Slab(-1.5) photons { target refraction off reflection on } }
object { Slab(0) photons { target refraction on reflection on } }
object { Slab(1.5) photons { refraction on } }
object { Slab(3) photons { target refraction on pass_through } }
