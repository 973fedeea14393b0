// SPDX-License-Identifier: Apache-2.0
#include "noise.h"

#include <chrono>
#include <vector>

#include "denoise/denoise.h"
#include "session/guides.h"

namespace sundog::app {

double remove_noise(Device& device, const Frame& frame, const StopFlag& stop, RenderResult& result) {
    const auto start = std::chrono::steady_clock::now();
    Film& film = result.film;
    const PictureGuides guides = trace_guides(device, frame, stop);
    std::vector<Vec3> means;
    means.reserve(film.radiance.size());
    for (int y = film.bounds.y0; y < film.bounds.y1; ++y)
        for (int x = film.bounds.x0; x < film.bounds.x1; ++x) means.push_back(film.mean(x, y));
    const std::vector<Vec3> clean = denoise::denoised({.width = film.bounds.width(),
                                                       .height = film.bounds.height(),
                                                       .radiance = means,
                                                       .variance = result.variance,
                                                       .albedo = guides.albedo,
                                                       .normal = guides.normal,
                                                       .depth = guides.depth});
    for (std::size_t i = 0; i < clean.size(); ++i) {
        const float weight = film.radiance[i][3];
        film.radiance[i] = {clean[i].x * weight, clean[i].y * weight, clean[i].z * weight, weight};
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace sundog::app
