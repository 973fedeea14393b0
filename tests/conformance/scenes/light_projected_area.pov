// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <2, 4, -6>, rgb 0.2 shadowless }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
light_source {
    0, rgb 1 area_light x, z, 4, 4
    projected_through { sphere { <-0.7, -4, 0.3>, 0.6 } }
    translate <0, 6, -0.5>
}
light_source { <1, 6, -0.5>, rgb <1, 0.5, 0> spotlight point_at <0.5, -1, 0> projected_through { plane { x, 0.9 } } }
sphere { <-0.7, -0.7, 0>, 0.3 pigment { rgb <0, 0.8, 1> } }
