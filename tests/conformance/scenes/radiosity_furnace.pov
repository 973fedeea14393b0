// Inside a ball each bounce adds its share; before version 3.7 ambient light counts beside radiosity.
#version 3.6;
global_settings { assumed_gamma 1 ambient_light 2 radiosity { recursion_limit 4 brightness 0.8 gray_threshold 0.4 } }
camera { location <0, 0, -2> look_at <0, 0, 0> }
sphere { 0, 3 hollow pigment { rgb <0.9, 0.5, 0.2> } finish { ambient 0.1 diffuse 0.8 brilliance 2 } }
