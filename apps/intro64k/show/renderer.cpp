// SPDX-License-Identifier: Apache-2.0
#include "show/renderer.h"

#include "film/film.h"
#include "stage/palettes.h"

namespace sundog::intro {
namespace {

unsigned lanes_of_processor() {
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return 8;
    return 4;
}

}  // namespace

Renderer::Renderer(unsigned threads, unsigned lanes)
    : crew_(threads),
      lanes_(lanes != 0 ? lanes : lanes_of_processor()),
      draw_tile_(lanes_ == 8 ? draw_tile_by_8() : draw_tile_by_4()),
      noise_(kVolumeVoxels),
      palettes_(static_cast<std::size_t>(kPaletteCount) * kPaletteSize),
      world_(1),
      work_(crew_.threads()),
      tables_{noise_.get(), palettes_.get()} {
    make_palettes(palettes_.get());
    crew_.run(make_noise_piece, this, kVolumeSide);
}

void Renderer::make_noise_piece(void* job, unsigned piece, unsigned /*thread*/) {
    make_noise(static_cast<Renderer*>(job)->noise_.get(), piece, piece + 1);
}

void Renderer::draw_piece(void* job, unsigned piece, unsigned thread) {
    const Renderer& self = *static_cast<Renderer*>(job);
    const uint across = (self.picture_.width + kTileSide - 1) / kTileSide;
    self.draw_tile_(*self.world_, self.tables_, self.quality_, self.picture_, self.work_[thread],
                    piece % across * kTileSide, piece / across * kTileSide);
}

void Renderer::draw(float seconds, const Quality& quality, const Picture& picture) {
    set_up(*world_, seconds, static_cast<float>(picture.width) / static_cast<float>(picture.height));
    quality_ = quality;
    picture_ = picture;
    const uint across = (picture.width + kTileSide - 1) / kTileSide;
    const uint down = (picture.height + kTileSide - 1) / kTileSide;
    crew_.run(draw_piece, this, across * down);
}

Counts Renderer::counts() const {
    Counts sum{};
    for (unsigned i = 0; i < crew_.threads(); ++i) {
        sum.rays += work_[i].counts.rays;
        sum.samples += work_[i].counts.samples;
    }
    return sum;
}

}  // namespace sundog::intro
