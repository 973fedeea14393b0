// SPDX-License-Identifier: Apache-2.0
// Vertices as the pixels of a picture.
#pragma once

#include <vector>

#include "bake/patches.h"
#include "device/camera_rays.h"

namespace sundog::bake {

/// Which pixel is which vertex: first all fronts and backs of the first part's, one after the other.
class VertexPixels {
public:
    /// The parts must outlive this, and keep their vertices.
    explicit VertexPixels(const std::vector<Part>& parts);

    [[nodiscard]] std::size_t count() const { return 2 * vertices_; }
    [[nodiscard]] std::size_t pixel_of(std::size_t part, std::size_t vertex, bool back) const {
        return 2 * (first_[part] + vertex) + (back ? 1 : 0);
    }

    struct Place {
        Vec3 inside;  ///< Where the vertex's light arrives.
        Vec3 normal;  ///< Of the pixel's side.
    };
    [[nodiscard]] std::optional<Place> at(std::size_t pixel) const;

private:
    const std::vector<Part>& parts_;
    std::vector<std::size_t> first_;
    std::size_t vertices_ = 0;
};

/// Each pixel looks at its vertex from right before it.
class VertexRays final : public CameraRays {
public:
    VertexRays(const VertexPixels& pixels, float distance) : pixels_(pixels), distance_(distance) {}
    [[nodiscard]] std::optional<Ray> ray(const kernel::FrameParams& frame, const Place& place) const override;

private:
    const VertexPixels& pixels_;
    float distance_;
};

/// Each pixel looks away from its vertex, sample by sample into directions that lie evenly by the cosine (Roberts' R2
/// sequence, The Unreasonable Effectiveness of Quasirandom Sequences, 2018, lifted to the hemisphere by Malley's
/// method): the same for all vertices of a flat surface, so that what they see differs by no noise.
class ViewRays final : public CameraRays {
public:
    ViewRays(const VertexPixels& pixels, float distance) : pixels_(pixels), distance_(distance) {}
    [[nodiscard]] std::optional<Ray> ray(const kernel::FrameParams& frame, const Place& place) const override;

private:
    const VertexPixels& pixels_;
    float distance_;
};

}  // namespace sundog::bake
