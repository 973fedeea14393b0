// SPDX-License-Identifier: Apache-2.0
#include "denoise/denoise.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>

#include "denoise/prepare.h"
#include "denoise/tile_filter.h"

namespace sundog::denoise {
namespace {

/// A tile's light into the picture's.
void store(const TileLight& light, const Layout& layout, int tile_x, int tile_y, std::vector<Vec3>& out) {
    for (int j = 0; j < kTileSide && tile_y * kTileSide + j < layout.height; ++j)
        for (int i = 0; i < kTileSide && tile_x * kTileSide + i < layout.width; ++i) {
            const auto from = static_cast<std::size_t>(j * kTileSide + i);
            out[layout.pixel(tile_x * kTileSide + i, tile_y * kTileSide + j)] = {light[0][from], light[1][from],
                                                                                 light[2][from]};
        }
}

}  // namespace

void check_planes(const NoisyPicture& p) {
    const auto pixels = static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height);
    const auto fits = [&](std::size_t size, bool needed) { return size == pixels || (size == 0 && !needed); };
    if (p.width <= 0 || p.height <= 0 || !fits(p.radiance.size(), true) || !fits(p.variance.size(), true) ||
        !fits(p.albedo.size(), false) || !fits(p.normal.size(), false) || !fits(p.depth.size(), false))
        throw std::invalid_argument("denoised: a plane is not of the picture's size");
}

std::vector<Vec3> denoised(const NoisyPicture& picture, const StopFlag& stop) {
    check_planes(picture);
    const Layout layout(picture.width, picture.height);
    const std::vector<Vec3> by = divisors(picture);
    const Guides guides = guides_of(picture, layout);
    const Light noisy = light_of(picture, by, layout);
    std::vector<Vec3> out(picture.radiance.size());
    tbb::parallel_for(0, layout.tiles_x * layout.tiles_y, [&](int tile) {
        if (stop.requested()) return;
        const int x = tile % layout.tiles_x, y = tile / layout.tiles_x;
        TileLight light;
        filter_tile(noisy, guides, layout, x, y, light);
        store(light, layout, x, y, out);
    });
    if (stop.requested()) return {};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = out[i] * by[i];
    return out;
}

}  // namespace sundog::denoise
