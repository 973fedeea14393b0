// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace sundog::import::gltf {
namespace {

constexpr float kDegrees = 180 / kPi;

scene::NodeMotion motion_of(const NodeGraph& graph, scene::Index node) { return {graph.tree, node, {}}; }

/// A width that goes with the usual height, for a picture as wide as the camera says.
void propose_size(float aspect, scene::Settings& settings) {
    constexpr float kHeight = 480;
    constexpr float kMostWidth = 4800;
    settings.height = static_cast<int>(kHeight);
    settings.width = static_cast<int>(std::lround(std::clamp(kHeight * aspect, 1.0F, kMostWidth)));
}

float positive(const Json& json, const char* name) {
    const Json value = json.required(name);
    const float number = value.number();
    if (!(number > 0)) value.fail("must be greater than 0");
    return number;
}

/// KHR_lights_punctual gives candela, and lux of directional lights. A white wall that faces a light of colour 1 is
/// seen with radiance 1 here: it gets an irradiance of pi.
scene::Light read_light(const Json& json) {
    scene::Light light;
    light.color =
        max(json.vec3_or("color", {1, 1, 1}), {0, 0, 0}) * (std::max(json.number_or("intensity", 1), 0.0F) / kPi);
    const Json type = json.required("type");
    if (type.string() == "directional") {
        light.kind = scene::Light::Kind::sun;
        light.place = {0, 0, 1};
        return light;
    }
    light.fade_power = 2;
    light.point_at = {0, 0, -1};
    if (type.string() == "point") return light;
    if (type.string() != "spot")
        type.fail("unknown type " + in_quotes(type.string()), "expected one of: directional, point, spot");
    light.kind = scene::Light::Kind::spotlight;
    const Json spot = json.required("spot");
    const float inner = spot.number_or("innerConeAngle", 0);
    const float outer = spot.number_or("outerConeAngle", kPi / 4);
    if (!(inner >= 0 && inner <= outer && outer <= kPi / 2 + 1e-4F))
        spot.fail("the inner angle must lie between 0 and the outer one, and that below pi/2");
    light.radius = inner * kDegrees;
    light.falloff = outer * kDegrees;
    return light;
}

}  // namespace

scene::ProjectionCamera read_camera(const Json& camera) {
    scene::ProjectionCamera out;
    out.where = camera.location();
    out.sky = {0, 0, 1};
    out.direction = {0, 0, -1};
    const Json type = camera.required("type");
    if (type.string() == "perspective") {
        const Json perspective = camera.required("perspective");
        const Json angle = perspective.required("yfov");
        const float half = angle.number() / 2;
        if (!(half > 0 && half < kPi / 2)) angle.fail("must be greater than 0 and below pi");
        const double height = 2 * std::tan(static_cast<double>(half));
        const float aspect = perspective.member("aspectRatio") ? positive(perspective, "aspectRatio") : 4.0F / 3;
        out.up = {0, height, 0};
        out.right = {height * aspect, 0, 0};
        out.fits_picture = true;
    } else if (type.string() == "orthographic") {
        const Json orthographic = camera.required("orthographic");
        out.kind = scene::ProjectionCamera::Kind::orthographic;
        out.right = {2 * std::abs(static_cast<double>(orthographic.required("xmag").number())), 0, 0};
        out.up = {0, 2 * std::abs(static_cast<double>(orthographic.required("ymag").number())), 0};
        if (!(length(out.right) > 0 && length(out.up) > 0)) orthographic.fail("xmag and ymag must not be 0");
    } else {
        type.fail("unknown type " + in_quotes(type.string()), "expected one of: perspective, orthographic");
    }
    return out;
}

void read_camera_of(Asset& asset, const NodeGraph& graph) {
    for (scene::Index node = 0; node < graph.shown_count; ++node) {
        const auto index = graph.json(asset, node).index_or_none("camera", asset.list("cameras").size(), "cameras");
        if (!index) continue;
        scene::ProjectionCamera camera = read_camera(asset.list("cameras")[*index]);
        const float volume = std::abs(determinant(graph.world_from_node[node]));
        if (!(volume > 1e-30F) || !std::isfinite(volume) || !is_finite(graph.world_from_node[node].t)) {
            asset.warn_once("camera", graph.json(asset, node),
                            "the camera's node is scaled to nothing, or out of the world");
            continue;
        }
        propose_size(static_cast<float>(length(camera.right) / length(camera.up)), asset.scene().settings);
        camera.motion = motion_of(graph, node);
        asset.scene().projection_camera = graph.moves[node] ? camera : scene::placed_at(camera, 0);
        return;
    }
}

void read_lights(Asset& asset, const NodeGraph& graph) {
    const Json extension = asset.root().extension("KHR_lights_punctual");
    if (!extension) return;
    const Json lights = extension.required("lights");
    const std::vector<SourceLocation> places = lights.element_locations();
    for (scene::Index node = 0; node < graph.shown_count; ++node) {
        const Json use = graph.json(asset, node).extension("KHR_lights_punctual");
        if (!use) continue;
        const std::size_t index = use.required_index("light", lights.size(), "extensions.KHR_lights_punctual.lights");
        scene::Light light = read_light(lights[index]);
        light.where = places[index];
        light.motion = motion_of(graph, node);
        const scene::Light placed = scene::placed_at(light, 0);
        if (!is_finite(placed.place) || !is_finite(placed.point_at))
            use.fail("the node's place takes the light beyond single precision");
        asset.scene().lights.push_back(graph.moves[node] ? light : placed);
    }
}

}  // namespace sundog::import::gltf
