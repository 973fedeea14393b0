// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> look_at 0 angle 40 }
light_source { <200, 200, -100>, rgb 1 }
#default { pigment { rgb 1 } normal { bump_size 1.5 } finish { phong 0.8 phong_size 200 } }
box { <0.1, -2.5, 0>, <3, -0.1, 1> normal { gradient x triangle_wave scale 0.3 } }
box { <0.1, 0.1, 0>, <3, 2.5, 1> normal { gradient x normal_map { [0.3 gradient y triangle_wave] [0.7 gradient x 0.4] } } }
#default { normal { gradient y 0.7 sine_wave frequency 3 rotate 20*z } }
box { <-3, 0.1, 0>, <-0.1, 2.5, 1> normal { gradient x } }
#default { normal { bump_size 1.2 } }
box { <-3, -2.5, 0>, <-0.1, -0.1, 1> }
