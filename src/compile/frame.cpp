// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "compile/compile.h"
#include "compile/convert.h"

namespace sundog {
namespace {

constexpr int kDefaultWidth = 640;
constexpr int kDefaultHeight = 480;
constexpr int kDefaultMaxDepth = 5;
constexpr float kDefaultMinWeight = 0.01F;
constexpr float kNoFarClip = std::numeric_limits<float>::infinity();

template <class T>
T choose(const std::optional<T>& option, const std::optional<T>& setting, T fallback) {
    return option ? *option : setting.value_or(fallback);
}

kernel::Light light_at(const scene::Light& light, float time_s) {
    Vec3 place = scene::place_at(light, time_s);
    const bool sun = light.kind == scene::Light::Kind::sun;
    if (sun) {
        place = normalize(place);
        // A moving sun may pass through the origin, where it has no direction; straight above is as good as any.
        if (place == Vec3{}) place = {0, 0, 1};
    }
    return {to_kernel(place), to_kernel(light.color), sun ? kernel::LIGHT_SUN : kernel::LIGHT_LAMP,
            light.shadows ? 1U : 0U};
}

kernel::Instance instance_of(const Affine3& world_from_object) {
    const Affine3 object_from_world = inverse(world_from_object);
    return {to_kernel(world_from_object.x), to_kernel(world_from_object.y), to_kernel(world_from_object.z),
            to_kernel(world_from_object.t), to_kernel(object_from_world.x), to_kernel(object_from_world.y),
            to_kernel(object_from_world.z), to_kernel(object_from_world.t)};
}

std::vector<kernel::Instance> instances_at(const scene::Scene& scene, const RenderScene& compiled, float time_s) {
    std::vector<kernel::Instance> instances;
    for (std::size_t i = 0; i < compiled.geometry_objects.size(); ++i) {
        const std::uint32_t instance = compiled.geometries[i].instance;
        if (instance == kernel::NONE) continue;
        if (instances.size() <= instance) instances.resize(instance + 1);
        instances[instance] =
            instance_of(scene::transform_at(*scene.objects[compiled.geometry_objects[i]].motion, time_s));
    }
    if (instances.empty()) instances.resize(1);
    return instances;
}

std::uint32_t plane_count_of(const RenderScene& compiled) {
    std::uint32_t planes = 0;
    for (const kernel::Geometry& g : compiled.geometries)
        if (g.kind == kernel::GEOMETRY_PLANE) planes += g.primitive_count;
    return planes;
}

}  // namespace

kernel::Camera camera_at(const scene::OrbitCamera& camera, float time_s, float aspect) {
    const Affine3 turn = rotation({0, 0, 1}, scene::value_at(camera.rot_z_deg, time_s)) *
                         rotation({1, 0, 0}, scene::value_at(camera.rot_x_deg, time_s));
    kernel::Camera out{};
    out.eye = to_kernel(camera.origin + transform_vector(turn, {0, -camera.distance, 0}));
    out.center = to_kernel(transform_vector(turn, {0, camera.focus / 12, 0}));
    out.right = to_kernel(transform_vector(turn, {aspect, 0, 0}));
    out.up = to_kernel(transform_vector(turn, {0, 0, 1}));
    return out;
}

Frame make_frame(const scene::Scene& scene, const RenderScene& compiled, const FrameOptions& options) {
    const scene::Settings& settings = scene.settings;
    const float time_s = settings.freeze_s.value_or(options.time_s);

    Frame frame;
    kernel::FrameParams& params = frame.params;
    params.width = static_cast<std::uint32_t>(choose(options.width, settings.width, kDefaultWidth));
    params.height = static_cast<std::uint32_t>(choose(options.height, settings.height, kDefaultHeight));
    params.camera = options.camera ? *options.camera
                                   : camera_at(scene.camera, time_s,
                                               static_cast<float>(params.width) / static_cast<float>(params.height));
    params.ambient = to_kernel(scene.ambient);
    params.sky = to_kernel(scene.sky);
    params.max_depth = static_cast<std::uint32_t>(choose(options.max_depth, settings.max_depth, kDefaultMaxDepth));
    params.min_weight = choose(options.min_weight, settings.min_weight, kDefaultMinWeight);
    params.far_z = choose(options.far_z, settings.far_z, kNoFarClip);
    params.plane_count = plane_count_of(compiled);
    params.aovs = options.aovs;

    bool some_light_casts_shadows = false;
    for (const scene::Light& light : scene.lights) {
        frame.lights.push_back(light_at(light, time_s));
        some_light_casts_shadows = some_light_casts_shadows || light.shadows;
    }
    params.light_count = static_cast<std::uint32_t>(frame.lights.size());
    if (frame.lights.empty()) frame.lights.resize(1);
    frame.instances = instances_at(scene, compiled, time_s);

    params.features = compiled.features;
    if (choose(options.shadows, settings.shadows, true) && some_light_casts_shadows)
        params.features |= kernel::FEATURE_SHADOWS;
    if (settings.cull_backfaces) params.features |= kernel::FEATURE_CULL;
    return frame;
}

}  // namespace sundog
