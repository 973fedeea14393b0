// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -6> look_at <0, -0.5, 0> angle 40 }
light_source { <2, 12, -3>, rgb 0.4 }
plane { y, -1 pigment { rgb 0.6 } finish { ambient 0.1 diffuse 0.7 } }
#macro Glass(X, Amount)
  sphere { <X, 0.5, 0>, 0.8 pigment { rgbf <1, 0.8, 0.6, 0.8> } finish { ambient 0 diffuse 0.1 } interior { ior 1.2 caustics Amount } }
#end
Glass(-1.5, 0.2) Glass(0.3, 1)
box { <1.3, 0.3, -1>, <2.6, 0.5, 1> pigment { rgbf 0.9 } normal { gradient x 0.5 sine_wave frequency 3 } finish { ambient 0 diffuse 0 } interior { caustics 0.6 } }
