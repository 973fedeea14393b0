// SPDX-License-Identifier: Apache-2.0
// In the way of VMD's POV3 renderer: its shapes as macros, clipping switched off, a mesh with a list of textures.
#version 3.6 
#if (version < 3.5) 
#error "This scene needs POV-Ray 3.5 or above."
#end 
#declare VMD_clip_on=array[3] {0, 0, 0};
#declare VMD_clip=array[3];
#declare VMD_scaledclip=array[3];
#declare VMD_line_width=0.0200;
#macro VMDC ( C1 )
  texture { pigment { rgbt C1 }}
#end
#macro VMD_point (P1, R1, C1)
  #local T = texture { finish { ambient 1.0 diffuse 0.0 phong 0.0 specular 0.0 } pigment { C1 } }
  #if(VMD_clip_on[2])
  intersection {
    sphere {P1, R1 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
    VMD_clip[2]
  }
  #else
  sphere {P1, R1 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
  #end
#end
#macro VMD_line (P1, P2, C1)
  #local T = texture { finish { ambient 1.0 diffuse 0.0 phong 0.0 specular 0.0 } pigment { C1 } }
  cylinder {P1, P2, VMD_line_width texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
#end
#macro VMD_sphere (P1, R1, C1)
  #local T = texture { pigment { C1 } }
  sphere {P1, R1 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
#end
#macro VMD_cylinder (P1, P2, R1, C1, O1)
  #local T = texture { pigment { C1 } }
  cylinder {P1, P2, R1 #if(O1) open #end texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
#end
#macro VMD_cone (P1, P2, R1, C1)
  #local T = texture { pigment { C1 } }
  cone {P1, R1, P2, VMD_line_width texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
#end
#macro VMD_triangle (P1, P2, P3, N1, N2, N3, C1)
  #local T = texture { pigment { C1 } }
  smooth_triangle {P1, N1, P2, N2, P3, N3 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
#end
camera {
  perspective
  location <0.0000, 0.0000, -2.0000>
  look_at <-0.0000, -0.0000, 2.0000>
  up <0.0000, 1.5000, 0.0000>
  right <2.0000, 0.0000, 0.0000>
}
light_source { 
  <-0.1000, 0.1000, -1.0000> 
  color rgb<1.000, 1.000, 1.000> 
  parallel 
  point_at <0.0, 0.0, 0.0> 
}
light_source { 
  <1.0000, 2.0000, -0.5000> 
  color rgb<0.700, 0.700, 0.700> 
  parallel 
  point_at <0.0, 0.0, 0.0> 
}
background {
  color rgb<0.150, 0.200, 0.350>
}
#default { texture {
 finish { ambient 0.000 diffuse 0.650 phong 0.1 phong_size 38.905 specular 0.500 }
} }
#declare VMD_line_width=0.0300;
// MoleculeID: 0 ReprID: 0 Beginning VDW
VMD_sphere(<-0.6000,0.2000,0.4000>,0.3500,rgbt<0.250,0.750,0.750,0.000>)
VMD_sphere(<0.0000,-0.3000,0.1000>,0.2500,rgbt<1.000,0.000,0.000,0.000>)
VMD_cylinder(<-0.60000000,0.20000000,0.40000000>,<0.00000000,-0.30000000,0.10000000>,0.0800,rgbt<0.500,0.500,0.500,0.000>,1)
VMD_cone(<0.50000000,-0.70000000,0.30000000>,<0.90000000,0.10000000,0.30000000>,0.2000,rgbt<0.900,0.600,0.100,0.000>)
VMD_line(<-1.2000,-0.9000,0.0000>,<1.2000,-0.9000,0.0000>,rgbt<1.000,1.000,1.000,0.000>)
VMD_point(<1.1000,0.7000,0.0000>,0.0600,rgbt<1.000,1.000,0.000,0.000>)
VMD_triangle(<-1.2000,0.3000,0.6000>,<-0.9000,0.9000,0.5000>,<-1.3500,0.8000,0.7000>,<0.3,0.1,-0.95>,<0.1,0.2,-0.97>,<-0.1,0.3,-0.95>,rgbt<0.300,0.900,0.300,0.000>)
mesh2 {
  vertex_vectors {
  6,
  <0.1000,0.2000,0.5000>,<0.7000,0.2500,0.4000>,<0.4000,0.7500,0.6000>,<0.9500,0.7000,0.5000>,<0.7000,1.0500,0.7000>,<0.1500,0.9500,0.6500>
  }
  normal_vectors {
  6,
  <-0.20,-0.10,-0.97>,<0.20,-0.20,-0.95>,<0.00,0.10,-0.99>,<0.35,0.10,-0.92>,<0.20,0.30,-0.93>,<-0.30,0.25,-0.92>
  }
  texture_list {
  3,
VMDC(<0.80,0.20,0.20,0.00>)VMDC(<0.20,0.80,0.20,0.00>)VMDC(<0.20,0.30,0.90,0.30>)
  }
  face_indices {
  4,
  <0,1,2>,0,0,0,<1,3,2>,1,1,1,<2,3,4>,2,2,2,<0,2,5>,0,1,2
  }
  inside_vector <0, 0, 1>
  no_shadow
}
// End of POV-Ray 3.x generation 
