// SPDX-License-Identifier: Apache-2.0
// Cameras of functions (POV-Ray 3.8's user_defined): where rays start and where they go, by x and y of the picture.
#include <cmath>

#include "compile/camera.h"
#include "fields/function_evaluator.h"

namespace sundog {
namespace {

class FunctionRays final : public CameraRays {
public:
    FunctionRays(const scene::ProjectionCamera& camera, std::span<const scene::Texture> textures)
        : camera_(camera.function), location_(camera.location), direction_(camera.direction) {
        if (camera_->location) locations_.emplace(camera_->location, textures);
        if (camera_->direction) directions_.emplace(camera_->direction, textures);
    }

    [[nodiscard]] std::optional<Ray> ray(const kernel::FrameParams& frame, const Place& place) const override {
        const std::array<double, 3> at{(place.x + double{place.dx}) / frame.width - 0.5,
                                       0.5 - (place.y + double{place.dy}) / frame.height, 0};
        const Vec3d origin = transform_point(camera_->world_from_camera, value(locations_, at, location_));
        const Vec3d direction = transform_vector(camera_->world_from_camera, value(directions_, at, direction_));
        const double squared = dot(direction, direction);
        if (!(squared > 0) || !std::isfinite(squared) || !is_finite(origin)) return std::nullopt;
        return Ray{to_float(origin), to_float(direction * (1 / std::sqrt(squared)))};
    }

private:
    static Vec3d value(const std::optional<fields::FunctionEvaluator>& function, const std::array<double, 3>& at,
                       Vec3d otherwise) {
        if (!function) return otherwise;
        fields::NoiseCells cells;
        fields::PointEvaluation evaluation(*function, cells);
        std::uint64_t budget = fields::FunctionEvaluator::kStepLimit;
        if (!evaluation.run(at, budget)) return {NAN, NAN, NAN};
        return {evaluation.output(0), evaluation.output(1), evaluation.output(2)};
    }

    std::shared_ptr<const scene::FunctionCamera> camera_;
    Vec3d location_, direction_;
    std::optional<fields::FunctionEvaluator> locations_, directions_;
};

}  // namespace

std::shared_ptr<const CameraRays> make_function_camera(const scene::ProjectionCamera& camera,
                                                       std::span<const scene::Texture> textures) {
    return std::make_shared<FunctionRays>(camera, textures);
}

}  // namespace sundog
