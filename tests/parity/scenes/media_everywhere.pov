// SPDX-License-Identifier: Apache-2.0
// A medium that is everywhere, parted by what a spot and a cylinder light of it, dims one light on its way and isn't in
// what isn't hollow; the eye is in a second one; exact shapes hold a third, of a stirred pattern.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 1.5, -5> look_at <0, 0.4, 0> angle 50 }
light_source { <-1, 4, 1> rgb 3 spotlight point_at <-0.6, -1, 0> radius 10 falloff 18 }
light_source { <1.4, 4, 0> rgb <1, 1.5, 2> cylinder point_at <1.4, -1, 0> radius 0.4 falloff 0.6 media_attenuation on }
light_source { <3, 6, -6> rgb 0.5 media_interaction off }
plane { y, -1 hollow pigment { rgb 0.8 } }
plane { -z, -6 hollow pigment { rgb <0.4, 0.5, 0.7> } }
box { <-0.5, 0.6, -0.4>, <0.1, 0.9, 0.2> pigment { rgb <0.9, 0.3, 0.1> } }
sphere { <0, 1.5, -5>, 1.5 hollow pigment { rgbt 1 } interior { media { absorption <0.2, 0.1, 0.05> } } }
difference {
    cylinder { <0, -0.9, 0>, <0, 0.3, 0>, 0.7 }
    sphere { <0, 0.4, 0>, 0.4 }
    hollow pigment { rgbt 1 }
    interior {
        media {
            emission <0.3, 0.6, 0.3> absorption 0.4 samples 3 aa_level 2
            density { bozo turbulence 0.4 octaves 1 scale 0.4 color_map { [0.3 rgb 0] [0.8 rgb 2] } }
        }
    }
    translate <-1.3, 0, 0.3>
}
torus { 0.5, 0.2 pigment { rgbt <1, 1, 1, 0.85> } interior { ior 1.2 } translate <0.9, -0.5, -0.6> }
media { scattering { 2, 0.07 extinction 0.6 } emission 0.01 samples 3 aa_level 2 }
