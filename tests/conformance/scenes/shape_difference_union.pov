// SPDX-License-Identifier: Apache-2.0
// What is cut away by a union: its inner surfaces aren't there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 4, -6> look_at 0 angle 40 }
light_source { <5, 10, -10> 1 }
plane { y, -1 pigment { rgb 0.6 } }
difference {
    box { -1, 1 pigment { rgb <0.9, 0.8, 0.2> } }
    union {
        cylinder { -2*x, 2*x, 0.6 }
        cylinder { -2*y, 2*y, 0.6 }
        sphere { <0, 0.2, -1>, 0.8 }
        pigment { rgb <0.2, 0.9, 0.3> }
    }
}
