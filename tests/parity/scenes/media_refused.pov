// SPDX-License-Identifier: Apache-2.0
// A density that only the CPU computes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 }
sphere {
    0, 1 hollow pigment { rgbt 1 }
    interior { media { emission 1
        density { object { sphere { 0, 0.5 } rgb 0, rgb 1 } } } }
}
