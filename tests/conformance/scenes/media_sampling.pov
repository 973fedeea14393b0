// SPDX-License-Identifier: Apache-2.0
// Method 2 beside method 3 of several levels, intervals and thresholds, before a light that all of them dim.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 45 }
light_source { <10, 20, -10> 1 }
plane { y, -1 pigment { rgb 0.8 } }
plane { z, 8 hollow pigment { rgb <0.5, 0.6, 0.9> } }
#declare Rings = density { onion scale 0.35 sine_wave color_map { [0 rgb 0] [1 rgb <1, 0.6, 0.2>] } }
#declare Glow = media { emission 0.5 absorption 0.7 density { Rings } }
#macro Ball(Place, Medium)
    sphere { 0, 0.7 hollow pigment { rgbt 1 } interior { media { Medium } } translate Place }
#end
#declare One = media { Glow method 2 samples 6 intervals 2 }
Ball(<-1.6, 0.7, 0>, One)
#declare One = media { Glow samples 3 aa_level 1 }
Ball(<0, 0.7, 0>, One)
#declare One = media { Glow samples 20 aa_level 5 aa_threshold 0.01 }
Ball(<1.6, 0.7, 0>, One)
#declare One = media { Glow samples 4 intervals 3 aa_threshold 1 }
Ball(<-0.8, -0.3, -0.6>, One)
#declare One = media { Glow samples 10 }
Ball(<0.8, -0.3, -0.6>, One)
