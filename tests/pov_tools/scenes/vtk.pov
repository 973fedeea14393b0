// SPDX-License-Identifier: Apache-2.0
// In the way of VTK's and ParaView's vtkPOVExporter: no version, trailing commas in lists, colours without rgb.
// +W300 +H300

global_settings {
	ambient_light color rgb <1.0, 1.0, 1.0>
	assumed_gamma 2
}

background { color rgb <0.320000, 0.340000, 0.430000>}

camera {
	perspective
	location <1.500000, 2.250000, 5.000000>
	sky <0.000000, 1.000000, 0.000000>
	right <-1, 0, 0>
	angle 30.000000
	look_at <0.100000, 0.000000, 0.000000>
}

light_source {
	<1.500000, 2.250000, 5.000000>
	color <1.000000, 1.000000, 1.000000>*1.000000
	parallel
	point_at <0.100000, 0.000000, 0.000000>
}

light_source {
	<-4.000000, 3.000000, 1.000000>
	color <0.900000, 0.700000, 0.500000>*0.500000
}

mesh2 {
	vertex_vectors {
		6,
		<0.000000, 1.000000, 0.000000>,
		<1.000000, 0.000000, 0.000000>,
		<0.000000, 0.000000, 1.000000>,
		<-1.000000, 0.000000, 0.000000>,
		<0.000000, 0.000000, -1.000000>,
		<0.000000, -1.000000, 0.000000>,
	}
	normal_vectors {
		6,
		<0.000000, 1.000000, 0.000000>,
		<1.000000, 0.000000, 0.000000>,
		<0.000000, 0.000000, 1.000000>,
		<-1.000000, 0.000000, 0.000000>,
		<0.000000, 0.000000, -1.000000>,
		<0.000000, -1.000000, 0.000000>,
	}
	texture_list {
		6,
		texture { pigment { color rgbf <0.9, 0.2, 0.2, 0.000000> } finish { ambient rgb 0.1 diffuse 0.7 phong 0.5 phong_size 30 } },
		texture { pigment { color rgbf <0.2, 0.9, 0.2, 0.000000> } finish { ambient rgb 0.1 diffuse 0.7 phong 0.5 phong_size 30 } },
		texture { pigment { color rgbf <0.2, 0.2, 0.9, 0.000000> } finish { ambient rgb 0.1 diffuse 0.7 phong 0.5 phong_size 30 } },
		texture { pigment { color rgbf <0.9, 0.9, 0.2, 0.000000> } finish { ambient rgb 0.1 diffuse 0.7 phong 0.5 phong_size 30 } },
		texture { pigment { color rgbf <0.2, 0.9, 0.9, 0.000000> } finish { ambient rgb 0.1 diffuse 0.7 phong 0.5 phong_size 30 } },
		texture { pigment { color rgbf <0.9, 0.9, 0.9, 0.000000> } finish { ambient rgb 0.1 diffuse 0.7 phong 0.5 phong_size 30 } },
	}
	face_indices {
		8,
		<0, 1, 2>, 0, 1, 2,
		<0, 2, 3>, 0, 2, 3,
		<0, 3, 4>, 0, 3, 4,
		<0, 4, 1>, 0, 4, 1,
		<5, 2, 1>, 5, 2, 1,
		<5, 3, 2>, 5, 3, 2,
		<5, 4, 3>, 5, 4, 3,
		<5, 1, 4>, 5, 1, 4,
	}
	matrix < 0.800000, 0.000000, 0.000000,
		 0.000000, 0.800000, 0.000000,
		 0.000000, 0.000000, 0.800000,
		 -0.500000, 0.100000, 0.000000 >
}

mesh2 {
	vertex_vectors {
		4,
		<-1.500000, -1.000000, 1.500000>,
		<1.500000, -1.000000, 1.500000>,
		<1.500000, -1.000000, -1.500000>,
		<-1.500000, -1.000000, -1.500000>,
	}
	face_indices {
		2,
		<0, 1, 2>,
		<0, 2, 3>,
	}
	texture {
		pigment {
			color rgbf <0.700000, 0.720000, 0.750000 0.000000>
		}
		finish {
			ambient rgb <0.000000, 0.000000, 0.000000> diffuse 0.900000 phong 0.000000 phong_size 1.000000 
		}
	}
}
