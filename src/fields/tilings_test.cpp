// SPDX-License-Identifier: Apache-2.0
#include "fields/tilings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sundog::fields {
namespace {

double cross(PlaneVec a, PlaneVec b) { return a.x * b.z - a.z * b.x; }

double area_of(const Tile& tile) {
    double sum = 0;
    for (std::size_t i = 0; i < tile.corners.size(); ++i)
        sum += cross(tile.corners[i], tile.corners[(i + 1) % tile.corners.size()]) / 2;
    return sum;
}

/// How deep a point lies within a tile; negative outside.
double depth_in(const Tile& tile, PlaneVec p) {
    double depth = 1e9;
    for (std::size_t i = 0; i < tile.corners.size(); ++i) {
        const PlaneVec a = tile.corners[i], b = tile.corners[(i + 1) % tile.corners.size()];
        const PlaneVec side{b.x - a.x, b.z - a.z};
        depth = std::min(depth, cross(side, {p.x - a.x, p.z - a.z}) / std::hypot(side.x, side.z));
    }
    return depth;
}

class PeriodicTilings : public testing::TestWithParam<int> {};

// Catches tiles that are missing, lie on top of others, or run clockwise: as much area as the periods span, and no
// point in two of them.
TEST_P(PeriodicTilings, FillThePlaneOnce) {
    const Tiling tiling = periodic_tiling(GetParam());
    const double cell = std::abs(cross(tiling.periods[0], tiling.periods[1]));
    double sum = 0;
    for (const Tile& tile : tiling.tiles) sum += area_of(tile);
    EXPECT_NEAR(sum, cell, 1e-12);
    for (int k = 1; k < 300; ++k) {
        const PlaneVec p{std::fmod(0.618033989 * k, 1) * 3, std::fmod(0.414213562 * k, 1) * 3};
        int owners = 0;
        for (const Tile& tile : tiling.tiles)
            for (int i = -9; i <= 9; ++i)
                for (int j = -9; j <= 9; ++j)
                    if (depth_in(tile, {p.x - i * tiling.periods[0].x - j * tiling.periods[1].x,
                                        p.z - i * tiling.periods[0].z - j * tiling.periods[1].z}) > 1e-9)
                        ++owners;
        EXPECT_EQ(owners, 1) << p.x << ' ' << p.z;
    }
}

// Catches types out of range or without a tile, whose part of the map would be left out.
TEST_P(PeriodicTilings, HaveATileOfEachType) {
    const Tiling tiling = periodic_tiling(GetParam());
    std::vector<int> count(static_cast<std::size_t>(tiling.types));
    for (const Tile& tile : tiling.tiles) {
        ASSERT_GE(tile.type, 0);
        ASSERT_LT(tile.type, tiling.types);
        ++count[static_cast<std::size_t>(tile.type)];
    }
    for (const int tiles : count) EXPECT_GT(tiles, 0);
}

INSTANTIATE_TEST_SUITE_P(All, PeriodicTilings, testing::Range(1, kPeriodicTilings + 1));

}  // namespace
}  // namespace sundog::fields
