// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Turn = transform { rotate 25*y translate 0.4*x }
#declare Both = transform { transform Turn scale <1, 1.3, 1> transform { Turn inverse } }
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> transform Turn }
light_source { <4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
box { -0.6, 0.6 pigment { checker rgb <0.9, 0.5, 0.1>, rgb 0.9 scale 0.4 transform Both } transform Turn }
#default { finish { ambient 0.5 } }
sphere { <1.4, 0, 0>, 0.7 pigment { rgb <0.2, 0.4, 0.9> } transform { Both } }
