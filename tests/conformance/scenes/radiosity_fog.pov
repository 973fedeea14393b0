// SPDX-License-Identifier: Apache-2.0
// Radiosity whose rays see the fog that they pass through.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { recursion_limit 1 count 400 media on } }
camera { location <0, 3, -7> look_at <0, 0.8, 0> angle 50 }
fog { distance 40 rgb <0.8, 0.4, 0.2> }
sphere { 0, 60 hollow pigment { rgb <0.3, 0.5, 0.9> } finish { emission 1 diffuse 0 } }
plane { y, 0 pigment { checker rgb 1 rgb <0.2, 0.8, 0.4> } finish { diffuse 0.8 } }
