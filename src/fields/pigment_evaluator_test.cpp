// SPDX-License-Identifier: Apache-2.0
#include "fields/pigment_evaluator.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "fields/function_builder.h"
#include "fields/function_evaluator.h"

namespace sundog::fields {
namespace {

std::shared_ptr<const scene::Pigment> crackled() {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->kind = scene::Pigment::Kind::mapped;
    pigment->pattern.kind = scene::Pattern::Kind::crackle;
    pigment->entries.push_back({0, {0.1, 0.2, 0.3, 0.05, 0.4}, nullptr});
    pigment->entries.push_back({1, {0.9, 0.7, 0.6, 0.15, 0.1}, nullptr});
    return pigment;
}
/// A pattern that lanes ask the host for, one by one.
std::shared_ptr<const scene::Pigment> fractal() {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->kind = scene::Pigment::Kind::mapped;
    pigment->pattern.kind = scene::Pattern::Kind::fractal;
    pigment->entries.push_back({0, {0, 0, 0}, nullptr});
    pigment->entries.push_back({1, {1, 1, 1}, crackled()});
    return pigment;
}
std::vector<Vec3d> some_points(std::size_t count) {
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<double>(i);
        points.push_back({0.37 * k - 2, 1.7 - 0.11 * k, 0.05 * k});
    }
    return points;
}

// Counts that no width divides: catches lanes left over, lanes in the wrong order, and colours that depend on how many
// are asked for together.
TEST(PigmentEvaluator, ManyPointsHaveTheSameBitsAsOne) {
    const std::array pigments{crackled(), fractal()};
    const PigmentEvaluator evaluator(pigments, {});
    for (const std::size_t count : {0, 1, 3, 8, 13, 33}) {
        const std::vector<Vec3d> points = some_points(count);
        for (std::uint32_t index = 0; index < 2; ++index) {
            const auto colors = evaluator.colors(index, points);
            ASSERT_EQ(colors.size(), count);
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_EQ(colors[i], evaluator.color(index, points[i].x, points[i].y, points[i].z))
                    << i << ' ' << count;
        }
    }
}

// A pigment asked for at the point itself, and at another: catches colours of the wrong point or the wrong pigment.
TEST(PigmentEvaluator, FunctionsOfManyPointsAreThoseOfOne) {
    FunctionBuilder builder(3);
    const Number x = builder.input(0), y = builder.input(1), z = builder.input(2);
    const Number here = builder.pigment(crackled(), x, y, z, 1);
    const Number moved = builder.pigment(fractal(), x + builder.constant(0.3), y, z, 0);
    const Number sum = here + moved * builder.constant(2);
    const auto function = std::make_shared<const scene::Function>(builder.finish(std::array{sum}));
    const FunctionEvaluator evaluator(function);
    const std::vector<Vec3d> points = some_points(21);
    PointsEvaluation many(evaluator, points);
    NoiseCells cells;
    PointEvaluation one(evaluator, cells);
    std::uint64_t budget = 100'000;
    for (const Vec3d& p : points) {
        const auto value = many.next(budget);
        ASSERT_TRUE(value);
        EXPECT_EQ(*value, one.value(std::array{p.x, p.y, p.z}));
    }
    budget = 1;
    PointsEvaluation late(evaluator, points);
    EXPECT_FALSE(late.next(budget));
}

}  // namespace
}  // namespace sundog::fields
