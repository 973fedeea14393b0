// SPDX-License-Identifier: Apache-2.0
#include "compile/lights.h"

#include <algorithm>
#include <cmath>

#include "compile/convert.h"
#include "kernel/lights/light.h"

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
}

}  // namespace

void append_lights(const scene::Light& light, float time_s, std::vector<kernel::Light>& out) {
    constexpr int kMostLights = 4096;
    const kernel::Light whole = light_at(light, time_s);
    const bool in_parts = light.area && light.area->illuminates && !light.area->orient &&
                          light.kind != scene::Light::Kind::sun &&
                          light.area->size1 <= kMostLights / std::max(light.area->size2, 1);
    if (!in_parts) {
        out.push_back(whole);
        return;
    }
    const std::uint32_t count_u = whole.area_count_u, count_v = whole.area_count_v;
    const float share = 1 / static_cast<float>(count_u * count_v);
    for (std::uint32_t u = 0; u < count_u; ++u) {
        for (std::uint32_t v = 0; v < count_v; ++v) {
            const kernel::real3 place =
                kernel::area_light_place(whole, kernel::place_in_row(u, count_u), kernel::place_in_row(v, count_v), {});
            kernel::Light part = whole;
            part.area_count_u = part.area_count_v = 1;
            part.place = {place.x, place.y, place.z};
            part.color = to_kernel(light.color * share);
            out.push_back(part);
        }
    }
}

kernel::Light light_at(const scene::Light& light, float time_s) {
    Vec3 place = scene::place_at(light, time_s);
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
    return out;
}

}  // namespace sundog
