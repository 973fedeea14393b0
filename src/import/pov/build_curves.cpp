// SPDX-License-Identifier: Apache-2.0
// Shapes made of lists of points, coefficients or components.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "import/pov/build_shape.h"
#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

/// The most points that a curve may have.
constexpr int kMostPoints = 10'000'000;

scene::SplineKind read_spline_kind(ItemReader& items) {
    if (items.take(Keyword::linear_spline)) return scene::SplineKind::linear;
    if (items.take(Keyword::quadratic_spline)) return scene::SplineKind::quadratic;
    if (items.take(Keyword::cubic_spline)) return scene::SplineKind::cubic;
    if (items.take(Keyword::bezier_spline)) return scene::SplineKind::bezier;
    return scene::SplineKind::linear;
}

std::vector<std::array<double, 2>> read_points(ItemReader& items, int least) {
    const int count = items.integer("the number of points", 0, kMostPoints);
    if (count < least) items.fail("too few points", "this curve needs at least " + std::to_string(least));
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < count; ++i) points.push_back(items.vector2("a point of two coordinates"));
    return points;
}

int least_points(scene::SplineKind kind) {
    switch (kind) {
        case scene::SplineKind::linear:
            return 2;
        case scene::SplineKind::quadratic:
            return 3;
        default:
            return 4;
    }
}

void check_bezier(ItemReader& items, scene::SplineKind kind, std::size_t count) {
    if (kind == scene::SplineKind::bezier && count % 4 != 0)
        items.fail("a bezier_spline of " + std::to_string(count) + " points", "each of its segments has 4");
}

/// The coefficients that follow, x's highest power first, then y's, then z's.
scene::Polynomial read_terms(ItemReader& items, int order) {
    scene::Polynomial result;
    result.order = order;
    Value pending;  // A vector's components count one by one.
    std::uint8_t used = 1;
    const auto next = [&] {
        if (used >= pending.count || pending.count == 1) {
            pending = items.value("a coefficient");
            used = 0;
        }
        return pending.v[used++];
    };
    for (int x = order; x >= 0; --x) {
        for (int y = order - x; y >= 0; --y) {
            for (int z = order - x - y; z >= 0; --z) {
                const double coefficient = next();
                if (coefficient == 0) continue;
                result.terms.push_back({static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                                        static_cast<std::uint8_t>(z), coefficient});
            }
        }
    }
    return result;
}

}  // namespace

NodeShape read_polynomial(ItemReader& items, Keyword keyword) {
    if (keyword == Keyword::cubic) return read_terms(items, 3);
    if (keyword == Keyword::quartic) return read_terms(items, 4);
    constexpr int kMostOrder = 35;
    return read_terms(items, items.integer("an order", 2, kMostOrder));
}

NodeShape read_quadric(ItemReader& items) {
    const Vec3d squares = items.vector("the factors of x*x, y*y and z*z");
    const Vec3d mixed = items.vector("the factors of x*y, x*z and y*z");
    const Vec3d linear = items.vector("the factors of x, y and z");
    const double constant = items.number("the constant");
    scene::Polynomial quadric;
    const auto add = [&](std::uint8_t x, std::uint8_t y, std::uint8_t z, double coefficient) {
        if (coefficient != 0) quadric.terms.push_back({x, y, z, coefficient});
    };
    add(2, 0, 0, squares.x), add(0, 2, 0, squares.y), add(0, 0, 2, squares.z);
    add(1, 1, 0, mixed.x), add(1, 0, 1, mixed.y), add(0, 1, 1, mixed.z);
    add(1, 0, 0, linear.x), add(0, 1, 0, linear.y), add(0, 0, 1, linear.z);
    add(0, 0, 0, constant);
    return quadric;
}

NodeShape read_lathe(ItemReader& items) {
    scene::Lathe lathe;
    lathe.spline = read_spline_kind(items);
    lathe.points = read_points(items, least_points(lathe.spline));
    check_bezier(items, lathe.spline, lathe.points.size());
    return lathe;
}

NodeShape read_surface_of_revolution(ItemReader& items) {
    scene::SurfaceOfRevolution sor;
    sor.points = read_points(items, 4);
    sor.open = items.take(Keyword::open);
    return sor;
}

NodeShape read_prism(ItemReader& items) {
    scene::Prism prism;
    while (const std::optional<Keyword> keyword = items.peek_keyword()) {
        if (*keyword == Keyword::linear_sweep || *keyword == Keyword::conic_sweep) {
            prism.conic = *keyword == Keyword::conic_sweep;
        } else if (*keyword == Keyword::linear_spline) {
            prism.spline = scene::SplineKind::linear;
        } else if (*keyword == Keyword::quadratic_spline) {
            prism.spline = scene::SplineKind::quadratic;
        } else if (*keyword == Keyword::cubic_spline) {
            prism.spline = scene::SplineKind::cubic;
        } else if (*keyword == Keyword::bezier_spline) {
            prism.spline = scene::SplineKind::bezier;
        } else {
            break;
        }
        items.skip();
    }
    const double a = items.number("a height of the prism");
    const double b = items.number("the other height of the prism");
    prism.lower = std::min(a, b), prism.upper = std::max(a, b);
    prism.points = read_points(items, least_points(prism.spline) + 1);
    check_bezier(items, prism.spline, prism.points.size());
    prism.open = items.take(Keyword::open);
    return prism;
}

NodeShape read_sphere_sweep(ItemReader& items) {
    scene::SphereSweep sweep;
    using Kind = scene::SphereSweep::Kind;
    int least = 2;
    if (items.take(Keyword::linear_spline)) {
        sweep.kind = Kind::linear;
    } else if (items.take(Keyword::b_spline)) {
        sweep.kind = Kind::b_spline, least = 4;
    } else if (items.take(Keyword::cubic_spline)) {
        sweep.kind = Kind::cubic, least = 4;
    } else {
        items.unexpected("linear_spline, b_spline or cubic_spline");
    }
    const int count = items.integer("the number of spheres", 0, kMostPoints);
    if (count < least) items.fail("too few spheres", "this sweep needs at least " + std::to_string(least));
    for (int i = 0; i < count; ++i) {
        const Vec3d center = items.vector("the center of a sphere");
        sweep.points.push_back({center, items.number("the radius of a sphere")});
    }
    return sweep;
}

NodeShape read_polygon(ItemReader& items) {
    const int count = items.integer("the number of points", 3, kMostPoints);
    scene::FlatPolygon polygon;
    std::vector<Vec3d> outline;
    for (int i = 0; i < count; ++i) {
        const Vec3d point = items.vector("a point of the polygon");
        if (!outline.empty() && point == outline.front()) {
            if (outline.size() > 2) polygon.outlines.push_back(std::move(outline));
            outline.clear();
        } else {
            outline.push_back(point);
        }
    }
    if (outline.size() > 2) polygon.outlines.push_back(std::move(outline));
    if (!polygon.outlines.empty()) return polygon;
    items.warn("a polygon without area; left out");
    return {};
}

}  // namespace sundog::pov
