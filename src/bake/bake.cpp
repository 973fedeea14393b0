// SPDX-License-Identifier: Apache-2.0
#include "bake/bake.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bake/by_radiosity.h"
#include "bake/part_light.h"
#include "bake/vertex_rays.h"

namespace sundog::bake {
namespace {

/// A picture of all vertices by paths.
Frame picture_of(const VertexPixels& pixels, const scene::Scene& scene, const RenderScene& compiled,
                 const BakeOptions& options) {
    FrameOptions view;
    view.width = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pixels.count()))));
    view.height = static_cast<int>((pixels.count() + static_cast<std::size_t>(*view.width) - 1) /
                                   static_cast<std::size_t>(*view.width));
    view.time_s = options.time_s;
    view.integrator = kernel::INTEGRATOR_PATH;
    view.max_depth = options.max_depth;
    view.seed = options.seed;
    view.aovs = kernel::AOV_ALBEDO;
    return make_frame(scene, compiled, view);
}

/// Sets all light of all vertices; true if stopped.
bool by_paths(const scene::Scene& scene, Session& session, const Frame& frame, const VertexPixels& pixels,
              std::uint32_t samples, std::vector<Part>& parts, const ProgressSink& progress, const StopFlag& stop) {
    const RenderResult result = session.render(frame, samples, progress, stop);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        Part& part = parts[p];
        const bool textured = is_textured(scene.materials[part.material]);
        PartSides sides;
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t v = 0; v < part.positions.size(); ++v) {
                const std::size_t pixel = pixels.pixel_of(p, v, side == 1);
                const auto& sums = result.film.radiance[pixel];
                if (!(sums[3] > 0)) throw StoppedEarly();
                Vec3 light{sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
                if (textured) light = light_of_white(light, result.film.albedo[pixel]);
                sides[side].push_back(light);
            }
        take_side(part, sides, is_turned(sides));
    }
    return result.stopped;
}

}  // namespace

BakedScene bake(const scene::Scene& scene, const RenderScene& compiled, Session& session, const BakeOptions& options,
                const WarningSink& warn, const ProgressSink& progress, const StopFlag& stop) {
    const auto start = std::chrono::steady_clock::now();
    const float diagonal = compiled.bounds.empty() ? 1.0F : length(compiled.bounds.upper - compiled.bounds.lower);
    const float longest = options.longest_edge > 0 ? options.longest_edge : diagonal / 64;
    BakedScene baked;
    baked.parts = parts_of(scene, options.time_s, longest, warn);
    const VertexPixels pixels(baked.parts);
    if (pixels.count() == 0) return baked;
    // Not so near that rounding loses the surface, nor so far that another one is between.
    const float distance = std::max(0.02F * longest, 1e-5F * diagonal);
    Frame frame = picture_of(pixels, scene, compiled, options);
    frame.camera_rays = std::make_shared<VertexRays>(pixels, distance);
    if (options.method == Method::paths) {
        baked.stopped = by_paths(scene, session, frame, pixels, options.samples, baked.parts, progress, stop);
    } else {
        const ShiningSurfaces shining = shining_surfaces(compiled, frame, baked.parts);
        DirectLight direct = direct_light(compiled, session, frame, shining, pixels, distance, options, progress, stop);
        baked.stopped =
            by_radiosity(scene, frame, shining, std::move(direct), pixels, options, baked.parts, progress, stop);
    }
    for (const Part& part : baked.parts) {
        baked.vertices += part.positions.size();
        baked.triangles += part.triangles.size();
    }
    baked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return baked;
}

}  // namespace sundog::bake
