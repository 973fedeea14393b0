// SPDX-License-Identifier: Apache-2.0
#include "show/renderer.h"

#include <cpuid.h>

#include "film/film.h"
#include "stage/palettes.h"
#include "trace/prepare.h"

namespace sundog::intro {
bool Renderer::runs_here() {
    // SDL asks whether the system keeps the wide registers, too.
    unsigned eax = 0;
    unsigned ebx = 0;
    unsigned ecx = 0;
    unsigned edx = 0;
    return SDL_HasAVX2() == SDL_TRUE && __get_cpuid(1, &eax, &ebx, &ecx, &edx) != 0 && (ecx & bit_FMA) != 0;
}

Renderer::Renderer(unsigned threads)
    : crew_(threads),
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
    draw_tile(*self.world_, self.tables_, self.quality_, self.picture_, self.work_[thread], piece % across * kTileSide,
              piece / across * kTileSide);
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
        sum.points += work_[i].counts.points;
    }
    return sum;
}

}  // namespace sundog::intro
