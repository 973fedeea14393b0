// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <4, 7, -8>, rgb 1 }
quartic { <0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0.04, 0, 0, 0, 0, 0.04>
  pigment { rgb <0.7, 0.3, 0.1> } rotate <30, 0, 180> }
background { rgb 0.1 }
