// SPDX-License-Identifier: Apache-2.0
// Normals bent by waves of several lengths around ten places, on many tiles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 20*x up 15*y }
light_source { <-60, 80, -100>, rgb 1 parallel point_at 0 }
#for (I, 0, 299)
    #local Corner = <mod(I, 20) - 10, div(I, 20) - 7.5, 0>;
    box { Corner, Corner + <1, 1, 1> pigment { rgb 0.7 } normal { waves 0.5 scale 0.6 frequency 3 translate <7.3*I, -5.7*I, 3.1*I> rotate 77*I*z } }
#end
