// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -6> look_at 0 angle 45 }
light_source { <3, 6, -4>, rgb 1 }
background { rgb 0.3 }
difference { sphere { 0, 1.2 } disc { <0, 0.3, 0>, y, 0.8 } translate -1.2*x pigment { rgb x } }
merge { sphere { 0, 0.8 } disc { <0, 0.3, 0>, y, 1 } translate 1.2*x pigment { rgbt <0, 1, 0, 0.5> } }
