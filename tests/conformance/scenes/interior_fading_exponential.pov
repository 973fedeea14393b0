// SPDX-License-Identifier: Apache-2.0
// Glass whose colours dim exponentially (fade_power of 1000 and more), seen through and in its shadow.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 4, -6> look_at <0, 0.4, 0> angle 45 }
light_source { <-4, 8, -2> rgb 1 }
plane { y, 0 pigment { checker rgb 1 rgb 0.6 } finish { ambient 0.1 diffuse 0.8 } }
#macro Glass(Far)
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { ior 1.2 fade_power 1001 fade_distance Far fade_color <0.5, 0.8, 0.2> }
#end
box { <-2, 0.2, -0.7>, <-0.4, 1, 0.7> Glass(1) }
sphere { <1.2, 1, 0>, 0.8 Glass(0.5) }
