// SPDX-License-Identifier: Apache-2.0
// Bump maps (Blinn 1978) and tangent-space normal maps on triangles.
#ifndef SUNDOG_KERNEL_MATERIALS_BUMP_H
#define SUNDOG_KERNEL_MATERIALS_BUMP_H

#include "kernel/materials/surface.h"
#include "kernel/patterns/texture.h"

KERNEL_BEGIN

/// World-space change of position per unit of u (dp_du) and v of a triangle, zero where its uvs are degenerate.
FN mask triangle_tangents(SCENE Surface s, OUT(real3) dp_du, OUT(real3) dp_dv) {
    word kind = FIELD(geometries, s.geometry, kind);
    mask is_triangle = kind == word(GEOMETRY_TRIANGLES);
    word triangle = valid_index(is_triangle, s.primitive);
    word a = FIELD(triangle_uvs, triangle, a);
    mask present = mask_and(is_triangle, a != word(NONE));
    real2 uv_a = GET(uvs, valid_index(present, a));
    real2 uv_1 = GET(uvs, valid_index(present, FIELD(triangle_uvs, triangle, b))) - uv_a;
    real2 uv_2 = GET(uvs, valid_index(present, FIELD(triangle_uvs, triangle, c))) - uv_a;
    real3 p_a = GET(positions, FIELD(triangles, triangle, p0));
    real3 e1 = GET(positions, FIELD(triangles, triangle, p1)) - p_a;
    real3 e2 = GET(positions, FIELD(triangles, triangle, p2)) - p_a;
    real determinant = uv_1.x * uv_2.y - uv_1.y * uv_2.x;
    mask usable = mask_and(present, abs(determinant) > real(1e-20f));
    real inverse = 1.0f / select(usable, determinant, real(1.0f));
    dp_du = (e1 * uv_2.y - e2 * uv_1.y) * inverse;
    dp_dv = (e2 * uv_1.x - e1 * uv_2.x) * inverse;
    word instance = FIELD(geometries, s.geometry, instance);
    mask moved = instance != word(NONE);
    if (any_lane(moved)) {
        word i = valid_index(moved, instance);
        real3 x = FIELD(instances, i, world_from_object_x);
        real3 y = FIELD(instances, i, world_from_object_y);
        real3 z = FIELD(instances, i, world_from_object_z);
        dp_du = select(moved, x * dp_du.x + y * dp_du.y + z * dp_du.z, dp_du);
        dp_dv = select(moved, x * dp_dv.x + y * dp_dv.y + z * dp_dv.z, dp_dv);
    }
    return usable;
}

/// A map's height: the channel that the material says, times its strength.
FN real bump_height(SCENE word texture, word flags, real2 uv) {
    real alpha;
    real3 color = texture_lookup(SCENE_ texture, flags, uv, alpha);
    return texture_channel(color, alpha, flags);
}

/// The shading normal after the material's bump or normal map.
FN real3 bumped_normal(SCENE Surface s) {
    real3 n = s.normal;
    real3 dp_du;
    real3 dp_dv;
    mask usable = triangle_tangents(SCENE_ s, dp_du, dp_dv);
    real du2 = max(dot(dp_du, dp_du), real(1e-30f));
    real dv2 = max(dot(dp_dv, dp_dv), real(1e-30f));

    word maps = FIELD(materials, s.material, maps);
    word bump = FIELD(material_maps, maps, bump.texture);
    mask bumps = mask_and(usable, bump != word(NONE));
    if (any_lane(bumps)) {
        word texture = valid_index(bumps, bump);
        word flags = FIELD(material_maps, maps, bump.flags);
        real2 scale = FIELD(material_maps, maps, bump.scale);
        real2 uv = s.uv * scale + FIELD(material_maps, maps, bump.offset);
        if (any_lane((flags & word(TEXTURE_TURNED)) != word(0u)))
            uv = turned_uv(flags, uv, s.uv, FIELD(material_maps, maps, bump.shear));
        real strength = FIELD(material_maps, maps, bump.strength);
        // Differences over one texel. Heights are in units of the texture's width on the surface, so that a map keeps
        // its slope when the model is scaled.
        real step_u = 1.0f / real_from_word(FIELD(textures, texture, width));
        real step_v = 1.0f / real_from_word(FIELD(textures, texture, height));
        real h = bump_height(SCENE_ texture, flags, uv);
        real slope_u = (bump_height(SCENE_ texture, flags, uv + real2(step_u, real(0.0f))) - h) * strength;
        real slope_v = (bump_height(SCENE_ texture, flags, uv + real2(real(0.0f), step_v)) - h) * strength;
        real3 tangent = dp_du * (1.0f / sqrt(du2));
        real3 bitangent = dp_dv * (1.0f / sqrt(dv2));
        real3 bumped = n - tangent * slope_u - bitangent * slope_v;
        n = select(bumps, normalize(bumped), n);
    }

    word map = FIELD(material_maps, maps, normal.texture);
    mask mapped = mask_and(usable, map != word(NONE));
    if (any_lane(mapped)) {
        word texture = valid_index(mapped, map);
        word flags = FIELD(material_maps, maps, normal.flags);
        real2 scale = FIELD(material_maps, maps, normal.scale);
        real2 uv = s.uv * scale + FIELD(material_maps, maps, normal.offset);
        if (any_lane((flags & word(TEXTURE_TURNED)) != word(0u)))
            uv = turned_uv(flags, uv, s.uv, FIELD(material_maps, maps, normal.shear));
        real alpha;
        real3 stored = texture_lookup(SCENE_ texture, flags, uv, alpha);
        real strength = FIELD(material_maps, maps, normal.strength);
        real x = (stored.x * 2.0f - 1.0f) * strength;
        real y = (stored.y * 2.0f - 1.0f) * strength;
        real z = stored.z * 2.0f - 1.0f;
        real3 tangent = dp_du * (1.0f / sqrt(du2));
        real3 bitangent = dp_dv * (1.0f / sqrt(dv2));
        real3 bent = tangent * x + bitangent * y + s.normal * max(z, real(0.01f));
        n = select(mapped, normalize(bent), n);
    }
    // Keep it on the viewer's side of the face.
    real under = dot(n, s.geometric_normal);
    real3 lifted = n - s.geometric_normal * (under - 0.01f);
    return select(under < real(0.01f), normalize(lifted), n);
}

KERNEL_END

#endif
