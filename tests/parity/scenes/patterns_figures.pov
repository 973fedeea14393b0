// SPDX-License-Identifier: Apache-2.0
// Pavements, fractals, functions, and normals of quilts and facets, also behind warps, one a tile: what the CPU asks
// the host for.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y direction z look_at 0 }
light_source { <20, 30, -50> rgb 1 }
background { rgb 0.2 }
#declare Noise = function { internal(76) }
#declare Colours = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.4 rgb <0.9, 0.6, 0.2>] [1 rgb <0.9, 1, 0.9>] }
#macro Place(Column, Row) translate <2 * Column - 3, 2 * Row - 2, 0> #end
#macro Tile(Column, Row, Pigment)
    box { <-0.96, -0.96, 0>, <0.96, 0.96, 0.1> pigment { Pigment } finish { ambient 0.3 } Place(Column, Row) }
#end
#macro Ball(Column, Row, Normal)
    sphere { 0, 0.9 pigment { rgb <0.9, 0.7, 0.5> } normal { Normal } finish { phong 0.5 } Place(Column, Row) }
#end
Tile(0, 0, pigment { pavement number_of_sides 3 number_of_tiles 4 pattern 2 exterior 1 interior 1 form 1 color_map { Colours } rotate 90 * x scale 0.25 })
Tile(1, 0, pigment { pavement number_of_sides 4 number_of_tiles 4 pattern 3 exterior 2 interior 2 form 2 color_map { Colours } rotate 90 * x scale 0.25 })
Tile(2, 0, pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 2 color_map { Colours } rotate 90 * x scale 0.2 })
Tile(3, 0, pigment { function { sin(9 * x) * cos(7 * y) + min(abs(x), sqr(y)) } color_map { Colours } })
Tile(0, 1, pigment { mandel 25 exterior 1, 1 interior 1, 1 color_map { Colours } translate 0.5 * x })
Tile(1, 1, pigment { julia <0.353, 0.288>, 20 exponent 3 color_map { Colours } scale 0.8 })
Tile(2, 1, pigment { magnet 1 mandel 15 interior 1, 0.3 color_map { Colours } scale 0.5 translate -0.6 * x })
Tile(3, 1, pigment { function { mod(x * 3, 1) * select(y, 0.3, 0.7) + Noise(x * 4, y * 4, z) * 0.4 } color_map { Colours } })
Ball(0, 2, normal { quilted 0.7 control0 0.3 control1 0.8 scale 0.4 })
Ball(1, 2, normal { facets size 0.3 })
Ball(2, 2, normal { facets coords 0.5 scale 3 })
Ball(3, 2, normal { bumps 0.6 scale 0.2 warp { repeat 0.4 * x flip x } warp { turbulence 0.1 } })
