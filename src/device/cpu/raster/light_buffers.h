// SPDX-License-Identifier: Apache-2.0
// Light buffers of all lamps of a frame, by scan conversion of the scene's triangles from where the lamps are.
#pragma once

#include <span>
#include <vector>

#include "device/cpu/light_cells.h"
#include "device/cpu/raster/covers.h"
#include "device/cpu/raster/raster_kernel.h"
#include "device/render_scene.h"

namespace sundog::cpu::raster {

/// The rasteriser of one width: 4, 8 or 16 lanes.
CellKernel cell_kernel(int lanes);

class LightBuffers {
public:
    /// `scene` must outlive this.
    LightBuffers(const RenderScene& scene, CellKernel kernel);

    /// True for frames that have lamps whose buffers say something, in scenes of which it is measured to pay
    /// (docs/acceleration.md).
    [[nodiscard]] bool pays(const Frame& frame) const;
    /// For a frame that pays(); nothing is done for lamps whose buffer is as it has to be.
    void prepare(const Frame& frame);
    /// One for each of the frame's lights.
    [[nodiscard]] const kernel::LightCells* cells() const { return cells_.data(); }

private:
    template <class T>
    using Aligned = std::vector<T, tbb::cache_aligned_allocator<T>>;
    struct Buffer {
        kernel::vec3 place;
        int side = 0;
        std::vector<kernel::Instance> instances;
        Aligned<std::uint32_t> cells;
    };
    void fill(Buffer& buffer, const Frame& frame) const;

    const RenderScene& scene_;
    CellKernel kernel_;
    TracedThings traced_things_;
    std::vector<TriangleRun> runs_;
    std::vector<std::uint32_t> opaque_;
    std::size_t triangle_count_ = 0;
    bool has_large_faces_ = false;
    std::vector<Buffer> buffers_;
    std::vector<kernel::LightCells> cells_;
};

}  // namespace sundog::cpu::raster
