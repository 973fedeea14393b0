#version 3.7;
#declare F = function (x, y, z) { x*x + y*y + z*z - 1 }
#declare G = function (a) { select(a - 0.5, sin(a), cos(a)) + sum(i, 1, 3, pow(a, i)) + max(a, 0.1) }
isosurface { function { F(x, y*2, z) + 0.1*sin(5*x) } threshold 0 max_gradient 6 contained_by { box { -1.5, 1.5 } } }
sphere { <G(0.2), F(1, 0, 0), 0>, 1 pigment { function { abs(sin(x*3)) } color_map { [0 rgb 0] [1 rgb 1] } } }
parametric { function { u }, function { v }, function { u*v } <0, 0>, <1, 1> contained_by { box { -2, 2 } } precompute 4 x, y, z }
