// SPDX-License-Identifier: Apache-2.0
// In the way of ASE: an atoms object through ase.io.pov, with cell, bonds and one constrained atom.
#version 3.6;
#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 2.2 max_trace_level 6}
background {color White}
camera {orthographic
  right -7.20*x up 5.40*y
  direction 50.00*z
  location <0,0,50.00> look_at <0,0,0>}

light_source {<  2.00,   3.00,  40.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 3, 3
  adaptive 1 jitter}
// no fog
#declare simple = finish {phong 0.7}
#declare pale = finish {ambient 0.5 diffuse 0.85 roughness 0.001 specular 0.200 }
#declare jmol = finish {ambient 0.2 diffuse 0.6 specular 1 roughness 0.001 metallic}
#declare ase2 = finish {ambient 0.2 brilliance 3 diffuse 0.6 metallic specular 0.7 roughness 0.04 reflection 0.15}
#declare Rcell = 0.050;
#declare Rbond = 0.120;

#macro atom(LOC, R, COL, TRANS, FIN)
  sphere{LOC, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union{torus{R, Rcell rotate 45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     torus{R, Rcell rotate -45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     translate LOC}
#end

cylinder {< -2.60,  -1.90,  -1.50>, <  2.60,  -1.90,  -1.50>, Rcell pigment {Black}}
cylinder {< -2.60,  -1.90,  -1.50>, < -2.60,   1.90,  -1.50>, Rcell pigment {Black}}
cylinder {<  2.60,  -1.90,  -1.50>, <  2.60,   1.90,  -1.50>, Rcell pigment {Black}}
cylinder {< -2.60,   1.90,  -1.50>, <  2.60,   1.90,  -1.50>, Rcell pigment {Black}}
atom(< -1.35,   0.10,  -0.20>, 0.82, rgb <0.78, 0.50, 0.20>, 0.0, ase2) // #0
atom(<  0.00,  -0.85,   0.10>, 0.62, rgb <1.00, 0.05, 0.05>, 0.0, simple) // #1
atom(<  1.45,   0.20,   0.00>, 0.88, rgb <0.56, 0.56, 0.56>, 0.0, jmol) // #2
atom(<  0.15,   1.05,   0.30>, 0.40, rgb <0.20, 0.40, 0.90>, 0.4, pale) // #3
cylinder {< -1.35,   0.10,  -0.20>, <  0.00,  -0.85,   0.10>, Rbond texture{pigment {color rgb <0.78, 0.50, 0.20> transmit 0.0} finish{simple}}}
cylinder {<  0.00,  -0.85,   0.10>, <  1.45,   0.20,   0.00>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{simple}}}
constrain(<  1.45,   0.20,   0.00>, 1.00, Black, 0.0 simple) // #2
