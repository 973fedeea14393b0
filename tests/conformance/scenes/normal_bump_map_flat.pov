// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Bumps of a picture: few texels and many, two sizes. Red, green and blue light tell which way they lean.
global_settings { assumed_gamma 1 }
camera { orthographic location <1, 0.75, -10> look_at <1, 0.75, 0> right x*2 up y*1.5 }
light_source { <1, 0, -1>*1000, rgb <1, 0, 0> parallel point_at 0 }
light_source { <-1, 0, -1>*1000, rgb <0, 1, 0> parallel point_at 0 }
light_source { <0, 1, -1>*1000, rgb <0, 0, 1> parallel point_at 0 }
plane {
    z, 0
    pigment { rgb 1 }
    normal {
        bump_map { function 4, 4 { select(x - 0.5, select(y - 0.5, 0.1, 0.4), select(y - 0.5, 0.2, 0.9)) } bump_size 0.8 }
    }
    clipped_by { plane { x, 1 } }
}
plane {
    z, 0
    pigment { rgb 1 }
    normal { bump_map { function 16, 16 { 0.5 + 0.5*sin(x*18)*cos(y*12) } bump_size 2 } scale 0.8 }
    clipped_by { plane { -x, -1 } }
}
