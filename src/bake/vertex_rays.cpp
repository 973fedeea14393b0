// SPDX-License-Identifier: Apache-2.0
#include "bake/vertex_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sundog::bake {

VertexPixels::VertexPixels(const std::vector<Part>& parts) : parts_(parts) {
    for (const Part& part : parts) {
        first_.push_back(vertices_);
        vertices_ += part.positions.size();
    }
}

std::optional<VertexPixels::Place> VertexPixels::at(std::size_t pixel) const {
    if (pixel >= count()) return std::nullopt;
    const auto after = std::upper_bound(first_.begin(), first_.end(), pixel / 2);
    const auto number = static_cast<std::size_t>(after - first_.begin()) - 1;
    const std::size_t vertex = pixel / 2 - first_[number];
    const Part& part = parts_[number];
    return Place{part.inside[vertex], part.normals[vertex] * (pixel % 2 == 0 ? 1.0F : -1.0F)};
}

std::optional<CameraRays::Ray> VertexRays::ray(const kernel::FrameParams& frame, const Place& place) const {
    const auto vertex = pixels_.at(std::size_t{place.y} * frame.width + place.x);
    if (!vertex) return std::nullopt;
    return Ray{vertex->inside + vertex->normal * distance_, vertex->normal * -1};
}

std::optional<CameraRays::Ray> ViewRays::ray(const kernel::FrameParams& frame, const Place& place) const {
    const auto vertex = pixels_.at(std::size_t{place.y} * frame.width + place.x);
    if (!vertex) return std::nullopt;
    const Vec3 n = vertex->normal;
    const Vec3 beside = std::abs(n.x) > 0.7F ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    const Vec3 x = normalize(cross(beside, n)), y = cross(n, x);
    constexpr double kStepOut = 0.7548776662466927, kStepAround = 0.5698402909980532;
    const auto sequence = [&](double step) {
        const double sum = 0.5 + step * place.sample;
        return sum - std::floor(sum);
    };
    const double area = sequence(kStepOut), turn = 2 * std::numbers::pi * sequence(kStepAround);
    const auto radius = static_cast<float>(std::sqrt(area));
    const auto up = static_cast<float>(std::sqrt(1 - area));
    const Vec3 direction =
        x * (radius * static_cast<float>(std::cos(turn))) + y * (radius * static_cast<float>(std::sin(turn))) + n * up;
    return Ray{vertex->inside + n * distance_, normalize(direction)};
}

}  // namespace sundog::bake
