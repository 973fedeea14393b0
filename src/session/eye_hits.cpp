// SPDX-License-Identifier: Apache-2.0
#include "session/eye_hits.h"

#include <cmath>
#include <utility>

namespace sundog {
namespace {

Vec3 to_host(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

/// A pinhole and the window before it.
class Pinhole {
public:
    explicit Pinhole(const kernel::FrameParams& params)
        : eye_(to_host(params.camera.eye)),
          center_(to_host(params.camera.center)),
          right_(to_host(params.camera.right)),
          up_(to_host(params.camera.up)),
          width_(static_cast<float>(params.width)),
          height_(static_cast<float>(params.height)),
          window_from_world_(inverse({right_, up_, center_, {}})) {}

    [[nodiscard]] Vec3 eye() const { return eye_; }
    /// The unit direction through the middle of a pixel.
    [[nodiscard]] Vec3 direction(int x, int y) const {
        const float across = 2 * (static_cast<float>(x) + 0.5F) / width_ - 1;
        const float upwards = 1 - 2 * (static_cast<float>(y) + 0.5F) / height_;
        return normalize(center_ + right_ * across + up_ * upwards);
    }
    [[nodiscard]] float along_axis(Vec3 v) const { return dot(v, center_) / length(center_); }
    /// Where what lies that way from the eye is seen, in pixels; nothing for what isn't before it.
    [[nodiscard]] std::optional<Vec2> seen(Vec3 from_eye) const {
        const Vec3 window = transform_vector(window_from_world_, from_eye);
        if (!(window.z > 0)) return std::nullopt;
        return Vec2{(window.x / window.z + 1) * 0.5F * width_, (1 - window.y / window.z) * 0.5F * height_};
    }

private:
    Vec3 eye_, center_, right_, up_;
    float width_, height_;
    Affine3 window_from_world_;
};

Affine3 world_from_object(const kernel::Instance& i) {
    return {to_host(i.world_from_object_x), to_host(i.world_from_object_y), to_host(i.world_from_object_z),
            to_host(i.world_from_object_t)};
}

Affine3 object_from_world(const kernel::Instance& i) {
    return {to_host(i.object_from_world_x), to_host(i.object_from_world_y), to_host(i.object_from_world_z),
            to_host(i.object_from_world_t)};
}

/// From the middle frame's world to another one's, for each instance.
std::vector<Affine3> moves_between(const Frame& from, const Frame& to) {
    std::vector<Affine3> moves;
    for (std::size_t i = 0; i < from.instances.size() && i < to.instances.size(); ++i)
        moves.push_back(world_from_object(to.instances[i]) * object_from_world(from.instances[i]));
    return moves;
}

}  // namespace

bool has_pinhole(const Frame& frame) {
    return frame.params.camera_kind == kernel::CAMERA_PERSPECTIVE && !frame.camera_rays &&
           frame.camera_normal == kernel::NONE;
}

std::optional<EyeHits> trace_eye_hits(Device& device, const Frame& frame, const RenderScene& scene,
                                      const StopFlag& stop) {
    Frame plain = frame;
    plain.params.integrator = kernel::INTEGRATOR_WHITTED;
    plain.params.max_depth = 0;
    plain.params.light_count = 0;
    plain.params.lens_radius = 0;
    plain.params.sampling = {};
    plain.params.aovs = kernel::AOV_DEPTH | kernel::AOV_OBJECT;
    plain.params.features &=
        ~(kernel::FEATURE_RADIOSITY | kernel::FEATURE_PHOTONS | kernel::FEATURE_SHADOWS | kernel::FEATURE_SUBSURFACE);
    plain.radiosity.reset();
    plain.photons.reset();
    const auto width = static_cast<int>(frame.params.width), height = static_cast<int>(frame.params.height);
    Film film({0, 0, width, height}, plain.params.aovs);
    if (!device.render(plain, {film.bounds, 0, 1}, film, stop).complete) return std::nullopt;
    const Pinhole pinhole(frame.params);
    EyeHits hits;
    hits.depth = std::move(film.depth);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = film.index(x, y);
            hits.axis_depth.push_back(hits.depth[i] * pinhole.along_axis(pinhole.direction(x, y)));
            const std::uint32_t geometry = film.object[i];
            hits.instance.push_back(geometry == kernel::NONE ? kNoInstance : scene.geometries[geometry].instance);
        }
    hits.object = std::move(film.object);
    return hits;
}

std::vector<postprocess::PixelPath> paths_on_screen(const EyeHits& hits, const Frame& opens, const Frame& middle,
                                                    const Frame& closes) {
    const Pinhole now(middle.params), first(opens.params), last(closes.params);
    const std::vector<Affine3> to_first = moves_between(middle, opens), to_last = moves_between(middle, closes);
    const auto width = static_cast<int>(middle.params.width), height = static_cast<int>(middle.params.height);
    std::vector<postprocess::PixelPath> paths;
    paths.reserve(hits.depth.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = paths.size();
            const Vec3 direction = now.direction(x, y);
            const std::uint32_t instance = hits.instance[i];
            const bool sky = std::isinf(hits.depth[i]);
            const auto seen = [&](const Pinhole& pinhole, const std::vector<Affine3>& moves) -> std::optional<Vec2> {
                if (sky) return pinhole.seen(direction);
                const Vec3 place = now.eye() + direction * hits.depth[i];
                const Vec3 moved = instance < moves.size() ? transform_point(moves[instance], place) : place;
                return pinhole.seen(moved - pinhole.eye());
            };
            // From where the same sums put it now, so that what rests is exactly at rest.
            const Vec2 here = seen(now, {}).value_or(Vec2{});
            const auto way = [&](const std::optional<Vec2>& there) -> std::optional<Vec2> {
                if (!there) return std::nullopt;
                return Vec2{there->x - here.x, there->y - here.y};
            };
            const std::optional<Vec2> opening = way(seen(first, to_first)), closing = way(seen(last, to_last));
            const auto mirrored = [](const std::optional<Vec2>& v) { return v ? Vec2{-v->x, -v->y} : Vec2{}; };
            paths.push_back({opening.value_or(mirrored(closing)), closing.value_or(mirrored(opening))});
        }
    return paths;
}

}  // namespace sundog
