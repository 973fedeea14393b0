// SPDX-License-Identifier: Apache-2.0
#include "shutter.h"

#include <algorithm>
#include <chrono>

#include "scene/deformation.h"

namespace sundog::app {
namespace {

/// Moments at most: structures over what moves are built for each.
constexpr std::uint32_t kMostMoments = 256;

}  // namespace

RenderResult render_open_shutter(const RenderArguments& arguments, FrameOptions options, const Stage& stage,
                                 const ProgressSink& progress, const StopFlag& stop) {
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const auto samples = static_cast<std::uint32_t>(arguments.sampling.most_samples());
    const std::uint32_t moments = std::min(samples, kMostMoments);
    const bool bends = scene::is_deforming(stage.scene) && !stage.scene.settings.freeze_s;
    const float opens_s = options.time_s;
    RenderResult result{Film(PixelRect{}), {}, 0, false};
    for (std::uint32_t k = 0; k < moments && !result.stopped; ++k) {
        options.time_s = opens_s + arguments.shutter_s * (static_cast<float>(k) + 0.5F) / static_cast<float>(moments);
        std::shared_ptr<const RenderScene> bent;
        if (bends) {
            scene::Scene scene = stage.scene;
            scene::deform(scene, options.time_s);
            bent = compile(scene, {});
            stage.session.load(bent);
        }
        const Frame frame = make_frame(stage.scene, bent ? *bent : stage.compiled, options);
        if (k == 0)
            result.film = Film({0, 0, static_cast<int>(frame.params.width), static_cast<int>(frame.params.height)},
                               frame.params.aovs);
        const std::uint32_t first = samples * k / moments, end = samples * (k + 1) / moments;
        const RenderStats stats = stage.session.render_into(frame, first, end - first, result.film, stop);
        result.stats.rays += stats.rays;
        result.stats.shadow_rays += stats.shadow_rays;
        result.stopped = !stats.complete;
        if (progress) progress({static_cast<double>(k + 1) / moments, seconds(), result.stats.rays});
    }
    result.stats.complete = !result.stopped;
    result.seconds = seconds();
    return result;
}

}  // namespace sundog::app
