// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
julia_fractal { <-0.16, 0.16, 0.56, -0.6> hypercomplex sqr max_iteration 4 precision 60 translate <0, 0.6, 0>
    pigment { rgb <0.4, 0.8, 0.3> } }
