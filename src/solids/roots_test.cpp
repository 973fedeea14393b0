// SPDX-License-Identifier: Apache-2.0
#include "solids/roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace sundog::solids {
namespace {

/// Coefficients, lowest first, of the product of (t - root) over all roots.
std::vector<double> polynomial_with(const std::vector<double>& roots) {
    std::vector<long double> c{1};
    for (const double r : roots) {
        c.push_back(0);
        for (std::size_t i = c.size() - 1; i > 0; --i) c[i] = c[i - 1] - r * c[i];
        c[0] *= -r;
    }
    return {c.begin(), c.end()};
}

void expect_roots(const std::vector<double>& expected, const RootList& found, double tolerance) {
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(expected[i], found[i], tolerance);
}

// Catches lost roots, roots found twice, wrong order: random quartics and sextics whose roots are known.
TEST(Roots, AllSimpleRootsInTheIntervalAreFound) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1, 4);
    for (int trial = 0; trial < 2000; ++trial) {
        const int degree = 2 + trial % 5;
        std::vector<double> roots;
        while (static_cast<int>(roots.size()) < degree) {
            const double r = place(random);
            if (std::all_of(roots.begin(), roots.end(), [&](double o) { return std::abs(o - r) > 0.02; }))
                roots.push_back(r);
        }
        std::sort(roots.begin(), roots.end());
        RootList found;
        append_roots(polynomial_with(roots), 0.5, 3, found);
        std::erase_if(roots, [](double r) { return !(r > 0.5 && r < 3); });
        expect_roots(roots, found, 1e-8);
    }
}

// Catches a solver that gives up on nearly double roots: a grazing ray's two crossings lie close together.
TEST(Roots, NearlyDoubleRootsAreBothFound) {
    for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5}) {
        RootList found;
        append_roots(polynomial_with({0.25, 0.6, 0.6 + gap, 1.75}), 0, 2, found);
        ASSERT_EQ(4U, found.size()) << gap;
        EXPECT_NEAR(0.6, found[1], 1e-3 * gap);
        EXPECT_NEAR(0.6 + gap, found[2], 1e-3 * gap);
    }
}

// Catches double roots counted once (a sign change that isn't there) and triple roots lost.
TEST(Roots, OnlyChangesOfSignCount) {
    RootList touching;
    append_roots(polynomial_with({0.5, 0.5}), 0, 1, touching);
    EXPECT_EQ(0U, touching.size() % 2);
    RootList triple;
    append_roots(polynomial_with({0.5, 0.5, 0.5}), 0, 1, triple);
    ASSERT_EQ(1U, triple.size() % 2);
    EXPECT_NEAR(0.5, triple[0], 1e-4);
    RootList dyadic;  // every subdivision point of the first levels is a root
    append_roots(polynomial_with({0.25, 0.5, 0.75}), 0, 1, dyadic);
    expect_roots({0.25, 0.5, 0.75}, dyadic, 1e-12);
}

// Catches intervals without an end: a ray that never leaves.
TEST(Roots, InfiniteIntervals) {
    const double inf = std::numeric_limits<double>::infinity();
    RootList found;
    append_roots(polynomial_with({-3, 2, 50, 1e6}), 0, inf, found);
    ASSERT_EQ(3U, found.size());
    EXPECT_NEAR(2, found[0], 1e-8);
    EXPECT_NEAR(50, found[1], 1e-7);
    EXPECT_NEAR(1e6, found[2], 1e-3);
    RootList from_below;
    append_roots(polynomial_with({-3, 2}), -10, inf, from_below);
    expect_roots({-3, 2}, from_below, 1e-10);
}

// Catches subdivision that loses roots of high degree: Chebyshev's polynomials have all theirs in [-1, 1].
TEST(Roots, ChebyshevOfDegree16) {
    std::vector<double> previous{1};
    std::vector<double> chebyshev{0, 1};
    for (int n = 2; n <= 16; ++n) {
        std::vector<double> next(chebyshev.size() + 1);
        for (std::size_t i = 0; i < chebyshev.size(); ++i) next[i + 1] += 2 * chebyshev[i];
        for (std::size_t i = 0; i < previous.size(); ++i) next[i] -= previous[i];
        previous = chebyshev;
        chebyshev = next;
    }
    RootList found;
    append_roots(chebyshev, -1, 1, found);
    ASSERT_EQ(16U, found.size());
    for (int k = 0; k < 16; ++k)
        EXPECT_NEAR(-std::cos(M_PI * (k + 0.5) / 16), found[static_cast<std::size_t>(k)], 1e-6);
}

// Catches a first root that isn't the first of all: one behind a turn that was passed over, or none where there is one.
TEST(Roots, TheFirstAlone) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    int found_any = 0;
    int late = 0;
    for (int round = 0; round < 20000; ++round) {
        std::array<double, 5> c;
        for (double& v : c) v = number(random);
        if (round % 2 == 0)
            c = {std::abs(c[0]) + 0.2, -std::abs(c[1]), std::abs(c[2]) + 0.3, -std::abs(c[3]) - 0.2, c[4]};
        RootList all;
        append_bernstein_roots(c, all);
        RootList first;
        append_first_bernstein_root(c, first);
        ASSERT_EQ(all.empty(), first.empty()) << round;
        if (all.empty()) continue;
        ASSERT_EQ(1U, first.size());
        EXPECT_NEAR(all[0], first[0], 1e-14) << round;
        ++found_any;
        if (round % 2 == 0 && all[0] > 0.6) ++late;
    }
    EXPECT_GT(found_any, 5000);
    EXPECT_GT(late, 100);
}

}  // namespace
}  // namespace sundog::solids
