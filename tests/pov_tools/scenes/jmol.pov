// SPDX-License-Identifier: Apache-2.0
// In the way of Jmol's "write povray": screen coordinates, one letter macros, ellipsoids as quadrics.
#declare Width = 320;
#declare Height = 240;
#declare minScreenDimension = 240;
#declare showAtoms = true;
#declare showBonds = true;
#declare noShadows = true;
camera{
  orthographic
  location < 160.0, 120.0, 0>

  // Negative right for a right handed coordinate system.

  sky < 0, -1, 0>
  right < -320.0, 0, 0>
  up < 0, 240.0, 0 >
  look_at < 160.0, 120.0, 1000 >
}
background { color rgb <0.87,0.87,0.92> }

light_source { <-960.0,-960.0, -1440.0>  rgb <0.60,0.60,0.60> }
#default { finish {
  ambient 0.45
  diffuse 0.84
  specular 0.22
  roughness .00001
  metallic
  phong 0.9
  phong_size 120
}}

#macro check_shadow()
 #if (noShadows)
  no_shadow 
 #end
#end
#declare slabZ = 0;
#declare depthZ = 2147483647;
#declare dzSlab = 10;
#declare dzDepth = dzSlab;
#declare dzStep = 0.001;
#macro clip()
  clipped_by { box {<0,0,slabZ>,<Width,Height,depthZ>} }
#end
#macro translucentFinish(T)
 #local shineFactor = T;
 #if (T < 0.25)
  #declare shineFactor = 1.0;
 #end
 #if (T > 0.25)
  #declare shineFactor = 0.25;
 #end
 finish {
  ambient 0.45
  diffuse 0.84
  specular 0.22
  roughness .00001
  metallic shineFactor
  phong 0.9*shineFactor
  phong_size 120*shineFactor
}#end
#macro a(X,Y,Z,RADIUS,R,G,B,T)
 sphere{<X,Y,Z>,RADIUS
  pigment{rgbt<R,G,B,T>}
  translucentFinish(T)
  clip()
  check_shadow()}
#end
#macro q(XX,YY,ZZ,XY,XZ,YZ,X,Y,Z,J,R,G,B,T)
 quadric{<XX,YY,ZZ>,<XY,XZ,YZ>,<X,Y,Z>,J
  pigment{rgbt<R,G,B,T>}
  translucentFinish(T)
  clip()
  check_shadow()}
#end
#macro b(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2
  pigment{rgbt<R,G,B,T>}
  translucentFinish(T)
  clip()
  check_shadow()}
#end
#macro c(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2 open
  pigment{rgbt<R,G,B,T>}
  translucentFinish(T)
  clip()
  check_shadow()}
#end
#macro r(X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3,R,G,B,T)
 triangle{<X1,Y1,Z1>,<X2,Y2,Z2>,<X3,Y3,Z3>
  pigment{rgbt<R,G,B,T>}
  translucentFinish(T)
  clip()
  check_shadow()}
#end

a(100.0,90.0,900.0,38.0,0.56,0.56,0.56,0.0)
a(205.0,120.0,860.0,34.0,1.0,0.05,0.05,0.0)
a(150.0,185.0,880.0,24.0,0.19,0.31,0.97,0.5)
b(100.0,90.0,900.0,8.0,152.0,105.0,880.0,8.0,0.56,0.56,0.56,0.0)
c(152.0,105.0,880.0,8.0,205.0,120.0,860.0,8.0,1.0,0.05,0.05,0.0)
b(100.0,90.0,900.0,6.0,150.0,185.0,880.0,6.0,0.9,0.9,0.9,0.0)
// x^2/35^2 + y^2/20^2 + z^2/20^2 = 1 about <265, 60, 900>
q(0.000816327,0.0025,0.0025,0.0,0.0,0.0,-0.432653,-0.3,-4.5,2090.3265,0.2,0.8,0.4,0.0)
r(235.0,175.0,900.0,300.0,165.0,880.0,270.0,225.0,910.0,0.9,0.6,0.1,0.0)
