// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
box { -1, 1 pigment { rgbt 1 } hollow
      interior { media { emission 0.4 absorption 0.3 density { gradient x density_map { [0 rgb <1, 0, 0>] [1 rgb <0, 0.2, 1>] } }
                         density { cylindrical color_map { [0 rgb 0] [1 rgb 1] } } scale 2 } }
      rotate <20, 30, 0> scale <1, 0.8, 1.2> }
