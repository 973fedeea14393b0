// SPDX-License-Identifier: Apache-2.0
#include "session/blurred_film.h"

#include "postprocess/velocity_blur.h"
#include "session/eye_hits.h"

namespace sundog {
namespace {

std::vector<Vec3> means_of(const Film& film) {
    std::vector<Vec3> means;
    means.reserve(film.radiance.size());
    for (int y = film.bounds.y0; y < film.bounds.y1; ++y)
        for (int x = film.bounds.x0; x < film.bounds.x1; ++x) means.push_back(film.mean(x, y));
    return means;
}

/// The film with other means; pixels without samples get one.
std::optional<Film> with_means(const Film& film, const std::vector<Vec3>& means) {
    if (means.empty()) return std::nullopt;
    Film out = film;
    for (std::size_t i = 0; i < means.size(); ++i) {
        const float weight = film.radiance[i][3] > 0 ? film.radiance[i][3] : 1;
        out.radiance[i] = {means[i].x * weight, means[i].y * weight, means[i].z * weight, weight};
    }
    return out;
}

/// Pixels that a unit of length has at distance 1 before a frame's camera.
float pixels_at_distance_1(const kernel::FrameParams& params) {
    const auto length_of = [](const kernel::vec3& v) { return length(Vec3{v.x, v.y, v.z}); };
    return length_of(params.camera.center) / length_of(params.camera.up) * 0.5F * static_cast<float>(params.height);
}

}  // namespace

std::optional<Film> blurred_by_lens(Device& device, const Frame& frame, const RenderScene& scene, const Film& film,
                                    postprocess::Spread spread, const StopFlag& stop) {
    const auto hits = trace_eye_hits(device, frame, scene, stop);
    if (!hits) return std::nullopt;
    const std::vector<Vec3> means = means_of(film);
    const postprocess::ThinLens lens{frame.params.lens_radius * pixels_at_distance_1(frame.params),
                                     frame.params.focus_distance};
    return with_means(
        film, postprocess::lens_blurred({film.bounds.width(), film.bounds.height(), means, hits->axis_depth}, lens,
                                        spread, stop));
}

std::optional<Film> blurred_by_motion(Device& device, const Frame& opens, const Frame& middle, const Frame& closes,
                                      const RenderScene& scene, const Film& film, const StopFlag& stop) {
    const auto hits = trace_eye_hits(device, middle, scene, stop);
    if (!hits) return std::nullopt;
    const std::vector<Vec3> means = means_of(film);
    const std::vector<postprocess::PixelPath> paths = paths_on_screen(*hits, opens, middle, closes);
    return with_means(film,
                      postprocess::velocity_blurred(
                          {film.bounds.width(), film.bounds.height(), means, hits->depth, hits->object, paths}, stop));
}

}  // namespace sundog
