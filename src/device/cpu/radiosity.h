// SPDX-License-Identifier: Apache-2.0
// Radiosity as POV-Ray's reference describes it (section 3.4.4.3): passes over the picture from coarse to fine gather
// irradiance where none is known near by; the picture then blends what is known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/progress.h"
#include "device/cpu/hemisphere.h"
#include "device/cpu/irradiance_cache.h"
#include "device/cpu/ray_batch.h"
#include "device/render_scene.h"
#include "kernel/lights/indirect.h"

namespace sundog::cpu {

/// A point whose irradiance is wanted.
struct GatherPoint {
    Vec3 position, normal;
    Vec3 face;        ///< The surface's own normal, to the side that is lit.
    float error = 0;  ///< How far off the surface rays start.
};

/// The irradiance of a picture. The first `prepare()` gathers it; after that, many threads may ask.
///
/// Samples are taken by rounds: what a round takes depends on the samples before it alone, they are gathered by all
/// threads and added in the order of their points. So a picture's bits don't depend on the number of threads.
class Radiosity {
public:
    /// `frame` has radiosity, `scene` is its view (without indirect light); both outlive this.
    Radiosity(const Frame& frame, const kernel::SceneView& scene, RayKernel trace);

    /// Gathers, from what is loaded on, and keeps it all where it is to be kept. False if it was stopped: then it must
    /// not be used. Errors: those of the store.
    bool prepare(const StopFlag& stop);
    /// What the picture's rays ask.
    [[nodiscard]] const kernel::IndirectLight& light() const;
    /// What prepare() took.
    [[nodiscard]] BatchRays rays() const { return rays_; }
    [[nodiscard]] std::size_t sample_count(int bounce) const {
        return caches_[static_cast<std::size_t>(bounce)].size();
    }

private:
    class Light;
    enum class Task { find_gaps, shade, draw };

    /// Most error of a sample that is used at a bounce.
    [[nodiscard]] float error_bound(int bounce) const;
    [[nodiscard]] IrradianceSample gather(const GatherPoint& point, int bounce, Task task,
                                          std::vector<GatherPoint>* gaps, BatchRays& rays) const;
    /// Light that a ray brought, by brightness and gray_threshold.
    [[nodiscard]] Vec3 adjusted(Vec3 light) const;
    [[nodiscard]] bool is_covered(const GatherPoint& point, int bounce, Task task) const;
    /// The ray of the eye through a place of the picture, in pixels; of no reach where there is none.
    [[nodiscard]] BatchRay eye_ray(float x, float y) const;
    /// Points of surfaces that pixels `step` apart see, and that aren't covered.
    [[nodiscard]] std::vector<GatherPoint> gaps_of_picture(float step, float shift, Task task);
    void take_loaded();
    void keep_all() const;
    void fill(std::vector<GatherPoint> wanted, int bounce, Task task, const StopFlag& stop);
    template <class Function>
    void for_each(std::size_t count, const Function& function);

    const Frame& frame_;
    IrradianceCaching settings_;
    kernel::SceneView scene_;
    std::vector<kernel::Light> matt_lights_;  ///< Without highlights, and areas as points.
    RayKernel trace_;
    std::vector<IrradianceCache> caches_;  ///< One for each bounce, the eye's first.
    std::vector<Hemisphere> hemispheres_;  ///< One for each bounce.
    BatchRays rays_;
    std::unique_ptr<kernel::IndirectLight> light_;
};

}  // namespace sundog::cpu
