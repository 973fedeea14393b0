#version 3.7;
difference { box { -1, 1 } sphere { 0, 1.2 inverse } cylinder { -2*y, 2*y, 0.4 } pigment { rgb 1 } }
intersection { sphere { 0, 1 } plane { y, 0 } box { -0.5, 0.5 rotate 45*y } bounded_by { sphere { 0, 2 } } }
merge { sphere { 0, 1 } sphere { x, 1 } hollow no_shadow }
union { sphere { 0, 1 } union { box { 0, 1 } } split_union off clipped_by { plane { x, 0.5 } } matrix <1, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 3> }
