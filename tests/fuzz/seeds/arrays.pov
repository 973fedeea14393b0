#version 3.7;
#declare P = array[3] { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
#declare M = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } }
#declare S = array[2] { "one", "two" };
#declare M[1][2] = M[0][0] + dimension_size(M, 2) + dimensions(M);
triangle { P[0], P[1], P[2] }
#declare Sp = spline { cubic_spline -0.5, <0, 0, 0> 0, <1, 0, 0> 0.5, <1, 1, 0> 1, <0, 1, 1> 1.5, <0, 0, 0> }
sphere { Sp(0.3), 0.2 }
#debug concat(S[0], substr(S[1], 1, 2), strupr("x"), chr(65), str(asc("B"), 0, 0), str(val("2.5"), 0, 1))
