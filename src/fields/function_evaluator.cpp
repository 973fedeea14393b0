// SPDX-License-Identifier: Apache-2.0
#include "fields/function_evaluator.h"

#include "fields/pigment_evaluator.h"

namespace sundog::fields {

FunctionEvaluator::FunctionEvaluator(std::shared_ptr<const scene::Function> function,
                                     std::span<const scene::Texture> textures)
    : function_(std::move(function)) {
    if (!function_->pigments.empty())
        pigments_ = std::make_shared<const PigmentEvaluator>(function_->pigments, textures);
}

PointsEvaluation::Ahead::Ahead(const FunctionEvaluator& f, std::span<const Vec3d> points)
    : source_(f.pigments()), points_(points), colors_(f.function().pigments.size()) {
    const auto input = static_cast<std::uint32_t>(f.function().first_input());
    for (const scene::FunctionInstruction& i : f.function().code)
        if (i.op == scene::FunctionOp::pigment && i.a == input && i.b == input + 1 && i.c == input + 2 &&
            colors_[i.index].empty())
            colors_[i.index] = source_->colors(i.index, points);
}

std::array<double, 5> PointsEvaluation::Ahead::color(std::uint32_t index, double x, double y, double z) const {
    const std::vector<std::array<double, 5>>& known = colors_[index];
    return !known.empty() && points_[at] == Vec3d{x, y, z} ? known[at] : source_->color(index, x, y, z);
}

PointsEvaluation::PointsEvaluation(const FunctionEvaluator& f, std::span<const Vec3d> points)
    : points_(points), ahead_(f, points), evaluation_(f, cells_, &ahead_) {}

std::optional<double> PointsEvaluation::next(std::uint64_t& budget) {
    const Vec3d& p = points_[ahead_.at];
    const bool done = evaluation_.run(std::array{p.x, p.y, p.z}, budget);
    ++ahead_.at;
    return done ? std::optional(evaluation_.output(0)) : std::nullopt;
}

}  // namespace sundog::fields
