// SPDX-License-Identifier: Apache-2.0
#include "compile/lights.h"

#include <algorithm>
#include <cmath>

#include "compile/convert.h"
#include "compile/photon_targets.h"

namespace sundog {
namespace {

std::uint32_t kind_of(scene::Light::Kind kind) {
    switch (kind) {
        case scene::Light::Kind::lamp:
            return kernel::LIGHT_LAMP;
        case scene::Light::Kind::sun:
            return kernel::LIGHT_SUN;
        case scene::Light::Kind::spotlight:
            return kernel::LIGHT_SPOT;
        case scene::Light::Kind::cylinder:
            return kernel::LIGHT_CYLINDER;
    }
    return kernel::LIGHT_LAMP;
}

void set_area(const scene::LightArea& area, kernel::Light& out) {
    out.area_u = to_kernel(area.axis1);
    out.area_v = to_kernel(area.axis2);
    out.area_count_u = static_cast<std::uint32_t>(std::max(area.size1, 1));
    out.area_count_v = static_cast<std::uint32_t>(std::max(area.size2, 1));
    // POV-Ray's adaptive 0 starts from an area's four corners, and each level more halves the distance.
    out.area_probes = area.adaptive >= 0 ? (1U << std::min(area.adaptive, 8)) + 1 : 0;
    if (area.circular) out.flags |= kernel::LIGHT_CIRCULAR;
    if (area.orient) out.flags |= kernel::LIGHT_ORIENT;
    if (area.jitter) out.flags |= kernel::LIGHT_JITTER;
    if (area.illuminates) out.flags |= kernel::LIGHT_ILLUMINATES;
}

}  // namespace

kernel::Light light_at(const scene::Light& written, float time_s) {
    const scene::Light light = scene::placed_at(written, time_s);
    Vec3 place = light.place;
    if (light.kind == scene::Light::Kind::sun) {
        place = normalize(place);
        // A moving sun may pass through the origin, where it has no direction; straight above is as good as any.
        if (place == Vec3{}) place = {0, 0, 1};
    }
    kernel::Light out{};
    out.place = to_kernel(place);
    out.color = to_kernel(light.color);
    out.kind = kind_of(light.kind);
    out.flags = (light.shadows ? kernel::LIGHT_SHADOWS : 0U) | (light.highlights ? kernel::LIGHT_HIGHLIGHTS : 0U) |
                (light.media_attenuation && light.media_interaction ? kernel::LIGHT_ATTENUATED : 0U) |
                (light.media_interaction && light.shadows ? 0U : kernel::LIGHT_PASSES_MEDIA);
    out.flags |= photon_flags(light.photons);
    if (out.kind == kernel::LIGHT_SPOT || out.kind == kernel::LIGHT_CYLINDER) {
        const Vec3 axis = normalize(light.point_at - place);
        out.axis = to_kernel(axis == Vec3{} ? Vec3{0, 0, 1} : axis);
    }
    if (out.kind == kernel::LIGHT_SPOT) {
        out.bright = std::cos(radians(light.radius));
        out.dark = std::cos(radians(light.falloff));
    } else {
        out.bright = light.radius;
        out.dark = light.falloff;
    }
    out.tightness = light.tightness;
    out.fade_distance = light.fade_distance;
    out.fade_power = light.fade_power;
    out.area_count_u = out.area_count_v = 1;
    if (light.area) set_area(*light.area, out);
    out.group = light.group;
    // What a group keeps for its objects doesn't light the media around them.
    if (out.group != 0) out.flags |= kernel::LIGHT_PASSES_MEDIA;
    out.projection = light.projection > 0 ? kernel::RAY_PROJECTION << (light.projection - 1) : 0;
    return out;
}

}  // namespace sundog
