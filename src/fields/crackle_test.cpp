// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

#include "fields/pigment_evaluator.h"
#include "kernel/patterns/noise.h"

namespace sundog::fields {
namespace {

/// The pattern's value by the red of a map from black to white.
class Crackle {
public:
    explicit Crackle(const scene::CrackleForm& form) : evaluator_(std::array{pigment(form)}, {}) {}
    [[nodiscard]] double at(Vec3d p) const { return evaluator_.color(0, p.x, p.y, p.z)[0]; }

private:
    static std::shared_ptr<const scene::Pigment> pigment(const scene::CrackleForm& form) {
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->kind = scene::Pigment::Kind::mapped;
        pigment->pattern.kind = scene::Pattern::Kind::crackle;
        pigment->pattern.crackle = form;
        pigment->entries.push_back({0, {0, 0, 0}, nullptr});
        pigment->entries.push_back({1, {1, 1, 1}, nullptr});
        return pigment;
    }
    PigmentEvaluator evaluator_;
};

/// Distances by a metric to the points of the 27 cells around p, the nearest first: the pattern looks no farther.
std::vector<double> distances(Vec3d p, double metric) {
    std::vector<double> found;
    const auto part = [](std::uint32_t bits) { return 0.5 + 0.5 * static_cast<double>(kernel::signed_unit(bits)); };
    for (int i = 0; i < 27; ++i) {
        const Vec3d cell{std::floor(p.x) + i % 3 - 1, std::floor(p.y) + i / 3 % 3 - 1, std::floor(p.z) + i / 9 - 1};
        const std::uint32_t hash = kernel::cell_hash(
            {static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(cell.z)}, 0x17U);
        const Vec3d d = cell + Vec3d{part(hash), part(hash >> 10U), part(hash >> 20U)} - p;
        const auto power = [&](double x) { return std::pow(std::abs(x), metric); };
        found.push_back(std::pow(power(d.x) + power(d.y) + power(d.z), 1 / metric));
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<Vec3d> places() {
    std::vector<Vec3d> result;
    for (int k = 0; k < 60; ++k) result.push_back({0.377 * k - 9, 0.619 * k - 20, 0.113 * k - 3});
    return result;
}

// Catches factors of the wrong distances, measures without their root, cells left out too early, and an offset that is
// no further dimension.
TEST(Crackle, FormsAreSumsOfDistances) {
    for (const double metric : {1.0, 2.0, 3.0, 5.5}) {
        for (const double offset : {0.0, 0.4}) {
            for (const Vec3d form : {Vec3d{0.5, 0, 0}, {0, 0.4, 0}, {0, 0, 0.3}, {-0.5, 0.2, 0.2}, {-1, 1, 0}}) {
                scene::CrackleForm crackle;
                crackle.form = form;
                crackle.metric = metric;
                crackle.offset = offset;
                const Crackle pattern(crackle);
                for (const Vec3d& p : places()) {
                    std::vector<double> d = distances(p, metric);
                    for (double& x : d) x = std::pow(std::pow(x, metric) + std::pow(offset, metric), 1 / metric);
                    const double sum = form.x * d[0] + form.y * d[1] + form.z * d[2];
                    EXPECT_NEAR(pattern.at(p), std::clamp(sum, 0.0, 1.0), 2e-5) << metric << ' ' << offset;
                }
            }
        }
    }
}

// Catches cells of several values, and all cells of one.
TEST(Crackle, SolidCellsHaveOneValueEach) {
    scene::CrackleForm crackle;
    crackle.solid = true;
    const Crackle pattern(crackle);
    std::set<double> values;
    double sum = 0;
    int inner = 0;
    for (const Vec3d& p : places()) {
        const std::vector<double> d = distances(p, 2);
        const double value = pattern.at(p);
        values.insert(value);
        sum += value;
        constexpr double kStep = 0.05;
        if (d[1] - d[0] < 2.1 * kStep) continue;  // the border is near
        ++inner;
        for (const Vec3d step : {Vec3d{kStep, 0, 0}, {-kStep, 0, 0}, {0, kStep, 0}, {0, 0, -kStep}})
            EXPECT_EQ(pattern.at(p + step), value);
    }
    EXPECT_GT(inner, 20);
    EXPECT_GT(values.size(), 30U);
    EXPECT_NEAR(sum / 60, 0.5, 0.15);
}

}  // namespace
}  // namespace sundog::fields
