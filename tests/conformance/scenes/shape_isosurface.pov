// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
#declare Wave = function(a, b) { 0.2*sin(3*a)*cos(3*b) }
isosurface {
  function { y - Wave(x, z) }
  contained_by { sphere { 0, 1 } }
  accuracy 0.0001 max_gradient 1.5
  rotate -30*x translate -1.1*x
  pigment { rgb <0.9, 0.4, 0.2> } finish { phong 0.6 }
}
isosurface {
  function { x*x + y*y*y*y + z*z - 0.5 }
  contained_by { box { <-1, -0.5, -1>, <1, 1, 1> } }
  accuracy 0.0001 max_gradient 4
  rotate -20*x translate 1.1*x
  pigment { rgb <0.3, 0.5, 0.9> } finish { phong 0.6 }
}
