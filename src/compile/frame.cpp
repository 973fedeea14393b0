// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "compile/compile.h"
#include "compile/convert.h"
#include "compile/emitters.h"
#include "compile/insides_at.h"
#include "compile/lights.h"

namespace sundog {
namespace {

constexpr int kDefaultWidth = 640;
constexpr int kDefaultHeight = 480;
constexpr int kDefaultMaxDepth = 5;
constexpr int kPathsMaxDepth = 16;
constexpr float kDefaultMinWeight = 0.01F;
constexpr float kNoFarClip = std::numeric_limits<float>::infinity();

template <class T>
T choose(const std::optional<T>& option, const std::optional<T>& setting, T fallback) {
    return option ? *option : setting.value_or(fallback);
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
        instances[instance] = instance_of(scene::transform_at(scene.objects[compiled.geometry_objects[i]], time_s));
    }
    if (instances.empty()) instances.resize(1);
    return instances;
}

/// True where the eye might see the inside of a mesh that hides its inside.
bool eye_is_within_closed_mesh(const RenderScene& compiled, const Frame& frame) {
    // Cameras whose rays start elsewhere may be anywhere.
    const bool anywhere = frame.camera_rays != nullptr || frame.params.camera_kind != kernel::CAMERA_PERSPECTIVE;
    return std::any_of(compiled.closed_one_sided.begin(), compiled.closed_one_sided.end(), [&](const ClosedMesh& mesh) {
        const auto host = [](const kernel::vec3& v) { return Vec3{v.x, v.y, v.z}; };
        Vec3 eye = host(frame.params.camera.eye);
        if (const std::uint32_t instance = compiled.geometries[mesh.geometry].instance; instance != kernel::NONE) {
            const kernel::Instance& i = frame.instances[instance];
            eye = transform_point({host(i.object_from_world_x), host(i.object_from_world_y),
                                   host(i.object_from_world_z), host(i.object_from_world_t)},
                                  eye);
        }
        // A lens reaches a little beyond the eye.
        const Vec3 margin = Vec3{1, 1, 1} * (0.01F * length(mesh.bounds.extent()) + frame.params.lens_radius);
        const Vec3 lower = mesh.bounds.lower - margin, upper = mesh.bounds.upper + margin;
        return anywhere || (eye.x >= lower.x && eye.y >= lower.y && eye.z >= lower.z && eye.x <= upper.x &&
                            eye.y <= upper.y && eye.z <= upper.z);
    });
}

std::uint32_t plane_count_of(const RenderScene& compiled) {
    std::uint32_t planes = 0;
    for (const kernel::Geometry& g : compiled.geometries)
        if (g.kind == kernel::GEOMETRY_PLANE) planes += g.primitive_count;
    return planes;
}

std::uint32_t sky_layer_count(const scene::Scene& scene) {
    std::size_t count = 0;
    for (const scene::SkySphere& sky : scene.sky_spheres) count += sky.pigments.size();
    return static_cast<std::uint32_t>(count);
}

std::uint32_t kernel_camera_kind(const scene::ProjectionCamera& camera) {
    using Kind = scene::ProjectionCamera::Kind;
    switch (camera.kind) {
        case Kind::perspective:
            return kernel::CAMERA_PERSPECTIVE;
        case Kind::orthographic:
            return kernel::CAMERA_ORTHOGRAPHIC;
        case Kind::fisheye:
            return kernel::CAMERA_FISHEYE;
        case Kind::ultra_wide_angle:
            return kernel::CAMERA_ULTRA_WIDE_ANGLE;
        case Kind::omnimax:
            return kernel::CAMERA_OMNIMAX;
        case Kind::panoramic:
            return kernel::CAMERA_PANORAMIC;
        case Kind::cylinder:
            return kernel::CAMERA_CYLINDER + static_cast<std::uint32_t>(camera.cylinder_type - 1);
        case Kind::spherical:
            return kernel::CAMERA_SPHERICAL;
    }
    return kernel::CAMERA_PERSPECTIVE;
}

/// A camera placed by vectors, with another vector to the right.
kernel::Camera window_of(const scene::ProjectionCamera& camera, Vec3d right) {
    return {to_kernel(to_float(camera.location)), to_kernel(to_float(camera.direction)),
            to_kernel(to_float(right * 0.5)), to_kernel(to_float(camera.up * 0.5))};
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

kernel::Camera camera_at(const scene::ProjectionCamera& camera, float aspect) {
    Vec3d right = camera.right;
    const double width = length(camera.up) * aspect;
    if (camera.kind == scene::ProjectionCamera::Kind::perspective && length(right) > 0)
        right = normalize(right) * width;
    return window_of(camera, right);
}

namespace {

/// The caller's camera, or the scene's: the one placed by vectors, else the orbiting one.
void set_camera(const scene::Scene& scene, const FrameOptions& options, float time_s, kernel::FrameParams& params) {
    params.camera_kind = kernel::CAMERA_PERSPECTIVE;
    if (options.camera) {
        params.camera = *options.camera;
    } else if (scene.projection_camera) {
        const scene::ProjectionCamera camera = scene::placed_at(*scene.projection_camera, time_s);
        const float aspect = static_cast<float>(params.width) / static_cast<float>(params.height);
        params.camera = camera.fits_picture ? camera_at(camera, aspect) : window_of(camera, camera.right);
        params.camera_kind = kernel_camera_kind(camera);
        params.camera_angle = radians(static_cast<float>(camera.angle_deg));
        params.camera_vertical_angle = radians(static_cast<float>(camera.vertical_angle_deg));
    } else {
        params.camera =
            camera_at(scene.camera, time_s, static_cast<float>(params.width) / static_cast<float>(params.height));
    }
}

/// Turns radiosity on, and ambient light off, which stands for it elsewhere.
void set_radiosity(const scene::Radiosity& r, Frame& frame) {
    frame.params.features |= kernel::FEATURE_RADIOSITY;
    if (!r.keeps_ambient) frame.params.ambient = {0, 0, 0};
    IrradianceCaching& out = frame.radiosity.emplace();
    out.count = r.count;
    out.recursion_limit = r.recursion_limit;
    out.nearest_count = r.nearest_count;
    out.error_bound = r.error_bound;
    out.low_error_factor = r.low_error_factor;
    out.minimum_reuse = r.minimum_reuse;
    out.maximum_reuse = r.maximum_reuse;
    out.pretrace_start = r.pretrace_start;
    out.pretrace_end = r.pretrace_end;
    out.gray_threshold = r.gray_threshold;
    out.brightness = r.brightness;
    out.max_sample = r.max_sample;
    out.min_weight = r.adc_bailout;
    out.bent_normals = r.normal;
    out.through_media = r.media;
    out.always_sample = r.always_sample;
    out.loaded = r.loaded;
    out.store = r.store;
}

/// Where a target of photons is.
Bounds3 bounds_of(const PhotonTarget& target, const std::vector<kernel::Instance>& instances) {
    Bounds3 bounds = target.bounds;
    for (const PhotonTarget::Moving& part : target.moving) {
        const kernel::Instance& i = instances[part.instance];
        const auto host = [](const kernel::vec3& v) { return Vec3{v.x, v.y, v.z}; };
        bounds.include(transformed({host(i.world_from_object_x), host(i.world_from_object_y),
                                    host(i.world_from_object_z), host(i.world_from_object_t)},
                                   part.bounds));
    }
    return bounds;
}

/// Turns photons on, if any are to be had.
void set_photons(const scene::Photons& p, const scene::Scene& scene, const RenderScene& compiled, Frame& frame) {
    if (!p.loaded && !(p.spacing > 0) && p.count <= 0) return;
    frame.params.features |= kernel::FEATURE_PHOTONS;
    PhotonMapping& out = frame.photons.emplace();
    out.spacing = p.spacing;
    out.count = p.count;
    out.gather_min = p.gather_min;
    out.gather_max = p.gather_max;
    out.media_steps = p.media_steps;
    out.media_factor = p.media_factor;
    out.jitter = p.jitter;
    out.max_depth = p.max_depth ? static_cast<std::uint32_t>(*p.max_depth) : frame.params.max_depth;
    out.min_weight = p.min_weight.value_or(frame.params.min_weight);
    out.autostop = p.autostop;
    out.expand_increase = p.expand_increase;
    out.expand_min = p.expand_min;
    out.radius = p.radius;
    out.radius_factor = p.radius_factor;
    out.media_radius = p.media_radius;
    out.media_radius_factor = p.media_radius_factor;
    out.loaded = p.loaded;
    out.store = p.store;
    if (p.find_targets) {
        // Their light has come through everything already.
        for (kernel::Light& light : frame.lights)
            if ((light.flags & kernel::LIGHT_SHADOWS) == 0)
                light.flags |= kernel::LIGHT_PHOTONS_NEVER_REFLECT | kernel::LIGHT_PHOTONS_NEVER_REFRACT;
    }
    for (const PhotonTarget& target : compiled.photon_targets)
        out.targets.push_back(bounds_of(target, frame.instances));
    for (const scene::Light& light : scene.lights) {
        PhotonMapping::LightInsides& insides = out.insides.emplace_back();
        insides.media.fill(kernel::NONE);
        if (light.kind == scene::Light::Kind::sun) continue;
        const Vec3d place = to_double(light.place);
        if (frame.params.features & kernel::FEATURE_HOLLOW) set_media_insides(compiled, place, insides.media);
        if (compiled.interiors.size() < 2) continue;
        const auto [first, second, third, fourth] = interiors_around(compiled, place);
        insides.interiors_inner = first | second << 16U;
        insides.interiors_outer = third | fourth << 16U;
    }
}

/// What lights other than plain lamps and suns need.
bool has_shape(const kernel::Light& light) {
    return light.kind == kernel::LIGHT_SPOT || light.kind == kernel::LIGHT_CYLINDER || light.fade_power > 0 ||
           (light.flags & kernel::LIGHT_ILLUMINATES) != 0;
}

}  // namespace

Frame make_frame(const scene::Scene& scene, const RenderScene& compiled, const FrameOptions& options) {
    const scene::Settings& settings = scene.settings;
    const float time_s = settings.freeze_s.value_or(options.time_s);

    Frame frame;
    kernel::FrameParams& params = frame.params;
    params.width = static_cast<std::uint32_t>(choose(options.width, settings.width, kDefaultWidth));
    params.height = static_cast<std::uint32_t>(choose(options.height, settings.height, kDefaultHeight));
    set_camera(scene, options, time_s, params);
    if (!options.camera) frame.camera_rays = compiled.camera_rays, frame.camera_normal = compiled.camera_normal;
    params.ambient = to_kernel(scene.ambient);
    params.irid_wavelength = to_kernel(scene.irid_wavelength);
    params.sky = to_kernel(scene.sky);
    // What a scene says is meant for mirrors and glass.
    params.max_depth = static_cast<std::uint32_t>(options.integrator == kernel::INTEGRATOR_WHITTED
                                                      ? choose(options.max_depth, settings.max_depth, kDefaultMaxDepth)
                                                      : options.max_depth.value_or(kPathsMaxDepth));
    params.min_weight = choose(options.min_weight, settings.min_weight, kDefaultMinWeight);
    params.far_z = choose(options.far_z, settings.far_z, kNoFarClip);
    params.plane_count = plane_count_of(compiled);
    params.aovs = options.aovs;
    params.sampling = options.sampling;
    params.working_gamma = settings.working_gamma;

    bool some_light_casts_shadows = false;
    for (const scene::Light& light : scene.lights) {
        frame.lights.push_back(light_at(light, time_s));
        some_light_casts_shadows = some_light_casts_shadows || light.shadows;
    }
    params.fog_count = static_cast<std::uint32_t>(scene.fogs.size());
    params.sky_layer_count = sky_layer_count(scene);
    params.light_count = static_cast<std::uint32_t>(frame.lights.size());
    if (frame.lights.empty()) frame.lights.resize(1);
    frame.instances = instances_at(scene, compiled, time_s);

    params.features = compiled.features;
    if (frame.camera_normal != kernel::NONE) params.features |= kernel::FEATURE_NORMALS;
    params.rainbows = compiled.rainbows;
    params.atmosphere = compiled.atmosphere;
    std::fill(std::begin(params.eye_insides), std::end(params.eye_insides), kernel::NONE);
    const Vec3d eye{params.camera.eye.x, params.camera.eye.y, params.camera.eye.z};
    if (params.features & kernel::FEATURE_HOLLOW) set_media_insides(compiled, eye, params.eye_insides);
    if (compiled.interiors.size() > 1) {
        const auto [first, second, third, fourth] = interiors_around(compiled, eye);
        params.eye_interiors_inner = first | second << 16U;
        params.eye_interiors_outer = third | fourth << 16U;
    }
    if (std::any_of(frame.lights.begin(), frame.lights.end(), has_shape))
        params.features |= kernel::FEATURE_LIGHT_SHAPES;
    if (params.fog_count > 0 || params.sky_layer_count > 0 || params.rainbows != kernel::NONE)
        params.features |= kernel::FEATURE_ATMOSPHERE;
    if (choose(options.shadows, settings.shadows, true) && some_light_casts_shadows)
        params.features |= kernel::FEATURE_SHADOWS;
    params.environment = compiled.environment;
    if (params.environment.width > 0) params.features |= kernel::FEATURE_ENVIRONMENT;
    params.integrator = options.integrator;
    params.seed = options.seed;
    params.most_radiance = options.most_radiance;
    params.lens_radius = options.lens_radius;
    params.focus_distance = options.focus_distance;
    params.lens_blades = options.lens_blades;
    if (eye_is_within_closed_mesh(compiled, frame)) params.features |= kernel::FEATURE_ONE_SIDED;
    params.occlusion_distance = options.occlusion_distance;
    if (!(params.occlusion_distance > 0))
        params.occlusion_distance =
            compiled.bounds.empty() ? 1.0F : 0.5F * length(compiled.bounds.upper - compiled.bounds.lower);
    if (options.integrator != kernel::INTEGRATOR_WHITTED) {
        // Paths find the light that these stand for.
        params.ambient = {0, 0, 0};
        list_emitters(compiled, frame);
        if (options.integrator != kernel::INTEGRATOR_PATH) params.features &= ~kernel::FEATURE_SUBSURFACE;
    } else {
        frame.emitters.resize(1);
        if (scene.radiosity && options.radiosity) set_radiosity(*scene.radiosity, frame);
        if (scene.photons) set_photons(*scene.photons, scene, compiled, frame);
    }
    if (scene.subsurface) {
        params.subsurface_samples = static_cast<std::uint32_t>(scene.subsurface->samples);
        params.subsurface_single_samples = static_cast<std::uint32_t>(scene.subsurface->single_samples);
    }
    if (!options.subsurface) params.features &= ~kernel::FEATURE_SUBSURFACE;
    if (settings.cull_backfaces) params.features |= kernel::FEATURE_CULL;
    return frame;
}

}  // namespace sundog
