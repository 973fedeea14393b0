// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 }
light_source { <-5, 10, -10> 1 }
#declare Bar = prism { 0, 1, 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> }
intersection {
  object { Bar } object { Bar rotate x*5 } object { Bar rotate z*5 }
  pigment { rgb <0.8, 0.6, 0.3> }
}
