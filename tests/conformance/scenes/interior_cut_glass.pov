// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 40 }
light_source { <5, 10, -5>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.3 pigment { checker rgb 1, rgb <0.2, 0.5, 0.2> } finish { ambient 0.3 } }
difference {
  box { -1, 1 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
  sphere { 0, 0.8 pigment { rgbt <0.9, 0.9, 0.6, 0.6> } finish { reflection 0.3 } }
  no_shadow
  rotate 30*y
}
