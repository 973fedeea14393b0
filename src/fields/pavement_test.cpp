// SPDX-License-Identifier: Apache-2.0
#include "fields/pavement.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>
#include <vector>

#include "base/diagnostics.h"
#include "fields/pigment_evaluator.h"

namespace sundog::fields {
namespace {

/// Square (i, j), or one of the two triangles there.
using Cell = std::array<int, 3>;

Pavement pavement(int sides, int tiles, int pattern) {
    scene::PavementForm form;
    form.sides = sides;
    form.tiles = tiles;
    form.pattern = pattern;
    return Pavement(form);
}

std::vector<Cell> beside(const Pavement& paved, int sides, const Cell& cell) {
    const auto [i, j, upper] = cell;
    std::vector<Cell> cells;
    const auto add = [&](bool border, const Cell& next) {
        if (!border) cells.push_back(next);
    };
    if (sides == 4) {
        add(paved.border(i, j, 1), {i - 1, j, 0});
        add(paved.border(i + 1, j, 1), {i + 1, j, 0});
        add(paved.border(i, j, 0), {i, j - 1, 0});
        add(paved.border(i, j + 1, 0), {i, j + 1, 0});
    } else if (upper == 0) {
        add(paved.border(i, j, 0), {i, j - 1, 1});
        add(paved.border(i, j, 1), {i - 1, j, 1});
        add(paved.border(i, j, 2), {i, j, 1});
    } else {
        add(paved.border(i, j + 1, 0), {i, j + 1, 0});
        add(paved.border(i + 1, j, 1), {i + 1, j, 0});
        add(paved.border(i, j, 2), {i, j, 0});
    }
    return cells;
}

/// The tile around a cell; no more than `most` of its cells.
std::set<Cell> tile_of(const Pavement& paved, int sides, const Cell& start, std::size_t most) {
    std::set<Cell> tile{start};
    std::vector<Cell> open{start};
    while (!open.empty() && tile.size() <= most) {
        const Cell cell = open.back();
        open.pop_back();
        for (const Cell& next : beside(paved, sides, cell))
            if (tile.insert(next).second) open.push_back(next);
    }
    return tile;
}

// Catches slips in the table: a border too many or too few cuts a tile or joins two.
TEST(Pavement, AllTilesHaveTheirNumberOfCells) {
    for (const int sides : {3, 4, 6}) {
        for (int tiles = 1; tiles <= 6; ++tiles) {
            for (int pattern = 1; pattern <= arrangement_count(sides, tiles); ++pattern) {
                const Pavement paved = pavement(sides, tiles, pattern);
                const std::size_t wanted = static_cast<std::size_t>(tiles) * (sides == 6 ? 6 : 1);
                for (int i = -6; i < 6; ++i)
                    for (int j = -6; j < 6; ++j)
                        for (int upper = 0; upper <= (sides == 4 ? 0 : 1); ++upper)
                            EXPECT_EQ(tile_of(paved, sides, {i, j, upper}, wanted).size(), wanted)
                                << sides << " sides, " << tiles << " tiles, pattern " << pattern << " at " << i << ' '
                                << j;
            }
        }
    }
}

// The numbers of the reference's table. Catches patterns that are left out.
TEST(Pavement, CountsAreThoseOfTheReference) {
    constexpr std::array<std::array<int, 6>, 3> kCounts{
        {{1, 1, 1, 3, 4, 12}, {1, 1, 2, 5, 12, 35}, {1, 1, 3, 7, 22, 0}}};
    constexpr std::array<int, 3> kSides{3, 4, 6};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t tiles = 0; tiles < 6; ++tiles)
            EXPECT_EQ(arrangement_count(kSides[k], static_cast<int>(tiles) + 1), kCounts[k][tiles]);
    EXPECT_EQ(find_arrangement(5, 1, 1), nullptr);
}

// Catches borders of the wrong width: 0 in the middle of a cell, 1 at its sides, half way between.
TEST(Pavement, BordersFallToTheMiddleOfTheSmallestCells) {
    const Pavement squares = pavement(4, 1, 1);
    EXPECT_NEAR(squares.at(0.5, 0.5), 0, 1e-12);
    EXPECT_NEAR(squares.at(7.25, -2.5), 0.5, 1e-12);
    const Pavement hexagons = pavement(6, 1, 1);
    EXPECT_NEAR(hexagons.at(1, 0), 0, 1e-12);                     // its middle
    EXPECT_NEAR(hexagons.at(1, 0.8660254037844386), 1, 1e-9);     // a side's
    EXPECT_NEAR(hexagons.at(1, 0.72168783648703216), 0.5, 1e-9);  // half an inradius of a triangle within
}

// Catches scenes that name more than there is and silently get something else.
TEST(Pavement, NumbersBeyondTheLastAreErrors) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->kind = scene::Pigment::Kind::mapped;
    pigment->pattern.kind = scene::Pattern::Kind::pavement;
    pigment->pattern.pavement.tiles = 3;
    pigment->entries.push_back({0, {0, 0, 0}, nullptr});
    const auto compile = [&](int pattern) {
        pigment->pattern.pavement.pattern = pattern;
        const std::array pigments{std::shared_ptr<const scene::Pigment>(pigment)};
        const PigmentEvaluator evaluator(pigments, {});
    };
    EXPECT_NO_THROW(compile(2));
    EXPECT_THROW(compile(3), InputError);
}

}  // namespace
}  // namespace sundog::fields
