/* nested /* comment */ */ #version unofficial 3.7;
#default { texture { pigment { color rgb 0.5 } finish { ambient 0 } } }
#declare Cam = camera { orthographic location -5*z look_at 0 right 4*x up 3*y };
camera { Cam translate y }
#declare Tr = transform { rotate 30*y scale <1, 2, 1> translate x inverse }
sphere { <1, 2>*2, 0.5 transform { Tr } pigment { colour red 1 green 0.5 } }
object { #if (version > 3.5) box { -1, 1 } #else sphere { 0, 1 } #end rotate <10, 20, 30> }
#declare N = vnormalize(<1, 2, 3>); #declare K = vdot(N, vcross(x, y)) + vlength(N) + mod(7, 3) + int(2.7) + (N.x > 0 ? 1 : 2);
