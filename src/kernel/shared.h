// SPDX-License-Identifier: Apache-2.0
// Structs and constants that the host, the C++ kernel and the GLSL kernel share, byte for byte (scalar layout).
#ifndef SUNDOG_KERNEL_SHARED_H
#define SUNDOG_KERNEL_SHARED_H

#ifdef __cplusplus
#include "kernel/compat/types.h"
namespace sundog::kernel {
#define KERNEL_CONST constexpr
#else
#define KERNEL_CONST const
#endif

/// "No such thing" for any index.
KERNEL_CONST uint NONE = 0xffffffffu;

/// What a Geometry's primitives are.
KERNEL_CONST uint GEOMETRY_TRIANGLES = 0u;
KERNEL_CONST uint GEOMETRY_SPHERE = 1u;
KERNEL_CONST uint GEOMETRY_BOX = 2u;
KERNEL_CONST uint GEOMETRY_PLANE = 3u;
/// Exact shapes and CSG: the device finds them with code of its own; a hit's primitive is its material, u and v are its
/// texture coordinates, its normal is in world space.
KERNEL_CONST uint GEOMETRY_SOLID = 4u;

/// What a ray is for, as bits: a geometry may be seen by some of them only.
KERNEL_CONST uint RAY_CAMERA = 1u;     ///< From the eye, and on through what is transparent.
KERNEL_CONST uint RAY_REFLECTED = 2u;  ///< From a mirror.
KERNEL_CONST uint RAY_SHADOW = 4u;     ///< Towards a light.
KERNEL_CONST uint RAY_ALL = 7u;

KERNEL_CONST uint LIGHT_LAMP = 0u;
KERNEL_CONST uint LIGHT_SUN = 1u;

/// Material::flags.
KERNEL_CONST uint MATERIAL_PHONG = 1u;         ///< Highlight by Phong's mirrored ray; else Blinn's halfway vector.
KERNEL_CONST uint MATERIAL_FRESNEL = 2u;       ///< Dielectric Fresnel splits reflectance and transmittance.
KERNEL_CONST uint MATERIAL_CHECKER = 4u;       ///< Diffuse alternates with checker_other on UVs.
KERNEL_CONST uint MATERIAL_HIGHLIGHT = 8u;     ///< specular is not black.
KERNEL_CONST uint MATERIAL_TEXTURED = 16u;     ///< Any *_texture is set, or checker.
KERNEL_CONST uint MATERIAL_TRANSPARENT = 32u;  ///< transmittance is not black, or opacity_texture is set: never culled.

/// TextureInfo::flags.
KERNEL_CONST uint TEXTURE_SRGB = 1u;

/// TextureRef::flags: clamp, and the channel of scalar maps in bits 1..3 (0 r, 1 g, 2 b, 3 a, 4 luminance).
KERNEL_CONST uint TEXTURE_CLAMP = 1u;
KERNEL_CONST uint TEXTURE_CHANNEL_SHIFT = 1u;

/// FrameParams::features: what this scene and frame need; the rest costs nothing.
KERNEL_CONST uint FEATURE_SMOOTH = 1u;    ///< Some triangle has vertex normals.
KERNEL_CONST uint FEATURE_TEXTURES = 2u;  ///< Some material is textured (uvs are valid).
KERNEL_CONST uint FEATURE_SHADOWS = 4u;
KERNEL_CONST uint FEATURE_MIRRORS = 8u;       ///< Some material reflects.
KERNEL_CONST uint FEATURE_TRANSPARENT = 16u;  ///< Some material transmits.
KERNEL_CONST uint FEATURE_HIGHLIGHTS = 32u;
KERNEL_CONST uint FEATURE_ANALYTIC = 64u;    ///< Some sphere, box or plane.
KERNEL_CONST uint FEATURE_INSTANCES = 128u;  ///< Some geometry moves.
KERNEL_CONST uint FEATURE_CULL = 256u;       ///< Back faces of opaque materials are not there.
KERNEL_CONST uint FEATURE_BUMP = 512u;       ///< Some material has a bump or normal map.

/// Most surfaces at which a path may both reflect and refract before the weaker branch is dropped.
KERNEL_CONST uint MAX_BRANCHES = 16u;

/// Transparent surfaces that a shadow ray passes at most; what lies behind more of them is in shadow.
KERNEL_CONST uint MAX_SHADOW_SURFACES = 32u;

struct Triangle {
    uint p0, p1, p2;  ///< Indices into positions.
    uint material;
};

/// Per-corner indices into normals or uvs; NONE in `a` where the triangle has none.
struct TriangleCorners {
    uint a, b, c;
};

struct Sphere {
    vec3 center;
    float radius;
    uint material;
};

struct Plane {
    vec3 normal;   ///< Unit.
    float offset;  ///< dot(normal, p) = offset.
    uint material;
    uint geometry;  ///< Planes are found by a loop, not by a traversal: their Geometry's index.
};

struct Box {
    vec3 lower;
    vec3 upper;
    uint material;
};

/// One object: a run of primitives of one kind.
struct Geometry {
    uint kind;             ///< GEOMETRY_*
    uint first_primitive;  ///< Into triangles, spheres, boxes or planes.
    uint primitive_count;
    uint instance;  ///< Into instances; NONE where primitives are in world space.
};

/// World placement of a moving geometry in this frame. Columns and translation of affine maps.
struct Instance {
    vec3 world_from_object_x, world_from_object_y, world_from_object_z, world_from_object_t;
    vec3 object_from_world_x, object_from_world_y, object_from_world_z, object_from_world_t;
};

/// A use of a texture: uv' = uv*scale + offset.
struct TextureRef {
    uint texture;  ///< Into textures, or NONE.
    uint flags;
    vec2 scale;
    vec2 offset;
    float strength;
};

/// Where a texture's texels lie: rgba8 (0xAABBGGRR), row 0 at the top.
struct TextureInfo {
    uint first_texel;
    uint width, height;
    uint flags;
};

/// A surface for Whitted tracing, all colours linear RGB. Weights obey reflectance + transmittance <= 1 per channel.
struct Material {
    vec3 emission;
    vec3 ambient;  ///< Times FrameParams::ambient.
    vec3 diffuse;
    vec3 specular;  ///< Colour of the highlight.
    float shininess;
    vec3 reflectance;    ///< Mirror weight at normal incidence (times Fresnel when MATERIAL_FRESNEL).
    vec3 transmittance;  ///< Weight of the ray that passes through; 0 for opaque.
    float ior;           ///< Inside over outside; 1 passes straight.
    uint flags;
    vec3 checker_other;
    vec2 checker_cells;
    TextureRef diffuse_texture, specular_texture, emission_texture, opacity_texture, bump_texture, normal_texture;
};

struct Light {
    vec3 place;  ///< lamp: position; sun: unit direction towards it.
    vec3 color;  ///< No falloff with distance.
    uint kind;
    uint casts_shadows;
};

/// Pinhole: a ray through image point (x, y) in [0,1]^2 (y down) starts at eye, towards
/// center + right*(2x-1) + up*(1-2y).
struct Camera {
    vec3 eye;
    vec3 center;  ///< From the eye to the middle of the window.
    vec3 right;   ///< Half the window's width.
    vec3 up;      ///< Half the window's height.
};

/// What changes from frame to frame, one per picture.
struct FrameParams {
    Camera camera;
    vec3 ambient;
    vec3 sky;
    uint width, height;
    uint max_depth;    ///< Secondary rays on a path at most; 0: what the eye sees directly.
    float min_weight;  ///< A secondary ray of less weight (its largest channel) is not traced.
    float far_z;       ///< Far clip depth along the view axis; infinite for none.
    uint light_count;
    uint plane_count;
    uint features;  ///< FEATURE_* bits
    uint aovs;      ///< AOV_* bits wanted
    uint seed;
};

/// FrameParams::aovs, and Film's planes.
KERNEL_CONST uint AOV_DEPTH = 1u;   ///< Distance along the ray from the eye; infinite on a miss.
KERNEL_CONST uint AOV_NORMAL = 2u;  ///< World-space shading normal, towards the viewer.
KERNEL_CONST uint AOV_ALBEDO = 4u;  ///< Diffuse colour after textures.
KERNEL_CONST uint AOV_OBJECT = 8u;  ///< Geometry index (NONE on a miss), primitive and material.
KERNEL_CONST uint AOV_COST = 16u;   ///< Rays traced for the pixel.

#ifdef __cplusplus
}  // namespace sundog::kernel
#endif
#undef KERNEL_CONST
#endif
