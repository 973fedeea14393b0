// SPDX-License-Identifier: Apache-2.0
// In the way of OpenSCAD's export to .pov: faces as polygons, Z up, a camera that looks at the bounding box.
#version 3.7;
#include "rad_def.inc"
global_settings {
  assumed_gamma 1.0
  photons { count 20000 autostop 0 jitter .4 }
}
#declare MATERIAL=finish { ambient 0.1 diffuse 0.6 specular 0.2 roughness 0.02 };
#declare MATERIAL_INT=interior { ior 1.32 };
union { 
polygon { 5, <0, 0, 0>, <20, 0, 0>, <20, 0, 10>, <0, 0, 10>, <0, 0, 0> 
texture { pigment { color rgbf <0.976471, 0.843137, 0.172549, 0> } }
}
polygon { 5, <20, 0, 0>, <20, 15, 0>, <20, 15, 10>, <20, 0, 10>, <20, 0, 0> 
texture { pigment { color rgbf <0.976471, 0.843137, 0.172549, 0> } }
}
polygon { 5, <20, 15, 0>, <0, 15, 0>, <0, 15, 10>, <20, 15, 10>, <20, 15, 0> 
texture { pigment { color rgbf <0.976471, 0.843137, 0.172549, 0> } }
}
polygon { 5, <0, 15, 0>, <0, 0, 0>, <0, 0, 10>, <0, 15, 10>, <0, 15, 0> 
texture { pigment { color rgbf <0.976471, 0.843137, 0.172549, 0> } }
}
polygon { 10, <0, 0, 10>, <20, 0, 10>, <20, 15, 10>, <0, 15, 10>, <0, 0, 10>, <6, 4, 10>, <14, 4, 10>, <14, 11, 10>, <6, 11, 10>, <6, 4, 10> 
texture { pigment { color rgbf <0.611765, 0.796078, 0.368627, 0> } }
}
polygon { 4, <6, 4, 10>, <14, 4, 10>, <10, 7.5, 16>, <6, 4, 10> 
texture { pigment { color rgbf <0.4, 0.6, 0.9, 0> } }
}
polygon { 4, <14, 4, 10>, <14, 11, 10>, <10, 7.5, 16>, <14, 4, 10> 
texture { pigment { color rgbf <0.4, 0.6, 0.9, 0> } }
}
finish { MATERIAL } interior { MATERIAL_INT }
 }
light_source { <-20, -40, 60>, 0.8 }
light_source { <60, -30, 40>, 0.5 }
camera { look_at <10, 7.5, 5> location <-18, -38, 42> 
up <0, 0, 1> right <-1.33333, 0, 0> sky <0, 0, 1> angle 40
}
background { rgb <1, 1, 0.898039> }
