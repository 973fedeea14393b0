// SPDX-License-Identifier: Apache-2.0
// Polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace sundog::import {

/// Cuts polygons into triangles. Keeps its working memory between calls; use one in each thread.
class PolygonCutter {
public:
    using Triangle = std::array<std::uint32_t, 3>;  ///< Indices into the corners given.

    /// The corners.size() - 2 triangles of a polygon of three or more finite corners, with its own orientation. Concave
    /// polygons are cut in the plane of their Newell normal (Sutherland et al. 1974, "A characterization of ten
    /// hidden-surface algorithms") by removing ears (Meisters 1975, "Polygons have ears"). Some triangles may have no
    /// area where corners coincide or lie on a line.
    std::span<const Triangle> cut(std::span<const Vec3> corners);

    /// True if the last polygon had no ear left at some point (it crosses itself) or was too large to search for ears
    /// with reasonable work; its triangles then cover it only roughly.
    [[nodiscard]] bool approximate() const { return approximate_; }

private:
    struct Corner {
        double x, y;
        std::uint32_t previous, next;
        bool reflex, removed;
    };

    bool project(std::span<const Vec3> corners);
    [[nodiscard]] bool convex() const;
    void cut_fan(std::uint32_t count);
    void cut_quad(std::span<const Vec3> corners);
    void cut_ears();
    void remove_ear(std::uint32_t ear);
    [[nodiscard]] double twice_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    bool is_ear(std::uint32_t corner);

    std::vector<Corner> corners_;
    std::vector<std::uint32_t> reflex_by_x_;
    std::vector<Triangle> triangles_;
    std::uint64_t tests_left_ = 0;
    bool approximate_ = false;
};

}  // namespace sundog::import
