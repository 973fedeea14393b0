// SPDX-License-Identifier: Apache-2.0
#include "solids/spline_curve.h"

#include <algorithm>

namespace sundog::solids {
namespace {

using Point = std::array<double, 2>;

/// Bezier's control point n third parts along a straight piece, and one derivative's third away from an end.
CurvePiece piece_of(Point a, Point b, Point c, Point d) {
    const auto is_even = [&](std::size_t k) {
        const double most = std::max({std::abs(a[k]), std::abs(b[k]), std::abs(c[k]), std::abs(d[k])});
        return std::abs(3 * b[k] - 2 * a[k] - d[k]) <= 4e-15 * most &&
               std::abs(3 * c[k] - a[k] - 2 * d[k]) <= 4e-15 * most;
    };
    return {{a[0], b[0], c[0], d[0]}, {a[1], b[1], c[1], d[1]}, is_even(0) && is_even(1)};
}
Point mixed(Point a, double wa, Point b, double wb) { return {wa * a[0] + wb * b[0], wa * a[1] + wb * b[1]}; }

CurvePiece straight(Point a, Point b) {
    return piece_of(a, mixed(a, 2.0 / 3, b, 1.0 / 3), mixed(a, 1.0 / 3, b, 2.0 / 3), b);
}
/// The parabola from b to c on which a lies one step before b.
CurvePiece parabola(Point a, Point b, Point c) {
    const Point slope_b = mixed(c, 0.5, a, -0.5);                  // derivative at b
    const Point slope_c = mixed(mixed(c, 1.5, b, -2), 1, a, 0.5);  // and at c
    return piece_of(b, mixed(b, 1, slope_b, 1.0 / 3), mixed(c, 1, slope_c, -1.0 / 3), c);
}
/// From b to c, with the slopes of Catmull and Rom.
CurvePiece catmull_rom(Point a, Point b, Point c, Point d) {
    const Point slope_b = mixed(c, 0.5, a, -0.5);
    const Point slope_c = mixed(d, 0.5, b, -0.5);
    return piece_of(b, mixed(b, 1, slope_b, 1.0 / 3), mixed(c, 1, slope_c, -1.0 / 3), c);
}

Curve piecewise(scene::SplineKind kind, const Point* p, std::size_t count) {
    Curve curve;
    switch (kind) {
        case scene::SplineKind::linear:
            for (std::size_t i = 0; i + 1 < count; ++i) curve.pieces.push_back(straight(p[i], p[i + 1]));
            break;
        case scene::SplineKind::quadratic:
            for (std::size_t i = 0; i + 2 < count; ++i) curve.pieces.push_back(parabola(p[i], p[i + 1], p[i + 2]));
            break;
        case scene::SplineKind::cubic:
            for (std::size_t i = 0; i + 3 < count; ++i)
                curve.pieces.push_back(catmull_rom(p[i], p[i + 1], p[i + 2], p[i + 3]));
            break;
        case scene::SplineKind::bezier:
            for (std::size_t i = 0; i + 3 < count; i += 4)
                curve.pieces.push_back(piece_of(p[i], p[i + 1], p[i + 2], p[i + 3]));
            break;
    }
    return curve;
}

}  // namespace

double evaluate_cubic(const std::array<double, 4>& c, double u) {
    const double v = 1 - u;
    return v * v * (v * c[0] + 3 * u * c[1]) + u * u * (3 * v * c[2] + u * c[3]);
}

std::array<double, 2> CurvePiece::at(double u) const { return {evaluate_cubic(x, u), evaluate_cubic(y, u)}; }

std::array<double, 2> CurvePiece::derivative(double u) const {
    const double v = 1 - u;
    const auto of = [&](const std::array<double, 4>& c) {
        return 3 * (v * v * (c[1] - c[0]) + 2 * u * v * (c[2] - c[1]) + u * u * (c[3] - c[2]));
    };
    return {of(x), of(y)};
}

bool Curve::closed() const {
    return !pieces.empty() && pieces.front().x[0] == pieces.back().x[3] && pieces.front().y[0] == pieces.back().y[3];
}

Curve curve_through(scene::SplineKind kind, const std::vector<std::array<double, 2>>& points) {
    return piecewise(kind, points.data(), points.size());
}

std::vector<Curve> closed_curves(scene::SplineKind kind, const std::vector<std::array<double, 2>>& points) {
    std::vector<Curve> curves;
    if (kind == scene::SplineKind::bezier) {
        // Each piece has all its points; a loop ends where a piece comes back to its beginning.
        Curve all = curve_through(kind, points);
        Curve loop;
        for (const CurvePiece& piece : all.pieces) {
            loop.pieces.push_back(piece);
            if (!loop.closed()) continue;
            curves.push_back(std::move(loop));
            loop = {};
        }
        if (!loop.pieces.empty()) curves.push_back(std::move(loop));
    } else {
        const std::size_t before = kind == scene::SplineKind::linear ? 0 : 1;  // control points before the first point
        const std::size_t after = kind == scene::SplineKind::cubic ? 1 : 0;
        for (std::size_t first = 0; first + before + 1 < points.size();) {
            const std::size_t start = first + before;
            std::size_t end = start + 1;
            while (end < points.size() && points[end] != points[start]) ++end;
            const std::size_t stop = std::min(points.size(), end + 1 + after);
            Curve curve = piecewise(kind, points.data() + first, stop - first);
            if (!curve.pieces.empty()) curves.push_back(std::move(curve));
            first = stop;
        }
    }
    for (Curve& curve : curves) {
        if (curve.closed()) continue;
        const CurvePiece& last = curve.pieces.back();
        const CurvePiece& first = curve.pieces.front();
        curve.pieces.push_back(straight({last.x[3], last.y[3]}, {first.x[0], first.y[0]}));
    }
    return curves;
}

void append_piece_roots(const CurvePiece& piece, const std::array<double, 4>& c, RootList& roots) {
    if (!piece.straight) return append_bernstein_roots(c, roots);
    if ((c[0] < 0 && c[3] > 0) || (c[0] > 0 && c[3] < 0)) roots.push_back(c[0] / (c[0] - c[3]));
}

bool is_met_oddly(const CurvePiece& piece, double x, double y) {
    if (std::max({piece.x[0], piece.x[1], piece.x[2], piece.x[3]}) < x) return false;
    std::array<double, 4> c = piece.y;
    for (double& v : c) v -= y;
    // An end on the line counts as above it; both pieces that meet there see it so.
    const bool start_above = c[0] >= 0;
    const bool end_above = c[3] >= 0;
    RootList roots;
    append_piece_roots(piece, c, roots);
    bool odd = false;
    for (const double u : roots)
        if (evaluate_cubic(piece.x, u) > x) odd = !odd;
    if ((roots.size() % 2 == 1) == (start_above != end_above)) return odd;
    // The change of side happens at an end, where the root itself is not counted.
    const double end_x = c[0] == 0 ? piece.x[0] : piece.x[3];
    return end_x > x ? !odd : odd;
}

bool inside_curves(const std::vector<Curve>& curves, double x, double y) {
    bool odd = false;
    for (const Curve& curve : curves)
        for (const CurvePiece& piece : curve.pieces)
            if (is_met_oddly(piece, x, y)) odd = !odd;
    return odd;
}

}  // namespace sundog::solids
