// SPDX-License-Identifier: Apache-2.0
#include "viewer/clean_picture.h"

#include <numeric>
#include <utility>
#include <vector>

#include "denoise/denoise.h"

namespace sundog::viewer {

std::optional<Film> cleaned(const Film& film, std::span<const Vec3> variance, const PictureGuides& guides,
                            const StopFlag& stop) {
    std::vector<Vec3> means;
    means.reserve(film.radiance.size());
    for (int y = film.bounds.y0; y < film.bounds.y1; ++y)
        for (int x = film.bounds.x0; x < film.bounds.x1; ++x) means.push_back(film.mean(x, y));
    const std::vector<Vec3> clean = denoise::denoised({.width = film.bounds.width(),
                                                       .height = film.bounds.height(),
                                                       .radiance = means,
                                                       .variance = variance,
                                                       .albedo = guides.albedo,
                                                       .normal = guides.normal,
                                                       .depth = guides.depth},
                                                      stop);
    if (clean.empty()) return std::nullopt;
    Film out = film;
    for (std::size_t i = 0; i < clean.size(); ++i) {
        const float weight = film.radiance[i][3];
        out.radiance[i] = {clean[i].x * weight, clean[i].y * weight, clean[i].z * weight, weight};
    }
    return out;
}

void CleanPicture::forget() { *this = {}; }

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
    std::optional<Film> out = cleaned(film, errors_->variances(), *guides_, stop);
    if (!out) return false;
    clean_ = std::move(out);
    samples_ = samples;
    return true;
}

}  // namespace sundog::viewer
