#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 adc_bailout 0.01 ambient_light rgb 0.5 radiosity { count 20 } photons { spacing 0.1 } }
camera { perspective location <0, 2, -5> look_at 0 angle 40 right x*4/3 aperture 0.2 blur_samples 4 focal_point 0 }
light_source { <5, 5, -5> rgb 1 area_light 2*x, 2*y, 3, 3 adaptive 1 jitter circular orient fade_distance 5 fade_power 2 }
light_source { 5*y rgb 1 spotlight point_at 0 radius 10 falloff 20 tightness 3 looks_like { sphere { 0, 0.1 } } }
light_source { x*9 color rgb <1, 1, 0.5> parallel point_at 0 shadowless } light_source { z rgb 1 cylinder radius 1 falloff 2 point_at 0 }
background { rgb <0.1, 0.2, 0.3> } fog { fog_type 2 distance 10 rgb 0.7 fog_offset 1 fog_alt 2 } sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb z] } } }
rainbow { angle 40 width 5 distance 100 direction z color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.9>] } }
media { absorption 0.1 } light_group { light_source { 0 rgb 1 } sphere { 0, 1 } global_lights off }
