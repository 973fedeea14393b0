// SPDX-License-Identifier: Apache-2.0
#include "bake/direct_light.h"

#include <algorithm>
#include <utility>

#include "compile/emitters.h"

namespace sundog::bake {
namespace {

bool is_black(const kernel::vec3& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

/// The frame with some of its emitters alone.
Frame with_emitters(const Frame& frame, std::vector<kernel::Emitter> emitters) {
    Frame out = frame;
    std::vector<double> shares;
    for (const kernel::Emitter& e : emitters) shares.push_back(e.probability);
    const double sum = set_emitters(std::move(emitters), shares, out);
    out.params.emitted_power = static_cast<float>(frame.params.emitted_power * sum);
    return out;
}

bool has_size(const Frame& frame, const kernel::Emitter& emitter) {
    if (emitter.kind != kernel::EMITTER_LIGHT) return true;
    const kernel::Light& light = frame.lights[emitter.index];
    return light.area_count_u * light.area_count_v > 1;
}

/// Whether rays that look for the sky may meet something that shines.
bool anything_shines(const RenderScene& compiled) {
    return std::any_of(compiled.materials.begin(), compiled.materials.end(), [](const kernel::Material& m) {
        return !is_black(m.emission) || (m.flags & kernel::MATERIAL_PATTERNED) != 0;
    });
}

/// How much of the baking this is, as progress tells it.
constexpr double kShare = 0.5;
/// By how much a plain sky is made brighter than all that shines: a power of 2, so that nothing is rounded.
constexpr float kBrighter = 1U << 30U;

/// Renders all vertices, again and again.
class Passes {
public:
    Passes(Session& session, std::size_t pixels, double samples, const ProgressSink& progress, const StopFlag& stop)
        : session_(session), pixels_(pixels), samples_(samples), progress_(progress), stop_(stop) {}

    /// The mean radiance of each pixel.
    std::vector<Vec3> render(const Frame& frame, std::uint32_t samples, std::vector<Vec3>* albedo = nullptr) {
        const ProgressSink part = [&](const Progress& p) {
            if (progress_)
                progress_({kShare * (done_ + p.fraction * samples) / samples_, seconds_ + p.seconds, rays_ + p.rays});
        };
        RenderResult result = session_.render(frame, samples, part, stop_);
        stopped_ |= result.stopped;
        done_ += samples;
        seconds_ += result.seconds;
        rays_ += result.stats.rays;
        std::vector<Vec3> light(pixels_);
        for (std::size_t i = 0; i < pixels_; ++i) {
            const auto& sums = result.film.radiance[i];
            if (!(sums[3] > 0)) throw StoppedEarly();
            light[i] = {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
        }
        if (albedo != nullptr) *albedo = std::move(result.film.albedo);
        return light;
    }
    [[nodiscard]] bool stopped() const { return stopped_; }

private:
    Session& session_;
    std::size_t pixels_;
    double samples_;
    const ProgressSink& progress_;
    const StopFlag& stop_;
    double done_ = 0, seconds_ = 0;
    std::uint64_t rays_ = 0;
    bool stopped_ = false;
};

}  // namespace

ShiningSurfaces shining_surfaces(const RenderScene& compiled, const Frame& frame, const std::vector<Part>& parts) {
    std::set<std::size_t> baked;
    for (const Part& part : parts) baked.insert(part.source);
    const auto is_baked = [&](std::uint32_t geometry) { return baked.contains(compiled.geometry_objects[geometry]); };
    bool all_baked = true;
    for (std::uint32_t g = 0; g < compiled.geometries.size(); ++g)
        all_baked &= compiled.geometries[g].primitive_count == 0 || is_baked(g);
    for (const kernel::Material& m : compiled.materials) all_baked &= (m.flags & kernel::MATERIAL_TRANSPARENT) == 0;
    ShiningSurfaces shining;
    for (std::uint32_t i = 0; i < frame.params.emitter_count; ++i) {
        const kernel::Emitter& e = frame.emitters[i];
        const bool is_surface = e.kind == kernel::EMITTER_TRIANGLE || e.kind == kernel::EMITTER_SPHERE;
        shining.emitters.push_back(!is_surface || !all_baked || !is_baked(e.geometry));
        if (!is_surface || !shining.emitters.back()) continue;
        shining.aimed_at.emplace(compiled.geometry_objects[e.geometry], e.kind == kernel::EMITTER_TRIANGLE
                                                                            ? compiled.triangles[e.index].material
                                                                            : compiled.spheres[e.index].material);
    }
    return shining;
}

DirectLight direct_light(const RenderScene& compiled, Session& session, const Frame& frame,
                         const ShiningSurfaces& shining, const VertexPixels& pixels, float distance,
                         const BakeOptions& options, const ProgressSink& progress, const StopFlag& stop) {
    Frame ended = frame;
    ended.params.max_depth = 0;
    ended.params.working_gamma = 1;
    ended.params.aovs = 0;
    Frame own = with_emitters(ended, {});
    own.params.aovs = kernel::AOV_ALBEDO;

    /// What is aimed at at once.
    struct Aim {
        std::vector<kernel::Emitter> at;
        std::uint32_t samples;
    };
    std::vector<Aim> aims;
    std::vector<kernel::Emitter> sized;
    for (std::uint32_t i = 0; i < frame.params.emitter_count; ++i) {
        const kernel::Emitter& emitter = frame.emitters[i];
        if (!shining.emitters[i]) continue;
        if (has_size(frame, emitter) || aims.size() == options.samples) sized.push_back(emitter);
        else aims.push_back({{emitter}, 1});
    }
    if (!sized.empty()) aims.push_back({std::move(sized), options.samples});

    // What rays to the sky meet may shine as well. A plain sky is made so bright that this doesn't count; of others,
    // that is seen without them, too, and taken off.
    std::vector<Frame> views;
    const bool is_plain = frame.params.sky_layer_count == 0;
    const bool has_sky = !is_black(frame.params.sky) || !is_plain;
    if (has_sky && (frame.params.features & kernel::FEATURE_ENVIRONMENT) == 0) {
        views.push_back(with_emitters(ended, {}));
        views[0].camera_rays = std::make_shared<ViewRays>(pixels, distance);
        if (is_plain) {
            const kernel::vec3& sky = frame.params.sky;
            views[0].params.sky = {sky.x * kBrighter, sky.y * kBrighter, sky.z * kBrighter};
        } else if (anything_shines(compiled)) {
            views.push_back(views[0]);
            views[1].params.sky = {0, 0, 0};
            views[1].params.sky_layer_count = 0;
        }
    }

    double samples = 1 + static_cast<double>(views.size()) * options.samples;
    for (const Aim& aim : aims) samples += aim.samples;
    Passes passes(session, pixels.count(), samples, progress, stop);
    DirectLight light;
    light.own = passes.render(own, 1, &light.albedo);
    light.reflected.resize(light.own.size(), {0, 0, 0});
    for (Aim& aim : aims) {
        const std::vector<Vec3> seen = passes.render(with_emitters(ended, std::move(aim.at)), aim.samples);
        for (std::size_t i = 0; i < seen.size(); ++i) light.reflected[i] += seen[i] - light.own[i];
    }
    for (std::size_t v = 0; v < views.size(); ++v) {
        const std::vector<Vec3> seen = passes.render(views[v], options.samples);
        const float share = v == 1 ? -1.0F : is_plain ? 1 / kBrighter : 1.0F;
        for (std::size_t i = 0; i < seen.size(); ++i) light.reflected[i] += light.albedo[i] * seen[i] * share;
    }
    light.stopped = passes.stopped();
    return light;
}

}  // namespace sundog::bake
