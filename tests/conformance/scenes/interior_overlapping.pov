// SPDX-License-Identifier: Apache-2.0
#version 3.7;
// Objects of one declared glass that reach into each other: each has an interior of its own, but for the parts of a
// union that has it.
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 1.2, -7> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.2 pigment { checker rgb 0.3 rgb 0.8 } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.9, 0.3, 0.2>] [1 rgb <0.9, 0.9, 0.5>] } scale 3 translate -1.5*y } }
#declare Glass = material { texture { pigment { rgbf <1, 1, 1, 1> } } interior { ior 1.4 } }
sphere { <-2.5, 0, 0>, 0.8 material { Glass } }
sphere { <-1.9, 0, 0.3>, 0.8 material { Glass } }
union { sphere { <-0.3, -0.2, 0>, 0.7 } sphere { <0.4, 0.2, 0>, 0.7 } material { Glass } }
#declare Bead = cone { -0.8*y, 0.9, 0.8*y, 0.4 material { Glass } }
object { Bead translate 2*x }
object { Bead rotate 180*x translate 2.7*x }
