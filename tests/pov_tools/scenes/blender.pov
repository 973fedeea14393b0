// SPDX-License-Identifier: Apache-2.0
// In the way of Blender's POV add-on: every datum declared by its name, lights and camera by transforms, srgb colours.
#version 3.7;
//--Global settings--

global_settings {
    assumed_gamma 1.0
    max_trace_level 5
}

background { srgbt <0.35,0.38,0.42,0> }

//--Cameras--

camera {
    location  <0,0,0>
    look_at  <0,0,-1>
    right <-1.333333, 0, 0>
    up <0, 1, 0>
    angle  49.134343
    rotate  <63.559, 0.000, 46.692>
    translate <7.3589, -6.9258, 4.9583>
}

//--Lamps--

light_source {
    < 0,0,0 >
    color srgb<1.0, 0.95, 0.9>*0.5
    fade_distance 30.000
    fade_power 2
    rotate  <37.261, 3.164, 106.936>
    translate <4.0762, 1.0055, 5.9039>
}
light_source {
    < 0,0,0 >
    color rgb<0.4, 0.45, 0.5>
    parallel
    point_at  <0, 0, -1>
    rotate  <30, 20, 0>
    translate <-3, -5, 6>
}

//--Material Definitions--

#declare Default_texture = texture{pigment {color srgb 0.8} finish {ambient 0 diffuse 0.8}}

// Default pigment and finish
#default{ pigment{ color srgbft<0.8,0.8,0.8,0,0> } finish{ ambient 0 diffuse 0.8 } }

#declare shader_Material_001 = finish {
    ambient 0.0
    diffuse albedo 0.8
    specular albedo 0.25
    roughness 0.02
    brilliance 1.2
}
#declare MAT_Mirror = texture{
    pigment {rgbft<0.25, 0.28, 0.3, 0, 0>}
    finish {ambient 0 diffuse 0.4 reflection {rgb<0.5, 0.5, 0.5>} conserve_energy}
}

//--Mesh objects--

#declare DATACube =
mesh2 {
    vertex_vectors {
        8,
        <1.000000, 1.000000, -1.000000>,<1.000000, -1.000000, -1.000000>,<-1.000000, -1.000000, -1.000000>,<-1.000000, 1.000000, -1.000000>,<1.000000, 0.999999, 1.000000>,<0.999999, -1.000001, 1.000000>,<-1.000000, -1.000000, 1.000000>,<-1.000000, 1.000000, 1.000000>
    }
    texture_list {
        2
        texture {
            pigment {srgbft<0.800000, 0.250000, 0.200000, 0.00, 0.00>}
            finish {shader_Material_001}
        }
        texture {
            pigment {srgbft<0.200000, 0.450000, 0.800000, 0.00, 0.00>}
            finish {shader_Material_001}
        }
    }
    face_indices {
        12,
        <0,1,2>, 0, <0,2,3>, 0, <4,7,6>, 1, <4,6,5>, 1, <0,4,5>, 0, <0,5,1>, 0, <1,5,6>, 0, <1,6,2>, 0, <2,6,7>, 0, <2,7,3>, 0, <4,0,3>, 0, <4,3,7>, 0
    }
}
//----Blender Object Name:Cube----
object {
    DATACube
    interior {
    }
    matrix <1.000000, 0.000000, 0.000000, 0.000000, 1.000000, 0.000000, 0.000000, 0.000000, 1.000000, 0.000000, 0.000000, 0.200000>
}
//----Blender Object Name:Sphere----
sphere { 0,1
    texture { MAT_Mirror }
    matrix <0.900000, 0.000000, 0.000000, 0.000000, 0.900000, 0.000000, 0.000000, 0.000000, 0.900000, 1.000000, 2.600000, 0.000000>
}
plane { <0, 0, 1>, -1
    texture { Default_texture }
}
