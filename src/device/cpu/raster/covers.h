// SPDX-License-Identifier: Apache-2.0
// Where in a picture something may be seen that isn't rasterised.
#pragma once

#include <vector>

#include "base/vec.h"
#include "device/cpu/raster/eye_view.h"
#include "device/film.h"
#include "device/render_scene.h"

namespace sundog::cpu::raster {

/// Geometries that are traced alone: shapes that aren't triangles, and all that move.
class TracedThings {
public:
    explicit TracedThings(const RenderScene& scene);
    /// Rectangles of the picture, which hold all pixels where one of them may be seen. Planes aren't among them.
    [[nodiscard]] std::vector<PixelRect> rects(const Frame& frame, const EyeView& view) const;

    [[nodiscard]] std::size_t count() const { return things_.size(); }

private:
    struct Thing {
        Bounds3 bounds;
        std::uint32_t instance = kernel::NONE;
    };
    std::vector<Thing> things_;
};

}  // namespace sundog::cpu::raster
