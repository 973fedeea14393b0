// SPDX-License-Identifier: Apache-2.0
// Media in objects, by four phase functions and two methods of sampling: around an opaque ball, of a stirred pattern
// and of voxels, two that overlap, and glass, which isn't hollow, in the way. Few samples: Mesa's software driver lets
// no ray go through more than 65,535 rounds of loops.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 1.6, -6> look_at <0, 0.3, 0> angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { rgb <0.7, 0.75, 0.8> } }
plane { -z, -7 hollow pigment { rgb <0.3, 0.4, 0.6> } }
#macro Ball(X, Medium)
    sphere { <X, -0.35, -0.8>, 0.62 hollow pigment { rgbt 1 } interior { media { Medium samples 3 aa_level 2 } } }
#end
#declare Murky = media { scattering { 2, 0.7 } }
#declare Hazy = media { scattering { 3, 0.5 } method 2 }
#declare Blue = media { scattering { 4, <0.3, 0.6, 0.9> } absorption <0, 0.1, 0.3> }
#declare Ahead = media { scattering { 5, 0.6 eccentricity 0.4 extinction 0.6 } method 2 intervals 2 }
Ball(-2.1, Murky)
Ball(-0.75, Hazy)
Ball(0.6, Blue)
Ball(1.95, Ahead)
sphere { <-2.1, -0.35, -0.8>, 0.25 pigment { rgb <0.9, 0.3, 0.2> } }
box {
    <-1.1, 0.5, 0>, <0.3, 1.9, 1.4> hollow pigment { rgbt 1 }
    interior {
        media {
            emission <0.9, 0.5, 0.2> absorption 0.3 samples 4 aa_level 2
            density {
                spherical turbulence 0.5 octaves 2 scale 0.75 translate <-0.4, 1.2, 0.7>
                color_map { [0 rgb 0] [1 rgb 1.5] }
            }
        }
    }
}
box {
    0, 1 hollow pigment { rgbt 1 }
    interior {
        media {
            emission 0.4 absorption 0.5 samples 5 aa_level 2
            density { density_file df3 "cloud.df3" interpolate 1 }
        }
    }
    scale 1.3 translate <0.6, 0.5, 0.2>
}
#declare Red = interior { media { absorption <0.2, 0.9, 0.9> } }
sphere { <-2.1, 1.2, 0.5>, 0.6 pigment { rgbt 1 } hollow interior { Red } }
box { <-2.3, 1, 0>, <-1.4, 1.5, 1> pigment { rgbt 1 } hollow interior { media { absorption <0.9, 0.4, 0> } } }
sphere { <-1.9, 1.6, 0.2>, 0.3 pigment { rgbt <1, 1, 1, 0.9> } interior { ior 1.3 } }
