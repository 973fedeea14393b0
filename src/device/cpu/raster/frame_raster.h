// SPDX-License-Identifier: Apache-2.0
// First hits of eye rays by scan conversion instead of tracing: one scene's triangles, sorted for one frame at a time.
#pragma once

#include <memory>
#include <vector>

#include "device/cpu/raster/covers.h"
#include "device/cpu/raster/raster_kernel.h"
#include "device/cpu/tile_kernel.h"
#include "device/render_scene.h"

namespace sundog::cpu::raster {

/// The rasteriser of one width.
struct RasterKernels {
    BinKernel bin = nullptr;
    TileRaster raster = nullptr;
};
/// lanes: 4, 8 or 16.
RasterKernels raster_kernels(int lanes);

class FrameRaster {
public:
    /// `scene` must outlive this.
    FrameRaster(const RenderScene& scene, RasterKernels kernels);

    /// True for frames whose eye rays can be found so: of a perspective camera, in the pixels themselves (no
    /// wider filter), where all geometry is seen by the eye, from both sides.
    [[nodiscard]] static bool can(const Frame& frame);
    /// True where that is measured to be faster than tracing (docs/acceleration.md).
    [[nodiscard]] bool pays(const Frame& frame) const;

    /// Sorts for a frame that can() be; nothing is done if it is so already.
    void prepare(const Frame& frame);
    /// The tile that holds the pixels of `wanted`, at a sample of a frame like the one prepared. It lives in the
    /// scratch memory, and says nothing of packets without such pixels.
    [[nodiscard]] RasterisedTile tile(const PixelRect& wanted, const kernel::PixelSampling& sampling,
                                      std::uint32_t sample, TileScratch& scratch,
                                      std::vector<std::uint32_t>& list) const;

    [[nodiscard]] std::size_t triangle_count() const { return triangle_count_; }

private:
    const RenderScene& scene_;
    RasterKernels kernels_;
    TracedThings traced_things_;
    std::vector<std::uint32_t> geometries_;  ///< Of each triangle.
    std::vector<TriangleRun> runs_;
    std::size_t triangle_count_ = 0;

    Frame frame_;  ///< What is prepared, if it is.
    bool prepared_ = false;
    kernel::SceneView scene_view_{};
    EyeView view_{};
    std::vector<Bins> bins_;  ///< For each run.
    std::vector<PixelRect> traced_;
    int tiles_across_ = 0;
};

}  // namespace sundog::cpu::raster
