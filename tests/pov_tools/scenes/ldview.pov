// SPDX-License-Identifier: Apache-2.0
// In the way of LDView's POV export: parts declared once, quality by #if, camera from the view matrix, LDraw's Y down.
#version 3.6;
#declare LDXQual = 3;
#declare LDXSW = 0.5;
#declare LDXStuds = 1;
#declare LDXFloor = 1;
#declare LDXAmb = 0.4;
#declare LDXDif = 0.4;
#declare LDXRefl = 0.08;
#ifndef (LDXGrout)
#declare LDXGrout = 0.1;
#end
#declare LDXCamAspect = image_width/image_height;
global_settings { assumed_gamma 1.4 max_trace_level 12 adc_bailout 0.05 }

#macro LDXSeamMatrix(Width, Height, Depth, CenterX, CenterY, CenterZ)
#local aw = 0;
#local ah = 0;
#local ad = 0;
#if (Width != 0) #local aw = 1 - LDXSW/Width; #end
#if (Height != 0) #local ah = 1 - LDXSW/Height; #end
#if (Depth != 0) #local ad = 1 - LDXSW/Depth; #end
matrix <aw,0,0,0,ah,0,0,0,ad,CenterX*(1-aw),CenterY*(1-ah),CenterZ*(1-ad)>
#end

#if (LDXQual > 1)
#declare LDXOpaqueFinish = finish { ambient LDXAmb diffuse LDXDif phong 0.3 phong_size 20 reflection LDXRefl }
#else
#declare LDXOpaqueFinish = finish { ambient LDXAmb diffuse LDXDif }
#end
#declare LDXColor4 = material { texture { pigment { rgbf <0.788235,0.101961,0.035294,0> } finish { LDXOpaqueFinish } } }
#declare LDXColor14 = material { texture { pigment { rgbf <0.949020,0.803922,0.215686,0> } finish { LDXOpaqueFinish } } }
#declare LDXColor1 = material { texture { pigment { rgbf <0.117647,0.352941,0.658824,0> } finish { LDXOpaqueFinish } } }

#declare _stud_dot_dat =
#if (LDXStuds)
union {
	cylinder { <0,0,0>, <0,-4,0>, 6 open }
	disc { <0,-4,0>, <0,-1,0>, 6 }
}
#else
sphere { <0,0,0>, 0.01 }
#end
#declare _box5_dot_dat = box { <-1,0,-1>, <1,1,1> }
#declare _3003_dot_dat = union {
	object { _box5_dot_dat matrix <20,0,0,0,24,0,0,0,20,0,0,0> }
	object { _stud_dot_dat matrix <1,0,0,0,1,0,0,0,1,10,0,10> }
	object { _stud_dot_dat matrix <1,0,0,0,1,0,0,0,1,-10,0,10> }
	object { _stud_dot_dat matrix <1,0,0,0,1,0,0,0,1,10,0,-10> }
	object { _stud_dot_dat matrix <1,0,0,0,1,0,0,0,1,-10,0,-10> }
}
#declare _slope_dot_dat = mesh2 {
	vertex_vectors { 6, <-20,0,-20>,<20,0,-20>,<-20,24,-20>,<20,24,-20>,<-20,24,30>,<20,24,30> }
	face_indices { 8, <0,1,3>,<0,3,2>,<0,4,5>,<0,5,1>,<0,2,4>,<1,5,3>,<2,3,5>,<2,5,4> }
}
#declare model_dot_ldr = union {
	object { _3003_dot_dat LDXSeamMatrix(40, 28, 40, 0, 10, 0) matrix <1,0,0,0,1,0,0,0,1,0,0,0> material { LDXColor4 } }
	object { _3003_dot_dat LDXSeamMatrix(40, 28, 40, 0, 10, 0) matrix <0,0,1,0,1,0,-1,0,0,10,-24,0> material { LDXColor14 } }
	object { _slope_dot_dat LDXSeamMatrix(40, 24, 50, 0, 12, 5) matrix <1,0,0,0,1,0,0,0,1,-45,0,0> material { LDXColor1 } }
}
object { model_dot_ldr }

#if (LDXFloor)
object { plane { y, 24 hollow } texture { pigment { color rgb <0.8,0.8,0.8> } finish { ambient 0.4 diffuse 0.4 } } }
#end
background { color rgb <0.9,0.95,1> }
light_source { <-120,-220,-60> color rgb <1,1,1> }
light_source { <140,-160,-180> color rgb <0.5,0.5,0.5> shadowless }
#declare LDXCamLoc = vaxis_rotate(<0,-90,-170>, <0,1,0>, 25);
camera {
	location LDXCamLoc
	sky <0,-1,0>
	right LDXCamAspect * < -1,0,0 >
	look_at < -10,0,0 >
	angle 40
}
