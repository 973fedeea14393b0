// SPDX-License-Identifier: Apache-2.0
// Patterns and warps that the CPU asks the host for: crackle's forms, slopes, quilts, repeats, black holes and mappings,
// one a tile.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y direction z look_at 0 }
light_source { <20, 30, -50> rgb 1 }
background { rgb 0.2 }
#declare Colours = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.4 rgb <0.9, 0.6, 0.2>] [1 rgb <0.9, 1, 0.9>] }
#macro Tile(Column, Row, Pigment)
    box { <-0.96, -0.96, 0>, <0.96, 0.96, 0.1> pigment { Pigment } finish { ambient 0.3 } translate <2 * Column - 3, 2 * Row - 2, 0> }
#end
#declare Bricks = pigment { brick rgb 0.9, rgb <0.6, 0.2, 0.1> brick_size <0.4, 0.2, 0.3> mortar 0.04 }
Tile(0, 0, pigment { crackle form <0.7, 0.3, -0.4> metric 3 offset 0.1 color_map { Colours } scale 0.4 })
Tile(1, 0, pigment { crackle solid metric 1 color_map { Colours } scale 0.3 translate 0.1 })
Tile(2, 0, pigment { quilted control0 0.3 control1 0.8 color_map { Colours } scale 0.4 translate <0.1, 0.2, 0.15> })
Tile(3, 0, pigment { gradient x color_map { Colours } warp { repeat 0.5 * x flip x offset <0, 0.2, 0> } rotate 20 * z })
Tile(0, 1, pigment { Bricks warp { black_hole <0.1, 0.1, 0>, 0.8 falloff 2 strength 2 } })
Tile(1, 1, pigment { Bricks warp { black_hole 0, 0.2 repeat <0.6, 0.6, 0.6> turbulence <0.1, 0.1, 0> inverse } translate -0.25 * z })
Tile(2, 1, pigment { Bricks warp { spherical dist_exp 0.5 } rotate 30 * x translate <0.1, 0.1, -0.4> })
Tile(3, 1, pigment { Bricks warp { toroidal orientation y major_radius 0.5 } rotate 70 * x translate <0.1, 0.1, 0.3> })
Tile(0, 2, pigment { Bricks warp { cylindrical orientation <1, 1, 0> } rotate 60 * x translate <0.1, 0.1, 0.4> })
Tile(1, 2, pigment { Bricks warp { planar <1, 1, 0>, 0.3 } warp { cubic } scale 2 translate <0.1, 0.2, 0.3> })
sphere { <1, 2, 0>, 0.9 pigment { slope { y, 0.2, 0.9 } color_map { Colours } } }
sphere { <3, 2, 0>, 0.9 pigment { aoi pigment_map { [0.5 rgb <0.9, 0.2, 0.2>] [0.7 slope { <-1, 1, 0> altitude y } color_map { Colours }] [1 rgb 0.9] } } }
