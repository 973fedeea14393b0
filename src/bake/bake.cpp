// SPDX-License-Identifier: Apache-2.0
#include "bake/bake.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace sundog::bake {
namespace {

/// Pixels of a picture, each of which looks at a vertex from right before it; first from its front, then from its back.
class VertexRays final : public CameraRays {
public:
    VertexRays(const std::vector<Part>& parts, float distance) : parts_(parts), distance_(distance) {
        for (const Part& part : parts) {
            first_.push_back(count_);
            count_ += part.positions.size();
        }
    }

    [[nodiscard]] std::size_t pixels() const { return 2 * count_; }
    [[nodiscard]] std::size_t pixel_of(std::size_t part, std::size_t vertex, bool back) const {
        return 2 * (first_[part] + vertex) + (back ? 1 : 0);
    }

    [[nodiscard]] std::optional<Ray> ray(const kernel::FrameParams& frame, const Place& place) const override {
        const std::size_t pixel = std::size_t{place.y} * frame.width + place.x;
        if (pixel >= pixels()) return std::nullopt;
        const auto after = std::upper_bound(first_.begin(), first_.end(), pixel / 2);
        const auto number = static_cast<std::size_t>(after - first_.begin()) - 1;
        const Part& part = parts_[number];
        const std::size_t vertex = pixel / 2 - first_[number];
        const Vec3 normal = part.normals[vertex] * (pixel % 2 == 0 ? 1.0F : -1.0F);
        return Ray{part.inside[vertex] + normal * distance_, normal * -1};
    }

private:
    const std::vector<Part>& parts_;
    float distance_;
    std::vector<std::size_t> first_;
    std::size_t count_ = 0;
};

bool is_textured(const scene::Material& material) {
    if (material.principled) return material.principled->base_color_map.texture != scene::kNone;
    return !material.patterned && material.mtl->map_diffuse.texture != scene::kNone;
}

/// What a textured surface's light is apart from its texture.
Vec3 light_of_white(Vec3 radiance, Vec3 albedo) {
    const auto channel = [](float light, float share) { return share > 1e-3F ? light / share : 0.0F; };
    return {channel(radiance.x, albedo.x), channel(radiance.y, albedo.y), channel(radiance.z, albedo.z)};
}

float sum_of(Vec3 c) { return c.x + c.y + c.z; }

}  // namespace

BakedScene bake(const scene::Scene& scene, const RenderScene& compiled, Session& session, const BakeOptions& options,
                const WarningSink& warn, const ProgressSink& progress, const StopFlag& stop) {
    const auto start = std::chrono::steady_clock::now();
    const float diagonal = compiled.bounds.empty() ? 1.0F : length(compiled.bounds.upper - compiled.bounds.lower);
    const float longest = options.longest_edge > 0 ? options.longest_edge : diagonal / 64;
    BakedScene baked;
    baked.parts = parts_of(scene, options.time_s, longest, warn);
    // Not so near that rounding loses the surface, nor so far that another one is between.
    const auto rays = std::make_shared<VertexRays>(baked.parts, std::max(0.02F * longest, 1e-5F * diagonal));
    if (rays->pixels() == 0) return baked;

    FrameOptions view;
    view.width = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(rays->pixels()))));
    view.height = static_cast<int>((rays->pixels() + static_cast<std::size_t>(*view.width) - 1) /
                                   static_cast<std::size_t>(*view.width));
    view.time_s = options.time_s;
    view.integrator = kernel::INTEGRATOR_PATH;
    view.max_depth = options.max_depth;
    view.seed = options.seed;
    view.aovs = kernel::AOV_ALBEDO;
    Frame frame = make_frame(scene, compiled, view);
    frame.camera_rays = rays;
    const RenderResult result = session.render(frame, options.samples, progress, stop);
    baked.stopped = result.stopped;

    for (std::size_t p = 0; p < baked.parts.size(); ++p) {
        Part& part = baked.parts[p];
        const bool textured = is_textured(scene.materials[part.material]);
        std::array<std::vector<Vec3>, 2> sides;
        std::array<double, 2> all{};
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t v = 0; v < part.positions.size(); ++v) {
                const std::size_t pixel = rays->pixel_of(p, v, side == 1);
                const auto& sums = result.film.radiance[pixel];
                if (!(sums[3] > 0)) throw StoppedEarly();
                Vec3 light{sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
                if (textured) light = light_of_white(light, result.film.albedo[pixel]);
                all[side] += sum_of(light);
                sides[side].push_back(light);
            }
        const bool turned = all[1] > all[0];
        part.light = std::move(sides[turned ? 1 : 0]);
        if (turned) {
            for (Vec3& n : part.normals) n = n * -1;
            for (auto& t : part.triangles) std::swap(t[1], t[2]);
        }
        baked.vertices += part.positions.size();
        baked.triangles += part.triangles.size();
    }
    baked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return baked;
}

}  // namespace sundog::bake
