// SPDX-License-Identifier: Apache-2.0
// A scene on a device: schedules the work of a picture, reports progress, can be stopped.
#pragma once

#include <memory>
#include <optional>

#include "base/progress.h"
#include "device/device.h"
#include "session/contrast.h"
#include "session/error_driven.h"
#include "session/recursive.h"
#include "session/render_result.h"
#include "session/thin_items.h"

namespace sundog {

/// What one pixel sees.
struct PixelInfo {
    Vec3 radiance;    ///< Linear RGB at the pixel's centre.
    float depth = 0;  ///< Distance from the eye; infinite on a miss.
    Vec3 normal;      ///< World space.
    std::uint32_t geometry = kernel::NONE, primitive = kernel::NONE, material = kernel::NONE;
    float axis_depth = 0;  ///< As depth, along the view axis of a pinhole.
};

/// Owns a device and renders frames of one compiled scene on it.
class Session {
public:
    explicit Session(std::unique_ptr<Device> device);

    [[nodiscard]] Device& device() { return *device_; }
    /// Gives the scene to the device. Errors: DeviceError.
    void load(std::shared_ptr<const RenderScene> scene);
    [[nodiscard]] const RenderScene& scene() const { return *scene_; }

    /// Renders a whole picture of `samples` samples a pixel. Work is split by sample passes and bands so that
    /// progress can be shown and a stop is answered within about 0.1 s.
    /// With a `region`, which must lie in the picture, only its pixels are rendered, and the film's bounds are it.
    RenderResult render(const Frame& frame, std::uint32_t samples, const ProgressSink& progress, const StopFlag& stop,
                        const std::optional<PixelRect>& region = {});

    /// Renders one sample a pixel, then more where neighbours differ (contrast_of). The film's pixels then have
    /// different numbers of samples. `region` as above; with AdaptiveSampling::preview there is none.
    RenderResult render_adaptive(const Frame& frame, const AdaptiveSampling& sampling, const ProgressSink& progress,
                                 const StopFlag& stop, const std::optional<PixelRect>& region = {});

    /// render_recursively(), where the device has that for such a frame; otherwise render_adaptive(), with a sample
    /// more on a pixel's side than there are levels.
    RenderResult render_recursive(const Frame& frame, const RecursiveSampling& sampling, const ProgressSink& progress,
                                  const StopFlag& stop, const std::optional<PixelRect>& region = {});

    /// See session/error_driven.h.
    ErrorDrivenResult render_to_error(const Frame& frame, const ErrorTarget& target, const ProgressSink& progress,
                                      const StopFlag& stop, const std::optional<PixelRect>& region = {});

    /// Renders one sample a pixel by refinement, where the device has that (Device::can_refine), all pixels otherwise.
    /// What is thin on the screen is found whatever the corners of squares meet (thin_items). `tolerance`, `gain` and
    /// `method`: see RefinedWork.
    RenderStats refine_into(const Frame& frame, float tolerance, float gain, Film& film, const StopFlag& stop,
                            RefinementMethod method = RefinementMethod::grid);

    /// Renders samples [first, first+count) of `film`'s region into it; the viewer's way.
    RenderStats render_into(const Frame& frame, std::uint32_t first_sample, std::uint32_t count, Film& film,
                            const StopFlag& stop);

    /// Traces pixel (x, y)'s centre with all AOVs.
    PixelInfo pick(const Frame& frame, int x, int y);

private:
    std::unique_ptr<Device> device_;
    std::shared_ptr<const RenderScene> scene_;
    std::optional<std::vector<ThinItem>> thin_items_;  ///< Of scene_, once they were asked for.
};

}  // namespace sundog
