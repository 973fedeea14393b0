// SPDX-License-Identifier: Apache-2.0
// Media in objects, by each phase function and method of sampling: one that scatters and absorbs around an opaque ball,
// shining ones of stirred patterns, clouds of voxels, two that overlap, and glass, which isn't hollow.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.6, -6> look_at <0, 0.3, 0> angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { rgb <0.7, 0.75, 0.8> } }
plane { -z, -7 hollow pigment { rgb <0.3, 0.4, 0.6> } }
#macro Ball(Place, Medium) sphere { 0, 0.62 hollow pigment { rgbt 1 } interior { media { Medium } } translate Place } #end
#declare Scattering = array[4] {
    media { scattering { 2, 0.7 } samples 4 },
    media { scattering { 3, 0.5 } samples 4 method 2 },
    media { scattering { 4, <0.9, 0.6, 0.3> } absorption <0, 0.1, 0.3> samples 5 },
    media { scattering { 5, 0.6 eccentricity 0.4 extinction 0.6 } samples 4 method 2 intervals 2 }
}
#for (I, 0, 3)
    Ball(<1.35 * I - 2.1, -0.35, -0.8>, Scattering[I])
#end
sphere { <-2.1, -0.35, -0.8>, 0.25 pigment { rgb <0.9, 0.3, 0.2> } }
box {
    <-1.1, 0.5, 0>, <0.3, 1.9, 1.4> hollow pigment { rgbt 1 }
    interior {
        media {
            emission <0.9, 0.5, 0.2> absorption 0.3 samples 8
            density { spherical scale 0.75 turbulence 0.5 octaves 3 color_map { [0 rgb 0] [1 rgb 1.5] } translate <-0.4, 1.2, 0.7> }
        }
    }
}
box {
    <0, 0, 0>, <1, 1, 1> hollow pigment { rgbt 1 }
    interior {
        media { emission 0.4 absorption 0.5 density { density_file df3 "cloud.df3" interpolate 1 } samples 6 aa_level 4 }
        media { scattering { 1, 0.8 } density { density_file df3 "cloud.df3" interpolate 2 } }
    }
    scale 1.3 translate <0.6, 0.5, 0.2>
}
#declare Red = interior { media { absorption <0.2, 0.9, 0.9> } }
sphere { <-2.1, 1.2, 0.5>, 0.6 pigment { rgbt 1 } hollow interior { Red } }
box { <-2.3, 1, 0>, <-1.4, 1.5, 1> pigment { rgbt 1 } hollow interior { media { absorption <0.9, 0.4, 0> } } }
sphere { <-1.9, 1.6, 0.2>, 0.3 pigment { rgbt <1, 1, 1, 0.9> } interior { ior 1.3 } }
