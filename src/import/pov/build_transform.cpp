// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_transform.h"

#include <array>
#include <cmath>
#include <numbers>

namespace sundog::pov {
namespace {

/// The turn by which `from` becomes `to`, both among the axes x = 0, y = 1, z = 2.
Affine3d turn(std::size_t from, std::size_t to, double angle_deg) {
    const double angle = angle_deg * (std::numbers::pi / 180);
    // Quarter turns are written everywhere and are to be exact: a box turned by one is still a box along the axes.
    const double quarters = angle_deg / 90;
    double c = std::cos(angle);
    double s = std::sin(angle);
    if (quarters == std::floor(quarters)) {
        constexpr std::array<double, 4> kCos{1, 0, -1, 0};
        const auto quarter = static_cast<std::size_t>(quarters - 4 * std::floor(quarters / 4));
        c = kCos[quarter], s = kCos[(quarter + 3) % 4];
    }
    std::array<Vec3d, 3> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    columns[from] = {}, columns[to] = {};
    columns[from][from] = c, columns[from][to] = s;
    columns[to][from] = -s, columns[to][to] = c;
    return {columns[0], columns[1], columns[2], {}};
}

Affine3d scaling_of(ItemReader& items, Vec3d size) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (size[axis] != 0) continue;
        items.warn("a scale of 0; 1 is taken instead");
        size[axis] = 1;
    }
    return {{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}, {}};
}

/// Twelve numbers: where x, y, z and the origin go.
Affine3d matrix_of(ItemReader& items) {
    const Place start = items.taken_where();
    std::array<double, 12> m{};
    for (std::size_t i = 0; i < m.size();) {
        const Value& v = items.value("a matrix of 12 numbers");
        for (std::size_t k = 0; k < v.count && i < m.size(); ++k) m[i++] = v.v[k];
    }
    const Affine3d matrix{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
    const double d = determinant(matrix);
    if (d == 0 || !std::isfinite(1 / d))
        items.context().fail(start, "a matrix without inverse", "its first nine numbers make everything flat");
    return matrix;
}

}  // namespace

Affine3d rotation_about_axes(Vec3d angles_deg) {
    return turn(0, 1, angles_deg.z) * (turn(2, 0, angles_deg.y) * turn(1, 2, angles_deg.x));
}

Affine3d transform_of(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    Affine3d result;
    bool inverted = false;
    while (!items.at_end()) {
        if (items.take(Keyword::inverse)) {
            inverted = true;
        } else if (!read_transform(items, result)) {
            static constexpr std::array kValid{Keyword::translate, Keyword::rotate,    Keyword::scale,
                                               Keyword::matrix,    Keyword::transform, Keyword::inverse};
            items.unexpected(kValid);
        }
    }
    return inverted ? inverse(result) : result;
}

bool read_transform(ItemReader& items, Affine3d& placed_from_local) {
    if (const auto block = items.take_block(Keyword::transform)) {
        placed_from_local = transform_of(items.context(), *block) * placed_from_local;
        return true;
    }
    const std::optional<Keyword> keyword = items.peek_keyword();
    if (!keyword) return false;
    switch (*keyword) {
        case Keyword::translate:
            items.skip();
            placed_from_local.t += items.vector("a vector to translate by");
            return true;
        case Keyword::rotate:
            items.skip();
            placed_from_local =
                rotation_about_axes(items.vector("a vector of angles to rotate by")) * placed_from_local;
            return true;
        case Keyword::scale:
            items.skip();
            placed_from_local = scaling_of(items, items.vector("a vector to scale by")) * placed_from_local;
            return true;
        case Keyword::matrix:
            items.skip();
            placed_from_local = matrix_of(items) * placed_from_local;
            return true;
        case Keyword::transform: {  // transform Identifier
            items.skip();
            const auto named = items.take_block(Keyword::transform);
            if (!named) items.unexpected("the name of a transform, or '{'");
            placed_from_local = transform_of(items.context(), *named) * placed_from_local;
            return true;
        }
        default:
            return false;
    }
}

}  // namespace sundog::pov
