// SPDX-License-Identifier: Apache-2.0
#include "session/clean_film.h"

#include <vector>

namespace sundog {

std::optional<Film> cleaned(const Film& film, std::span<const Vec3> variance, const PictureGuides& guides,
                            denoise::Denoiser& denoiser, const StopFlag& stop) {
    std::vector<Vec3> means;
    means.reserve(film.radiance.size());
    for (int y = film.bounds.y0; y < film.bounds.y1; ++y)
        for (int x = film.bounds.x0; x < film.bounds.x1; ++x) means.push_back(film.mean(x, y));
    const std::vector<Vec3> clean = denoiser.denoised({.width = film.bounds.width(),
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

}  // namespace sundog
