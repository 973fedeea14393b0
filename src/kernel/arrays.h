// SPDX-License-Identifier: Apache-2.0
// Every array that the kernel reads, declared once. Include with KERNEL_ARRAY(type, name, binding) defined; the C++
// side makes vectors and pointers of it, the GLSL side storage buffers. No array is ever empty: one zeroed element
// stands in. No include guard: it is meant to be included several times.

// Of the RenderScene: fixed once compiled. (positions carries one spare element at its end, for 16-byte loads.)
KERNEL_ARRAY(vec3, positions, 0)
KERNEL_ARRAY(vec3, normals, 1)
KERNEL_ARRAY(vec2, uvs, 2)
KERNEL_ARRAY(Triangle, triangles, 3)
KERNEL_ARRAY(TriangleCorners, triangle_normals, 4)  // parallel to triangles when FEATURE_SMOOTH
KERNEL_ARRAY(TriangleCorners, triangle_uvs, 5)      // parallel to triangles when FEATURE_TEXTURES
KERNEL_ARRAY(Sphere, spheres, 6)
KERNEL_ARRAY(Box, boxes, 7)
KERNEL_ARRAY(Plane, planes, 8)
KERNEL_ARRAY(Geometry, geometries, 9)
KERNEL_ARRAY(Material, materials, 10)
KERNEL_ARRAY(TextureInfo, textures, 11)
KERNEL_ARRAY(uint, texels, 12)
// What 8-bit sRGB stands for, 256 values; where there are bsdfs, their tables (BSDF_TABLES_FIRST); the environment's
// picture, three a pixel (ENVIRONMENT_FIRST), and the cells by which it is drawn (Environment::first_cell).
KERNEL_ARRAY(float, tables, 13)
KERNEL_ARRAY(PatternedMaterial, patterned, 16)
KERNEL_ARRAY(Layer, layers, 17)
KERNEL_ARRAY(uint, code, 18)
KERNEL_ARRAY(Fog, fogs, 19)
KERNEL_ARRAY(SkyLayer, sky_layers, 20)
KERNEL_ARRAY(Interior, interiors, 21)
KERNEL_ARRAY(MaterialMaps, material_maps, 22)
KERNEL_ARRAY(Bsdf, bsdfs, 23)
KERNEL_ARRAY(BsdfMaps, bsdf_maps, 24)

// Of the Frame: new for every picture.
#ifndef KERNEL_ARRAYS_SCENE_ONLY
KERNEL_ARRAY(Light, lights, 14)
KERNEL_ARRAY(Instance, instances, 15)
KERNEL_ARRAY(Emitter, emitters, 25)
#endif
