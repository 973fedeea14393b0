// SPDX-License-Identifier: Apache-2.0
// The interface every device implements. CPU and Vulkan stand behind it and never see each other.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "device/film.h"
#include "device/render_scene.h"

namespace sundog {

/// What to compute in one go: every pixel of `region`, samples [first_sample, first_sample + sample_count).
/// Sample 0 goes through the pixel's centre; later ones are a fixed low-discrepancy sequence. With first_sample 0 the
/// film's pixels are overwritten, otherwise added to.
struct RenderWork {
    PixelRect region;
    std::uint32_t first_sample = 0;
    std::uint32_t sample_count = 1;
    /// Of render_regions(): one for each of the film's pixels, 0 where a pixel keeps what it has; empty: all change.
    std::span<const std::uint8_t> wanted{};
    /// One for each of the film's pixels, to which is added how many steps through the acceleration structure the
    /// pixel's rays took. Counted by the CPU device with a structure of ours alone, and slowly; empty: not.
    std::span<std::uint64_t> steps{};
};

/// Which pixels of a refined picture are traced, and how the others are made.
enum class RefinementMethod {
    grid,              ///< Squares whose corners agree are interpolated (sampling/grid_refinement.h).
    scanline,          ///< So are spans of scan lines whose ends agree (sampling/scanline_refinement.h).
    scanline_assumed,  ///< Between ends that see one primitive, every pixel is shaded on it without a search for it.
};

/// A whole picture of one sample a pixel, of which not every pixel has to be traced.
struct RefinedWork {
    /// Most by which the corners of a square of 8 by 8 pixels may differ for the eye, as differences of square roots of
    /// radiance (1: black and white); 0: all pixels are traced.
    float tolerance = 0.1F;
    float gain = 1;  ///< What the picture's radiance will be shown times.
    /// For each square of 8 by 8 pixels, row by row: the side to which it must be divided whatever its corners say (8,
    /// 4, 2 or 1); empty: none.
    std::span<const std::uint8_t> finest{};
    RefinementMethod method = RefinementMethod::grid;
};

/// A point of the picture, in pixels from its upper left corner; pixel (x, y) reaches from there to (x + 1, y + 1).
struct PicturePlace {
    float x = 0, y = 0;
};

/// What a render() did.
struct RenderStats {
    std::uint64_t rays = 0;         ///< Rays of all kinds: primary, secondary and shadow.
    std::uint64_t shadow_rays = 0;  ///< Of them, shadow rays.
    /// Points of the picture whose eye rays were traced, where pixels don't each have their own.
    std::uint64_t points = 0;
    bool complete = true;  ///< False if stopped early: some pixels of the region keep their old content.
    /// Nodes, cells and boxes that rays visited, and primitives that they were tested against; 0 where the device
    /// doesn't count them (Embree and GPUs). Rays of packets whose directions go apart may be asked, and counted,
    /// twice; not so where RenderWork::steps are counted.
    std::uint64_t visits = 0, tests = 0;
};

/// Who a device is.
struct DeviceInfo {
    std::string kind;       ///< "cpu" or "gpu"
    std::string name;       ///< As the driver or processor calls itself.
    std::string detail;     ///< One line: threads and instruction set, or driver and API version.
    bool software = false;  ///< A GPU API that runs on the CPU (lavapipe).
};

/// Renders frames of one scene at a time. Not thread-safe: one caller at a time. Errors: DeviceError.
class Device {
public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    virtual ~Device() = default;

    [[nodiscard]] virtual const DeviceInfo& info() const = 0;
    /// One sentence for each thing in the scene that this device can't draw; empty if all of it can be.
    [[nodiscard]] virtual std::vector<std::string> unsupported(const RenderScene& scene) const = 0;
    /// Takes the scene and builds acceleration structures over it; replaces the one before.
    virtual void load(std::shared_ptr<const RenderScene> scene) = 0;
    /// Bytes that the loaded scene takes on this device beside the RenderScene itself.
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;
    /// Renders into `film`, whose bounds contain work.region. Returns when done, or soon after `stop` is requested.
    /// The result depends on scene, frame and work alone: never on thread count, timing, or how work was split.
    virtual RenderStats render(const Frame& frame, const RenderWork& work, Film& film, const StopFlag& stop) = 0;
    /// The same samples for many small regions, which don't overlap; `work.region` is not looked at. A device may share
    /// them out as it likes.
    virtual RenderStats render_regions(const Frame& frame, std::span<const PixelRect> regions, RenderWork work,
                                       Film& film, const StopFlag& stop);

    /// True if this device has refinement, and for such a frame.
    [[nodiscard]] virtual bool can_refine(const Frame&) const { return false; }
    /// Renders the whole of `film`, which holds the whole picture, by refinement; where that can't be had, tracing
    /// every pixel. With AOV_COST among the film's planes, that one tells which pixels were traced: it is 0 for others;
    /// no other plane is written.
    virtual RenderStats refine(const Frame& frame, const RefinedWork& work, Film& film, const StopFlag& stop);

    /// True if this device traces single places of such a frame's picture.
    [[nodiscard]] virtual bool can_trace_places(const Frame&) const { return false; }
    /// Linear RGB radiance at each of `places`, one ray each, into as many of `radiance`; only where
    /// can_trace_places().
    virtual RenderStats trace_places(const Frame& frame, std::span<const PicturePlace> places, std::span<Vec3> radiance,
                                     const StopFlag& stop);
};

}  // namespace sundog
