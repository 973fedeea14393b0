// SPDX-License-Identifier: Apache-2.0
#include "fields/tilings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace sundog::fields {
namespace {

constexpr double kRoot2 = std::numbers::sqrt2;
constexpr double kRoot3 = std::numbers::sqrt3;
constexpr double kTriangle = kRoot3 / 6;  ///< Inradius of a triangle of unit sides.
constexpr double kHeight = kRoot3 / 2;    ///< Its height.

PlaneVec operator+(PlaneVec a, PlaneVec b) { return {a.x + b.x, a.z + b.z}; }
PlaneVec operator-(PlaneVec a, PlaneVec b) { return {a.x - b.x, a.z - b.z}; }
PlaneVec operator*(PlaneVec a, double s) { return {a.x * s, a.z * s}; }
double dot(PlaneVec a, PlaneVec b) { return a.x * b.x + a.z * b.z; }

/// A regular tile of unit sides with a corner at an angle, in degrees from x to z, seen from its centre.
Tile regular(int type, int sides, double corner_deg, PlaneVec centre) {
    Tile tile{type, {}};
    const double radius = 0.5 / std::sin(std::numbers::pi / sides);
    for (int i = 0; i < sides; ++i) {
        const double angle = corner_deg * std::numbers::pi / 180 + 2 * std::numbers::pi * i / sides;
        tile.corners.push_back(centre + PlaneVec{std::cos(angle), std::sin(angle)} * radius);
    }
    return tile;
}

/// A rectangle with sides along x and z.
Tile box(int type, PlaneVec size, PlaneVec centre) {
    const PlaneVec h = size * 0.5;
    return {type, {centre - h, centre + PlaneVec{h.x, -h.z}, centre + h, centre + PlaneVec{-h.x, h.z}}};
}
Tile square(int type, PlaneVec centre) { return box(type, {1, 1}, centre); }
Tile lying(int type, PlaneVec centre) { return box(type, {2, 1}, centre); }
Tile standing(int type, PlaneVec centre) { return box(type, {1, 2}, centre); }

/// Triangles that point along z and against it, by their lower left and upper left corners.
Tile upwards(int type, PlaneVec corner) {
    return {type, {corner, corner + PlaneVec{1, 0}, corner + PlaneVec{0.5, kHeight}}};
}
Tile downwards(int type, PlaneVec corner) {
    return {type, {corner, corner + PlaneVec{0.5, -kHeight}, corner + PlaneVec{1, 0}}};
}

/// Picture frames around squares of the side root 2, mitred; `types`: of the sides right, left, above and below of the
/// frames' common corner, then the square's.
std::vector<Tile> frames(std::array<int, 5> types) {
    constexpr double w = kRoot2 / 2;
    return {{types[0], {{0, 0}, {w, w}, {w, 3 * w}, {0, 4 * w}}},
            {types[1], {{0, 0}, {0, 4 * w}, {-w, 3 * w}, {-w, w}}},
            {types[2], {{0, 0}, {4 * w, 0}, {3 * w, w}, {w, w}}},
            {types[3], {{0, 0}, {w, -w}, {3 * w, -w}, {4 * w, 0}}},
            box(types[4], {kRoot2, kRoot2}, {kRoot2, kRoot2})};
}

constexpr double kTiltedX = (0.5 - kHeight) / 2;  ///< A square's centre, seen from a corner, that is turned by 60
constexpr double kTiltedZ = (0.5 + kHeight) / 2;  ///< degrees from where its sides are along x and z.

/// 3.4.6.4; `types`: of the squares by their turns (0, -60 and 60 degrees), of the triangles that point along x and
/// against it, of the hexagon.
Tiling hexagons_in_squares(int count, std::array<int, 6> types) {
    return {count,
            {{{1.5 + kHeight, 0.5 + kHeight}, {0, 1 + kRoot3}}},
            kTriangle,
            {square(types[0], {0.5 + kHeight, 0}), regular(types[1], 4, -15, {-kTiltedX, kTiltedZ}),
             regular(types[2], 4, 15, {-kTiltedX, -kTiltedZ}),
             regular(types[3], 3, 0, {kHeight - 0.5 - kRoot3 / 3, 0.5 + kHeight}),
             regular(types[4], 3, 180, {kRoot3 / 3, 0}), regular(types[5], 6, 0, {-1, 0})}};
}

/// 4.6.12; `types`: of the squares by their turns (0, 60 and -60 degrees), of the dodecagon. Hexagons are type 0.
Tiling dodecagons(int count, std::array<int, 4> types) {
    constexpr double a = 0.5 + kHeight;  // from a square's middle to the nearest corner of a hexagon beyond its side
    return {count,
            {{{3 + kRoot3, 0}, {1 + a, 3 * a}}},
            0.5,
            {regular(0, 6, 0, {0, a}), regular(0, 6, 0, {1 + a, 0}), square(types[0], {0, 2 * a}),
             regular(types[1], 4, -15, {-0.5 - kTiltedZ, a / 2}), regular(types[2], 4, 15, {0.5 + kTiltedZ, a / 2}),
             regular(types[3], 12, 15, {0, -a})}};
}

/// Hexagons in a net of triangles, each with its own ring of six and two more (3.3.3.3.6): the triangles that point
/// upwards and downwards by their left corners, in the net's coordinates (along x, along the left sides).
Tiling snub_hexagons(std::array<PlaneVec, 2> periods, PlaneVec hexagon, const std::array<PlaneVec, 4>& up,
                     const std::array<PlaneVec, 4>& down) {
    const auto corner = [](PlaneVec net) { return PlaneVec{net.x + net.z / 2, net.z * kHeight}; };
    Tiling tiling{3, {corner(periods[0]), corner(periods[1])}, kTriangle, {regular(2, 6, 0, corner(hexagon))}};
    for (const PlaneVec& at : up) tiling.tiles.push_back(upwards(0, corner(at)));
    for (const PlaneVec& at : down) tiling.tiles.push_back(downwards(1, corner(at)));
    return tiling;
}

Tiling of_squares_and_dominoes(int number) {
    switch (number) {
        case 1:
            return {1, {{{1, 0}, {0, 1}}}, 0.5, {square(0, {0.5, 0.5})}};
        case 6:
            return {2, {{{2, -2}, {1, 1}}}, 0.5, {lying(0, {1, -0.5}), standing(1, {-0.5, 0})}};
        case 10:
            return {1, {{{1, 0}, {0.5, 1}}}, 0.5, {square(0, {0.5, 0.5})}};
        case 11:
            return {3,
                    {{{3, 0}, {0, 3}}},
                    0.5,
                    {square(0, {1.5, 1.5}), lying(1, {2, 0.5}), lying(1, {1, 2.5}), standing(2, {0.5, 1}),
                     standing(2, {-0.5, 2})}};
        case 12:
            return {3,
                    {{{3, 3}, {3, -3}}},
                    0.5,
                    {square(0, {1.5, 1.5}), square(0, {-1.5, 1.5}), lying(1, {2, 0.5}), lying(1, {2, -0.5}),
                     lying(1, {-2, 0.5}), lying(1, {-2, -0.5}), standing(2, {0.5, 1}), standing(2, {0.5, -1}),
                     standing(2, {-0.5, 1}), standing(2, {-0.5, -1})}};
        case 15:
            return {2, {{{2, 1}, {-1, 2}}}, 0.5, {square(0, {0.5, 0.5}), box(1, {2, 2}, {0, -1})}};
        default:  // 18
            return {2,
                    {{{2, 2}, {2, -2}}},
                    0.5,
                    {lying(0, {-1, 0.5}), lying(0, {-1, 1.5}), standing(1, {0.5, 1}), standing(1, {1.5, 1})}};
    }
}

Tiling of_triangles_and_rhombs(int number) {
    switch (number) {
        case 3:
            return {2, {{{1, 0}, {0.5, kHeight}}}, kTriangle, {upwards(0, {0, 0}), downwards(1, {-0.5, kHeight})}};
        case 4:
            return {
                1, {{{1, 0}, {0.5, kHeight}}}, kHeight / 2, {{0, {{0, 0}, {1, 0}, {1.5, kHeight}, {0.5, kHeight}}}}};
        case 5:
            return {3,
                    {{{1.5, kHeight}, {0, kRoot3}}},
                    kHeight / 2,
                    {{0, {{0, 0}, {1, 0}, {1.5, kHeight}, {0.5, kHeight}}},
                     {1, {{0, 0}, {0.5, kHeight}, {0, kRoot3}, {-0.5, kHeight}}},
                     {2, {{0, 0}, {-0.5, kHeight}, {-1.5, kHeight}, {-1, 0}}}}};
        default:  // 8
            return {3,
                    {{{1, 0}, {0.5, 1 + kHeight}}},
                    kTriangle,
                    {upwards(0, {-0.5, -kHeight}), downwards(1, {0, 0}), square(2, {0.5, 0.5})}};
    }
}

/// The archimedean tilings with hexagons, octagons and dodecagons, and the snub squares.
Tiling of_large_tiles(int number) {
    constexpr double a = (1 + kRoot2) / 2;  // inradius of an octagon of unit sides
    constexpr double b = 0.5 + kHeight;
    constexpr double reach = 1 + kHeight;  // inradius of a dodecagon of unit sides
    switch (number) {
        case 2:
            return {1, {{{1.5, kHeight}, {0, kRoot3}}}, kHeight, {regular(0, 6, 0, {-1, 0})}};
        case 7:
            return {2, {{{2 * a, 0}, {0, 2 * a}}}, 0.5, {regular(0, 4, 0, {a, a}), regular(1, 8, 22.5, {0, 0})}};
        case 9:
            return {3,
                    {{{2, 0}, {1, kRoot3}}},
                    kTriangle,
                    {upwards(0, {-1, 0}), downwards(1, {0, 0}), regular(2, 6, 0, {0.5, kHeight})}};
        case 16:
            return hexagons_in_squares(3, {0, 0, 0, 1, 1, 2});
        case 17:
            return hexagons_in_squares(6, {0, 1, 2, 3, 4, 5});
        case 19:
            return snub_hexagons({{{3, -1}, {1, 2}}}, {-1, 0}, {{{0, -1}, {0, 0}, {-1, 1}, {0, -2}}},
                                 {{{-1, 1}, {0, 0}, {0, 1}, {0, -1}}});
        case 20:
            return snub_hexagons({{{3, -2}, {2, 1}}}, {1, -1}, {{{0, 0}, {-1, 0}, {-1, -1}, {-1, 1}}},
                                 {{{-1, 1}, {-1, 0}, {0, 1}, {-2, 2}}});
        case 21:
            return {6,
                    {{{b, b}, {b, -b}}},
                    kTriangle,
                    {regular(0, 3, 0, {kTriangle, 0}), regular(1, 3, -90, {0, 0.5 + kRoot3 / 3}),
                     regular(2, 3, 180, {-kTriangle, 0}), regular(3, 3, 90, {0, -0.5 - kRoot3 / 3}),
                     regular(4, 4, 15, {kTiltedZ, kTiltedZ}), regular(5, 4, -15, {kTiltedZ, -kTiltedZ})}};
        case 22: {
            Tile dodecagon = regular(2, 12, 15, {0, 0.5 - reach});
            dodecagon.flatter = {5, 8, 11};  // against what the reference says, but as povray's pictures show it
            return {3,
                    {{{2 * reach, 0}, {reach, reach * kRoot3}}},
                    kTriangle,
                    {upwards(0, {-0.5, 0.5}), downwards(1, {reach - 0.5, 0}), std::move(dodecagon)}};
        }
        case 23:
            return dodecagons(3, {1, 1, 1, 2});
        default:  // 24
            return dodecagons(5, {1, 3, 2, 4});
    }
}

/// Whether a tile and the parallelogram of two periods from the origin on may overlap: no line along a side of either
/// parts them.
bool overlap(const std::vector<PlaneVec>& tile, const std::vector<PlaneVec>& cell) {
    const auto parted = [](const std::vector<PlaneVec>& sides, const std::vector<PlaneVec>& other) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const PlaneVec side = sides[(i + 1) % sides.size()] - sides[i];
            const PlaneVec outwards{side.z, -side.x};
            const auto beyond = [&](PlaneVec p) { return dot(outwards, p - sides[i]) > -1e-9; };
            if (std::all_of(other.begin(), other.end(), beyond)) return true;
        }
        return false;
    };
    return !parted(tile, cell) && !parted(cell, tile);
}

}  // namespace

Tiling periodic_tiling(int number) {
    switch (number) {
        case 1:
        case 6:
        case 10:
        case 11:
        case 12:
        case 15:
        case 18:
            return of_squares_and_dominoes(number);
        case 3:
        case 4:
        case 5:
        case 8:
            return of_triangles_and_rhombs(number);
        case 13:
            return {3, {{{2 * kRoot2, 0}, {0, 2 * kRoot2}}}, kRoot2 / 4, frames({2, 2, 1, 1, 0})};
        case 14:
            return {5, {{{2 * kRoot2, 0}, {0, 2 * kRoot2}}}, kRoot2 / 4, frames({1, 0, 2, 3, 4})};
        default:
            return of_large_tiles(number);
    }
}

std::vector<std::uint32_t> tiling_words(const Tiling& tiling) {
    std::vector<std::uint32_t> words;
    const auto put = [&](double value) { words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value))); };
    PlaneVec a = tiling.periods[0];
    PlaneVec b = tiling.periods[1];
    if (a.x * b.z - a.z * b.x < 0) std::swap(a, b);
    const double area = a.x * b.z - a.z * b.x;
    put(b.z / area), put(-b.x / area), put(-a.z / area), put(a.x / area);
    put(a.x), put(a.z), put(b.x), put(b.z);
    put(tiling.types), put(1 / tiling.bevel);
    const std::size_t count_at = words.size();
    words.push_back(0);
    const std::vector<PlaneVec> cell{{0, 0}, a, a + b, b};
    for (const Tile& tile : tiling.tiles) {
        constexpr int kReach = 6;  // periods that a tile may lie away from the origin
        for (int i = -kReach; i <= kReach; ++i) {
            for (int j = -kReach; j <= kReach; ++j) {
                std::vector<PlaneVec> corners = tile.corners;
                for (PlaneVec& corner : corners) corner = corner + a * i + b * j;
                if (!overlap(corners, cell)) continue;
                ++words[count_at];
                words.push_back(static_cast<std::uint32_t>(tile.type));
                words.push_back(static_cast<std::uint32_t>(corners.size()));
                for (std::size_t k = 0; k < corners.size(); ++k) {
                    const PlaneVec side = corners[(k + 1) % corners.size()] - corners[k];
                    const bool flat = std::find(tile.flatter.begin(), tile.flatter.end(), k) != tile.flatter.end();
                    const double steepness = flat ? kHeight : 1;
                    const PlaneVec outwards = PlaneVec{side.z, -side.x} * (steepness / std::sqrt(dot(side, side)));
                    put(outwards.x), put(outwards.z), put(dot(outwards, corners[k]));
                }
            }
        }
    }
    return words;
}

}  // namespace sundog::fields
