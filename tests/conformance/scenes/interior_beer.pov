// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#macro Glass(X, Distance)
  box { <-0.6, -0.8, -0.6>, <0.6, 0.6, 0.6> translate x*X pigment { rgbf 1 } finish { ambient 0 diffuse 0 }
    interior { ior 1.1 fade_distance Distance fade_power 1001 fade_color rgb <0.2, 0.5, 0.9> } }
#end
Glass(-1.5, 0.5) Glass(0, 1) Glass(1.5, 2)
