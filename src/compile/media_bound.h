// SPDX-License-Identifier: Apache-2.0
// How dense media can be: what tracking goes by (kernel/atmosphere/majorants.h).
#pragma once

#include <span>
#include <vector>

#include "compile/pigment_range.h"
#include "device/render_scene.h"

namespace sundog {

/// How dense a list of media can be over boxes of their own space. The media must outlive it.
class MediaBound {
public:
    MediaBound(std::span<const scene::Medium> media, std::span<const scene::Texture> textures);

    /// No less than the extinction anywhere, and than what is scattered, per unit of length.
    [[nodiscard]] double most() const { return most_; }
    /// What share of that a box has at most. 0 only where nothing shines, either.
    [[nodiscard]] double share_over(const RangeBox& box) const;
    /// False where no density depends on the place.
    [[nodiscard]] bool varies() const;
    [[nodiscard]] bool shines() const;
    /// About how many sums of noise their densities take at a point.
    [[nodiscard]] int cost() const;

private:
    struct Part {
        const scene::Medium* medium;
        std::vector<PigmentRange> densities;
        Vec3d most;  ///< Of the densities' product anywhere, per channel.
    };
    static Vec3d product_over(const Part& part, const RangeBox& box);

    std::vector<Part> parts_;
    double most_ = 0;
};

/// A list of media in RenderScene::code, and where it comes from.
struct MediaList {
    std::uint32_t at = 0;
    std::span<const scene::Medium> media;
    Affine3d medium_from_world;
};

/// Gives each list a grid of bounds over what holds it, for paths; where bounds of parts are hardly lower than that of
/// the whole, or what holds the media moves or has no end, it has none. Objects are there, and no code is added after.
void add_majorant_grids(std::span<const MediaList> lists, std::span<const scene::Texture> textures, RenderScene& out);

}  // namespace sundog
