// SPDX-License-Identifier: Apache-2.0
// In the way of Wings 3D's export: meshes with uv coordinates and a list of textures, then objects, lights and camera.
// Exported from Wings 3D

#version 3.7;
#include "rad_def.inc"
global_settings{
	assumed_gamma 1.0
	max_trace_level 5
	ambient_light rgb <1.0, 1.0, 1.0>
}

#declare camera_location = <4.200000, 3.400000, 5.000000>;
camera{
	perspective
	location camera_location
	right (image_width / image_height) * x
	up y
	angle 45.0000
	sky <0.0, 1.0, 0.0>
	look_at <0.000000, 0.200000, 0.000000>
	// wings uses a right handed system
	scale <-1, 1, 1> scale <-1, 1, 1>
}

background { rgb <0.400000, 0.500000, 0.600000> }

#declare Light_light1 = light_source{
	<3.000000, 6.000000, 4.000000>
	color rgb <1.000000, 1.000000, 1.000000> * 0.9
	fade_distance 20 fade_power 1
}
object{ Light_light1 }
light_source{ <-5.000000, 2.000000, 3.000000> color rgb <0.3, 0.35, 0.5> spotlight point_at <0, 0, 0> radius 20 falloff 40 tightness 2 }

#declare w3d_default = texture{
	pigment{ color rgbf <0.789854, 0.813333, 0.694044, 0.0> }
	finish{ ambient rgb <0.1, 0.1, 0.1> diffuse 0.7 specular 0.3 roughness 0.02 }
}
#declare w3d_checks = texture{
	uv_mapping
	pigment{ checker color rgb <0.85, 0.2, 0.15>, color rgb <0.95, 0.9, 0.8> scale 0.25 }
	finish{ ambient rgb <0.1, 0.1, 0.1> diffuse 0.7 }
}

#declare wo_cube1 = mesh2{
	vertex_vectors{ 8,
		<-1.0, -1.0, 1.0>, <-1.0, 1.0, 1.0>, <1.0, 1.0, 1.0>, <1.0, -1.0, 1.0>,
		<-1.0, -1.0, -1.0>, <-1.0, 1.0, -1.0>, <1.0, 1.0, -1.0>, <1.0, -1.0, -1.0>}
	uv_vectors{ 4, <0.0, 0.0>, <1.0, 0.0>, <1.0, 1.0>, <0.0, 1.0>}
	texture_list{ 2, texture{w3d_default}, texture{w3d_checks} }
	face_indices{ 10,
		<0, 3, 2>, 1, <0, 2, 1>, 1,
		<3, 7, 6>, 0, <3, 6, 2>, 0,
		<1, 2, 6>, 1, <1, 6, 5>, 1,
		<0, 4, 7>, 0, <0, 7, 3>, 0,
		<0, 1, 5>, 0, <0, 5, 4>, 0}
	uv_indices{ 10,
		<0, 1, 2>, <0, 2, 3>,
		<0, 1, 2>, <0, 2, 3>,
		<0, 1, 2>, <0, 2, 3>,
		<0, 1, 2>, <0, 2, 3>,
		<0, 1, 2>, <0, 2, 3>}
	inside_vector <0, 0, 1>
}
object{ wo_cube1
	hollow
	rotate <0, 20, 0>
}
#declare wo_ground = mesh2{
	vertex_vectors{ 4, <-4.0, -1.0, 4.0>, <4.0, -1.0, 4.0>, <4.0, -1.0, -4.0>, <-4.0, -1.0, -4.0>}
	normal_vectors{ 4, <0.0, 1.0, 0.0>, <0.0, 1.0, 0.0>, <0.0, 1.0, 0.0>, <0.0, 1.0, 0.0>}
	face_indices{ 2, <0, 1, 2>, <0, 2, 3>}
	normal_indices{ 2, <0, 1, 2>, <0, 2, 3>}
	texture{ w3d_default }
}
object{ wo_ground }
