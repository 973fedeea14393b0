#version 3.7;
box { -1, 1 } cone { 0, 1, y, 0.2 open } cylinder { 0, z, 0.5 } torus { 1, 0.25 sturm } plane { y, -1 }
blob { threshold 0.5 sphere { 0, 1, 1 } cylinder { 0, x, 0.5, -0.7 } }
superellipsoid { <0.3, 0.5> } ovus { 1, 0.6 } disc { 0, y, 1, 0.2 }
prism { linear_sweep linear_spline 0, 1, 5 <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> }
lathe { quadratic_spline 4 <0, 0>, <1, 0.5>, <0.5, 1>, <0, 1.5> }
sor { 4, <0.5, -0.5>, <0.6, 0>, <0.3, 0.5>, <0.2, 1> }
sphere_sweep { b_spline 4, <0, 0, 0>, 0.2 <1, 0, 0>, 0.3 <1, 1, 0>, 0.2 <2, 1, 0>, 0.1 }
quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1 } quartic { <1,0,0,0,2,0,0,2,0,-10.4,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,10.4,0,0,0,0,1,0,-10.4,0,22.1> }
polygon { 4, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 0, 0> } smooth_triangle { 0, y, x, y, z, y }
bicubic_patch { type 1 flatness 0.1 u_steps 2 v_steps 2 <0,0,0>, <1,0,0>, <2,0,0>, <3,0,0>, <0,1,0>, <1,1,1>, <2,1,1>, <3,1,0>, <0,2,0>, <1,2,1>, <2,2,1>, <3,2,0>, <0,3,0>, <1,3,0>, <2,3,0>, <3,3,0> }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 5 precision 20 }
