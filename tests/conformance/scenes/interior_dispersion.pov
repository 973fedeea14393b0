// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
plane { -z, -6 pigment { gradient x color_map { [0.5 rgb 0.1] [0.5 rgb 1] } scale 1.2 rotate 30*z } finish { ambient 0.5 diffuse 0.3 } }
#declare Glass = material {
    texture { pigment { rgbt 1 } finish { diffuse 0 phong 0.6 reflection 0.1 } }
    interior { ior 1.5 dispersion 1.15 dispersion_samples 7 }
}
sphere { -0.9*x, 0.85 material { Glass } }
prism { linear_sweep -0.9, 0.9, 4, <0, -0.6>, <1.7, -0.5>, <0.9, 0.9>, <0, -0.6> material { Glass } }
