// SPDX-License-Identifier: Apache-2.0
#include "viewer/clean_picture.h"

#include <numeric>
#include <utility>
#include <vector>

#include "session/clean_film.h"

namespace sundog::viewer {

void CleanPicture::forget() {
    errors_.reset();
    guides_.reset();
    clean_.reset();
    samples_ = 0;
}

void CleanPicture::add_pass(const Film& film) {
    if (!errors_) errors_.emplace(film.bounds, 1);
    std::vector<std::uint32_t> all(film.radiance.size());
    std::iota(all.begin(), all.end(), 0U);
    errors_->add_blocks(film, all);
}

bool CleanPicture::clean(Device& device, const Frame& frame, const Film& film, std::uint32_t samples,
                         const StopFlag& stop) {
    if (!guides_) {
        PictureGuides guides = trace_guides(device, frame, stop);
        if (stop.requested()) return false;
        guides_ = std::move(guides);
    }
    if (!denoiser_) denoiser_.emplace(method_);
    std::optional<Film> out = cleaned(film, errors_->variances(), *guides_, *denoiser_, stop);
    if (!out) return false;
    clean_ = std::move(out);
    samples_ = samples;
    return true;
}

}  // namespace sundog::viewer
