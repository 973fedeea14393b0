// SPDX-License-Identifier: Apache-2.0
#include "fields/host_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fields/fractals.h"
#include "fields/function_evaluator.h"
#include "fields/pavement.h"
#include "fields/pigment_evaluator.h"
#include "fields/quilted.h"
#include "fields/warps.h"

namespace sundog::fields {
namespace {

using Kind = scene::Pattern::Kind;

/// A field that is a callable of a FieldPoint.
template <class Call>
class Field final : public HostField {
public:
    explicit Field(Call call) : call_(std::move(call)) {}
    [[nodiscard]] Vec3d at(const FieldPoint& point) const override { return {call_(point), 0, 0}; }

private:
    Call call_;
};
template <class Call>
std::unique_ptr<HostField> field(Call call) {
    return std::make_unique<Field<Call>>(std::move(call));
}

class WarpField final : public HostField {
public:
    explicit WarpField(const scene::Warp& warp) : warp_(warp) {}
    [[nodiscard]] Vec3d at(const FieldPoint& point) const override { return warped(warp_, point.position); }

private:
    scene::Warp warp_;
};

/// 1 for directions alike, 0 for opposite ones, linear in the angle.
double alike(Vec3d a, Vec3d b) { return 1 - std::acos(std::clamp(dot(a, b), -1.0, 1.0)) / std::numbers::pi; }

double slope_value(const scene::SlopeForm& slope, const FieldPoint& point) {
    if (point.normal == Vec3d{}) return 0;
    const Vec3d direction = slope.toward_point ? slope.direction - point.world : slope.direction;
    const double size = length(direction);
    if (size == 0) return 0;
    double value = alike(point.normal, direction / size);
    const double range = slope.high - slope.low;
    if (range != 0) value = (value - slope.low) / range;
    const double altitude_size = length(slope.altitude);
    if (altitude_size == 0) return value;
    double altitude = dot(point.position, slope.altitude / altitude_size);
    const double altitude_range = slope.high_altitude - slope.low_altitude;
    if (altitude_range != 0) altitude = (altitude - slope.low_altitude) / altitude_range;
    return (size * value + altitude_size * altitude) / (size + altitude_size);
}

/// Highest at the corners of cells. As povray's values show.
double quilted_value(double control0, double control1, Vec3d p) {
    const Vec3d d = from_cell_middle(p);
    return (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) / std::numbers::sqrt3 *
           quilted_curve(control0, control1, length(d));
}

/// The voxel that a place in 0..1 lies in, or interpolated towards the next voxels, round and round.
class DensityField {
public:
    DensityField(std::shared_ptr<const scene::DensityGrid> grid, int interpolation)
        : grid_(std::move(grid)), interpolation_(interpolation) {}

    double operator()(const FieldPoint& point) const {
        const Vec3d p = point.position;
        if (!grid_ || grid_->values.empty()) return 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!(p[axis] >= 0 && p[axis] < 1)) return 0;
        std::array<std::int64_t, 3> cell{};
        std::array<std::array<double, 4>, 3> weights{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double place = p[axis] * grid_->size[axis];
            const double lower = std::floor(place);
            cell[axis] = static_cast<std::int64_t>(lower);
            weights[axis] = weights_of(place - lower);
        }
        const std::int64_t first = interpolation_ == 2 ? -1 : 0;
        const std::int64_t count = interpolation_ == 2 ? 4 : interpolation_ == 1 ? 2 : 1;
        double sum = 0;
        for (std::int64_t z = 0; z < count; ++z)
            for (std::int64_t y = 0; y < count; ++y)
                for (std::int64_t x = 0; x < count; ++x)
                    sum += weights[0][static_cast<std::size_t>(x)] * weights[1][static_cast<std::size_t>(y)] *
                           weights[2][static_cast<std::size_t>(z)] *
                           voxel(cell[0] + first + x, cell[1] + first + y, cell[2] + first + z);
        return std::clamp(sum, 0.0, 1.0);
    }

private:
    [[nodiscard]] std::array<double, 4> weights_of(double t) const {
        if (interpolation_ == 0) return {1, 0, 0, 0};
        if (interpolation_ == 1) return {1 - t, t, 0, 0};
        // Cubic through the middle two of four values, with slopes between the outer ones.
        return {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2, ((4 - 3 * t) * t + 1) * t / 2,
                (t - 1) * t * t / 2};
    }
    [[nodiscard]] double voxel(std::int64_t x, std::int64_t y, std::int64_t z) const {
        const auto wrapped = [](std::int64_t i, std::uint32_t size) {
            const auto n = static_cast<std::int64_t>(size);
            return static_cast<std::size_t>((i % n + n) % n);
        };
        const auto& size = grid_->size;
        const std::size_t index = (wrapped(z, size[2]) * size[1] + wrapped(y, size[1])) * size[0] + wrapped(x, size[0]);
        return static_cast<double>(grid_->values[index]);
    }

    std::shared_ptr<const scene::DensityGrid> grid_;
    int interpolation_;
};

class FunctionField final : public HostField {
public:
    FunctionField(const std::shared_ptr<const scene::Function>& function, std::span<const scene::Texture> textures)
        : evaluator_(function, textures) {}
    [[nodiscard]] Vec3d at(const FieldPoint& point) const override {
        Vec3d answer;
        at_all(std::span(&point, 1), std::span(&answer, 1));
        return answer;
    }
    void at_all(std::span<const FieldPoint> points, std::span<Vec3d> answers) const override {
        if (evaluator_.pigments() != nullptr && points.size() > 1) return with_pigments(points, answers);
        // Neighbours lie in the same cells of noise.
        NoiseCells cells;
        PointEvaluation evaluation(evaluator_, cells);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3d& p = points[i].position;
            answers[i] = {kept(evaluation.value(std::array{p.x, p.y, p.z})), 0, 0};
        }
    }

private:
    void with_pigments(std::span<const FieldPoint> points, std::span<Vec3d> answers) const {
        std::vector<Vec3d> places;
        places.reserve(points.size());
        for (const FieldPoint& point : points) places.push_back(point.position);
        PointsEvaluation evaluation(evaluator_, places);
        for (Vec3d& answer : answers) {
            std::uint64_t budget = FunctionEvaluator::kStepLimit;
            answer = {kept(evaluation.next(budget).value_or(DoubleMath::unknown())), 0, 0};
        }
    }
    static double kept(double value) {
        if (!std::isfinite(value)) return 0;
        return value > 1 ? std::fmod(value, 1.0) : value;
    }

    FunctionEvaluator evaluator_;
};

class FractalField final : public HostField {
public:
    explicit FractalField(const scene::FractalForm& form) : form_(form) {}
    [[nodiscard]] Vec3d at(const FieldPoint& point) const override {
        return {fractal_value(form_, point.position.x, point.position.y), 0, 0};
    }
    void at_all(std::span<const FieldPoint> points, std::span<Vec3d> answers) const override {
        constexpr std::size_t kAtOnce = 16;
        std::array<double, kAtOnce> x, y, values;
        for (std::size_t first = 0; first < points.size(); first += kAtOnce) {
            const std::size_t count = std::min(kAtOnce, points.size() - first);
            for (std::size_t i = 0; i < count; ++i) {
                const Vec3d p = points[first + i].position;
                x[i] = p.x, y[i] = p.y;
            }
            fractal_values(form_, std::span(x.data(), count), std::span(y.data(), count),
                           std::span(values.data(), count));
            for (std::size_t i = 0; i < count; ++i) answers[first + i] = {values[i], 0, 0};
        }
    }

private:
    scene::FractalForm form_;
};

/// Which texture of a list a picture chooses.
class MaterialField {
public:
    MaterialField(const scene::Pattern& pattern, std::span<const scene::Texture> textures)
        : last_(std::max(pattern.choices, 1) - 1),
          picture_(std::make_shared<const PigmentEvaluator>(std::array{pattern.pigment}, textures)) {}
    double operator()(const FieldPoint& point) const {
        const Vec3d p = point.position;
        return std::min(std::round(picture_->color(0, p.x, p.y, p.z)[0] * 255), last_);
    }

private:
    double last_;  ///< Of the textures: numbers beyond it get it, too.
    std::shared_ptr<const PigmentEvaluator> picture_;
};

}  // namespace

bool is_host_field(Kind kind) {
    switch (kind) {
        case Kind::aoi:
        case Kind::density_file:
        case Kind::fractal:
        case Kind::function:
        case Kind::material:
        case Kind::object:
        case Kind::pavement:
        case Kind::quilted:
        case Kind::share:
        case Kind::slope:
            return true;
        default:
            return false;
    }
}

std::unique_ptr<HostField> make_host_field(const scene::Pattern& pattern, std::span<const scene::Texture> textures) {
    switch (pattern.kind) {
        case Kind::aoi:
            return field([](const FieldPoint& point) {
                return point.normal == Vec3d{} ? 0.0 : alike(point.normal, -point.direction);
            });
        case Kind::density_file:
            return field(DensityField(pattern.density, pattern.interpolation));
        case Kind::fractal:
            return std::make_unique<FractalField>(pattern.fractal);
        case Kind::function:
            if (pattern.function) return std::make_unique<FunctionField>(pattern.function, textures);
            break;
        case Kind::material:
            if (pattern.pigment) return field(MaterialField(pattern, textures));
            break;
        case Kind::object:
            if (pattern.inside_of)
                return field([test = pattern.inside_of](const FieldPoint& point) {
                    return test->inside(point.position) ? 1.0 : 0.0;
                });
            break;
        case Kind::pavement:
            return field([pavement = Pavement(pattern.pavement)](const FieldPoint& point) {
                return pavement.at(point.position.x, point.position.z);
            });
        case Kind::quilted:
            return field([c0 = pattern.control0, c1 = pattern.control1](const FieldPoint& point) {
                return quilted_value(c0, c1, point.position);
            });
        case Kind::share:
            if (!pattern.share) break;
            return field([share = pattern.share](const FieldPoint& point) { return share->at(point.position); });
        case Kind::slope:
            return field([form = pattern.slope](const FieldPoint& point) { return slope_value(form, point); });
        default:
            break;
    }
    return field([](const FieldPoint&) { return 0.0; });
}

std::unique_ptr<HostField> make_host_warp(const scene::Warp& warp) { return std::make_unique<WarpField>(warp); }

void HostFieldTable::at(kernel::uint index, std::span<const kernel::HostPoint> points,
                        std::span<kernel::vec3> answers) const {
    const auto vec = [](kernel::vec3 v) {
        return Vec3d{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
    };
    constexpr std::size_t kAtOnce = 16;
    std::array<FieldPoint, kAtOnce> asked;
    std::array<Vec3d, kAtOnce> found;
    for (std::size_t first = 0; first < points.size(); first += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, points.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const kernel::HostPoint& p = points[first + i];
            asked[i] = {vec(p.p), vec(p.normal), vec(p.direction), vec(p.world)};
        }
        fields_[index]->at_all(std::span(asked.data(), count), std::span(found.data(), count));
        for (std::size_t i = 0; i < count; ++i)
            answers[first + i] = {static_cast<float>(found[i].x), static_cast<float>(found[i].y),
                                  static_cast<float>(found[i].z)};
    }
}

}  // namespace sundog::fields
