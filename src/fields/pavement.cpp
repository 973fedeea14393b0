// SPDX-License-Identifier: Apache-2.0
#include "fields/pavement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sundog::fields {
namespace {

constexpr double kRoot3 = std::numbers::sqrt3;
constexpr double kHeight = kRoot3 / 2;    ///< Of a triangle of unit sides.
constexpr double kInradius = kRoot3 / 6;  ///< Likewise; also the width of borders of triangles and hexagons.

struct Step {
    int i, j;
};
/// From a corner of triangles to its six neighbours, each 60 degrees from the one before.
constexpr std::array<Step, 6> kSteps{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};

int modulo(int a, int b) { return (a % b + b) % b; }
int floored(int a, int b) { return (a - modulo(a, b)) / b; }

double shade(double depth, double width) { return std::clamp(1 - depth / width, 0.0, 1.0); }

}  // namespace

Pavement::Pavement(const scene::PavementForm& form) : form_(form), tiles_(&arrangement_of(form)) {
    form_.sides = tiles_->sides;
}

const Arrangement& arrangement_of(const scene::PavementForm& form) {
    if (const Arrangement* tiles = find_arrangement(form.sides, form.tiles, form.pattern)) return *tiles;
    if (const Arrangement* tiles = find_arrangement(form.sides, form.tiles, 1)) return *tiles;
    return *find_arrangement(3, 1, 1);
}

unsigned Pavement::borders_of(int i, int j) const {
    const int k = floored(j, tiles_->height);
    const int column = modulo(i - k * tiles_->shift, tiles_->width);
    const int row = j - k * tiles_->height;
    return static_cast<unsigned>(tiles_->borders[static_cast<std::size_t>(row * tiles_->width + column)] - '0');
}

bool Pavement::border(int i, int j, int axis) const {
    constexpr std::array<unsigned, 3> kBits{2, 1, 4};  // the lower side, the left one, the one between both
    if (form_.sides != 6) return (borders_of(i, j) & kBits[static_cast<std::size_t>(axis)]) != 0;
    // The hexagon above the side, if it is one of a hexagon: its centre is the corner of triangles at (a, b).
    const int a = axis == 0 ? i : axis == 1 ? i - 1 : i + 1;
    const int b = j + 1;
    if (modulo(b - a + 1, 3) != 0) return false;
    const int along_z = (b - a + 1) / 3;
    constexpr std::array<unsigned, 3> kHexagonBits{2, 4, 1};
    return (borders_of(a - 1 + along_z, along_z) & kHexagonBits[static_cast<std::size_t>(axis)]) != 0;
}

/// Likewise, from a corner of triangles towards a neighbour by its number in kSteps.
bool Pavement::border_towards(int i, int j, int direction) const {
    switch (modulo(direction, 6)) {
        case 0:
            return border(i, j, 0);
        case 1:
            return border(i, j, 1);
        case 2:
            return border(i - 1, j, 2);
        case 3:
            return border(i - 1, j, 0);
        case 4:
            return border(i, j - 1, 1);
        default:
            return border(i, j - 1, 2);
    }
}

/// Whether a corner of triangles lies on a border.
bool Pavement::is_corner(int i, int j) const {
    for (int direction = 0; direction < 6; ++direction)
        if (border_towards(i, j, direction)) return true;
    return false;
}

double Pavement::at(double x, double z) const { return form_.sides == 4 ? in_square(x, z) : in_triangle(x, z); }

// Each third of a triangle belongs to its nearest corner; what the corner looks like depends on how many of the tile's
// triangles meet there: one (exterior), two (form), or more (interior: those between the two that have borders there).
double Pavement::in_triangle(double x, double z) const {
    const double v = z / kHeight;
    const double u = x - v / 2;
    const int i = static_cast<int>(std::floor(u));
    const int j = static_cast<int>(std::floor(v));
    const double fu = u - i;
    const double fv = v - j;
    // The nearest corner, and the direction of the triangle's first side from there.
    int corner_i = i, corner_j = j, first = 0;
    if (fu + fv <= 1) {
        if (fu > fv && fu > 1 - fu - fv) corner_i = i + 1, first = 2;
        else if (fv >= fu && fv > 1 - fu - fv) corner_j = j + 1, first = 4;
    } else {
        corner_i = i + 1, corner_j = j + 1, first = 3;
        const double near_upper_right = fu + fv - 1;
        if (1 - fu > 1 - fv && 1 - fu > near_upper_right) corner_i = i, first = 5;
        else if (1 - fv >= 1 - fu && 1 - fv > near_upper_right) corner_j = j, first = 1;
    }
    const double rx = x - (corner_i + corner_j * 0.5);
    const double rz = z - corner_j * kHeight;
    const double angle = first * std::numbers::pi / 3;
    const double along_first = rx * std::cos(angle) + rz * std::sin(angle);
    const double from_first = rz * std::cos(angle) - rx * std::sin(angle);
    const double along_second = along_first / 2 + from_first * kHeight;
    const double from_second = along_first * kHeight - from_first / 2;
    const double along_middle = (along_first + along_second) / kRoot3;
    const bool on_first = border_towards(corner_i, corner_j, first);
    const bool on_second = border_towards(corner_i, corner_j, first + 1);
    constexpr double kToMiddle = 1 / kRoot3;  // from a corner
    if (on_first && on_second) {
        const double plain = shade(std::min(from_first, from_second), kInradius);
        if (form_.exterior == 1) return std::max(plain, std::min((kToMiddle - along_middle) / kInradius, 1.0));
        if (form_.exterior == 2) {
            const double across = (from_first - from_second) / kRoot3;
            return std::min(std::hypot(across, kToMiddle - along_middle) / kInradius, 1.0);
        }
        return plain;
    }
    if (on_first || on_second) {
        const double plain = shade(on_first ? from_first : from_second, kInradius);
        const bool two_triangles = border_towards(corner_i, corner_j, on_first ? first + 2 : first - 1);
        if (!two_triangles || form_.form == 0 || form_.form == 3) return plain;
        const double along_shared = on_first ? along_second : along_first;
        const double from_shared = on_first ? from_second : from_first;
        if (form_.form == 1) return std::max(plain, std::clamp(2 - 4 * along_shared, 0.0, 1.0));
        return shade(kHeight - std::hypot(1 - along_shared, from_shared), kInradius);  // around the side's other end
    }
    if (!is_corner(corner_i, corner_j)) return 0;
    if (form_.interior == 1) return shade(kHeight * std::max(along_first, along_second), kInradius);
    return shade(form_.interior == 2 ? kHeight * std::hypot(rx, rz) : along_middle, kInradius);
}

// Each quarter of a square belongs to its nearest corner.
double Pavement::in_square(double x, double z) const {
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(z));
    const bool left = border(i, j, 1), right = border(i + 1, j, 1);
    const bool lower = border(i, j, 0), upper = border(i, j + 1, 0);
    const int corner_i = x - i < 0.5 ? i : i + 1;
    const int corner_j = z - j < 0.5 ? j : j + 1;
    const double dx = std::abs(x - corner_i);
    const double dz = std::abs(z - corner_j);
    const auto corner = [&](int ci, int cj) {
        return border(ci, cj, 0) || border(ci - 1, cj, 0) || border(ci, cj, 1) || border(ci, cj - 1, 1);
    };
    int exterior = form_.exterior, interior = form_.interior;
    if (left != right && lower != upper && form_.form != 3) {
        // Where a tile turns: outer and inner corner have a form of their own.
        const int inner_i = left ? i + 1 : i;
        const int inner_j = lower ? j + 1 : j;
        const double px = std::abs(x - inner_i);
        const double pz = std::abs(z - inner_j);
        if (corner(inner_i, inner_j)) {
            const double from_inner = form_.form == 1 ? px + pz : std::hypot(px, pz);
            if (form_.form != 0) return std::min(1.0, std::abs(2 * from_inner - 1));
            exterior = interior = 0;
        }
    }
    const bool on_x = corner_i == i ? left : right;
    const bool on_z = corner_j == j ? lower : upper;
    constexpr double kWidth = 0.5;
    if (on_x && on_z) {
        if (exterior == 1) return std::min(1.0, 2 - 2 * (dx + dz));
        if (exterior == 2) return std::min(1.0, 2 * std::hypot(0.5 - dx, 0.5 - dz));
        return shade(std::min(dx, dz), kWidth);
    }
    if (on_x || on_z) return shade(on_x ? dx : dz, kWidth);
    if (!corner(corner_i, corner_j)) return 0;
    if (interior == 1) return shade(dx + dz, kWidth);
    return shade(interior == 2 ? std::hypot(dx, dz) : std::max(dx, dz), kWidth);
}

}  // namespace sundog::fields
