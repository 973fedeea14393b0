#version 3.7;
#declare T = texture { pigment { gradient x color_map { [0 rgb <1, 0, 0>] [0.5 color red 0.2 filter 0.5] [1 rgbt <0, 0, 1, 0.5>] } turbulence 0.2 triangle_wave frequency 3 } finish { ambient 0.2 diffuse 0.6 phong 1 specular 0.4 reflection { 0.1, 0.6 fresnel } conserve_energy } normal { bumps 0.3 scale 0.1 } }
sphere { 0, 1 texture { T scale 2 } texture { pigment { checker rgbt 1, rgbt <0, 0, 0, 0.7> } } interior { ior 1.5 fade_distance 1 fade_power 2 } }
box { 0, 1 pigment { brick rgb 1, rgb 0 brick_size <3, 1, 2> mortar 0.2 } }
plane { y, -1 texture { pigment { hexagon rgb x, rgb y, rgb z warp { repeat x flip y } } } }
cylinder { 0, y, 1 pigment { gradient y pigment_map { [0 granite] [1 wood color_map { [0 rgb 0][1 rgb 1] } ] } } }
torus { 1, 0.3 texture { cells texture_map { [0 T] [1 pigment { average pigment_map { [1 rgb x] [2 rgb y] } } ] } } }
