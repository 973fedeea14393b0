// What gathering rays see: not what is no_radiosity, but what is no_image or no_reflection; no fog.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { recursion_limit 1 } }
background { rgb 0.6 }
fog { distance 60 rgb <0.8, 0.4, 0.2> }
camera { location <0, 3, -7> look_at <0, 0.8, 0> angle 50 }
plane { y, 0 pigment { checker rgb 1 rgb <0.2, 0.8, 0.4> } finish { diffuse 0.8 ambient 1 } }
sphere { 0, 50 hollow no_radiosity pigment { rgb 0 } }
sphere { 0, 100 hollow no_image no_reflection pigment { rgb 0 } finish { emission <0.9, 0.6, 0.7> diffuse 0 } }
