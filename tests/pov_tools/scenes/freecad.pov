// SPDX-License-Identifier: Apache-2.0
// In the way of FreeCAD's Raytracing and Render workbenches: a template, a view, parts as meshes with smooth normals.
#version 3.6;
#include "colors.inc"
#include "metals.inc"
#include "finish.inc"

global_settings { assumed_gamma 1.0 ambient_light rgb<1,1,1> }

// View of the document
#declare cam_location =  <60.00,45.00,-70.00>;
#declare cam_look_at  = <0.00,8.00,0.00>;
#declare cam_sky      = <0.00,1.00,0.00>;
#declare cam_angle    = 45; 
camera {
  location  cam_location
  look_at   cam_look_at
  sky       cam_sky
  angle     cam_angle 
  right x*image_width/image_height
}
#default{ finish { ambient 0.1 diffuse 0.9 } }

light_source {
  cam_location
  color rgb <0.5, 0.5, 0.5>
}
light_source { <-80, 150, -60> color White }

sky_sphere {
	pigment {
		gradient y
		color_map {
			[0.0  color LightGray]
			[0.3  color White]
			[0.7  color LightGray]
		}
	}
}
plane {
	y, -0.1
	pigment { checker color rgb <0.75,0.75,0.72>, color rgb <0.6,0.62,0.65> scale 20 }
	finish { reflection 0.1 }
}

// Written by FreeCAD http://www.freecadweb.org/
#declare Box001_Face1 = mesh2{
  vertex_vectors {
    4,
    <-20.0,0.0,-10.0>,
    <20.0,0.0,-10.0>,
    <20.0,12.0,-10.0>,
    <-20.0,12.0,-10.0>
  }
  normal_vectors {
    4,
    <0.0,0.0,-1.0>,
    <0.0,0.0,-1.0>,
    <0.0,0.0,-1.0>,
    <0.0,0.0,-1.0>
  }
  face_indices {
    2,
    <0,1,2>,
    <0,2,3>
  }
} // end of Face1
#declare Box001_Face2 = mesh2{
  vertex_vectors {
    4,
    <20.0,0.0,-10.0>,
    <20.0,0.0,10.0>,
    <20.0,12.0,10.0>,
    <20.0,12.0,-10.0>
  }
  face_indices {
    2,
    <0,1,2>,
    <0,2,3>
  }
} // end of Face2
#declare Box001_Face3 = mesh2{
  vertex_vectors {
    4,
    <-20.0,12.0,-10.0>,
    <20.0,12.0,-10.0>,
    <20.0,12.0,10.0>,
    <-20.0,12.0,10.0>,
  }
  face_indices {
    2,
    <0,1,2>,
    <0,2,3>,
  }
} // end of Face3
#declare Box001 = union {
mesh2 { Box001_Face1 }
mesh2 { Box001_Face2 }
mesh2 { Box001_Face3 }
}
// instance to render
object {Box001
  texture {
      pigment {
        color rgb <0.80,0.35,0.20>
      }
      finish {
        phong 0.4 phong_size 20
      }
  }
}
#declare Cylinder = cylinder { <0,12,0>, <0,28,0>, 7 }
object { Cylinder
  texture { pigment { color rgbt <0.30,0.45,0.80,0.25> } finish { specular 0.5 roughness 0.02 } }
}
