// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z direction z right 16*x up 12*y }
#macro Wall(X, Y, P)
  box { <X, Y, 0>, <X + 5.2, Y + 5.8, 1> pigment { P color_map { [0 rgb <1, 0.9, 0.2>] [0.5 rgb <0.7, 0.1, 0.1>] [1 rgb <0.1, 0.1, 0.4>] } }
    finish { ambient 1 diffuse 0 } }
#end
Wall(-8, 0.1, pigment { gradient x frequency 0.2 triangle_wave })
Wall(-2.6, 0.1, pigment { spiral1 3 frequency 0.15 ramp_wave phase 0.3 translate <0, 3, 0> })
Wall(2.8, 0.1, pigment { onion frequency 0.7 ramp_wave translate <5, 3, 0> })
Wall(-8, -5.9, pigment { radial frequency 2.5 rotate x*90 translate <-5, -3, 0> })
Wall(-2.6, -5.9, pigment { spiral2 2 frequency 0.4 triangle_wave translate <0, -3, 0> })
Wall(2.8, -5.9, pigment { wood frequency 0.4 sine_wave translate <5, -3, 0> })
