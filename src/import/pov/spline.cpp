// SPDX-License-Identifier: Apache-2.0
#include "import/pov/spline.h"

#include <algorithm>

#include "import/pov/values.h"

namespace sundog::pov {
namespace {

using Point = Spline::Point;

double linear(const Point& a, const Point& b, double t, std::size_t i) {
    const double f = (t - a.parameter) / (b.parameter - a.parameter);
    return a.at[i] + (b.at[i] - a.at[i]) * f;
}

/// Lagrange's parabola through three points.
double quadratic(const Point& a, const Point& b, const Point& c, double t, std::size_t i) {
    const double x0 = a.parameter, x1 = b.parameter, x2 = c.parameter;
    return a.at[i] * (t - x1) * (t - x2) / ((x0 - x1) * (x0 - x2)) +
           b.at[i] * (t - x0) * (t - x2) / ((x1 - x0) * (x1 - x2)) +
           c.at[i] * (t - x0) * (t - x1) / ((x2 - x0) * (x2 - x1));
}

double natural(const Point& a, const Point& b, double t, std::size_t i) {
    const double h = b.parameter - a.parameter;
    const double u = (b.parameter - t) / h, v = (t - a.parameter) / h;
    return u * a.at[i] + v * b.at[i] + ((u * u * u - u) * a.bend[i] + (v * v * v - v) * b.bend[i]) * h * h / 6;
}

/// Hermite's cubic from b to c, whose slope at each is the mean of those of the chords on both sides.
double hermite(const Point& a, const Point& b, const Point& c, const Point& d, double t, std::size_t i) {
    const double h = c.parameter - b.parameter;
    const double v = (t - b.parameter) / h;
    const double before = (b.at[i] - a.at[i]) / (b.parameter - a.parameter) * h;
    const double chord = c.at[i] - b.at[i];
    const double after = (d.at[i] - c.at[i]) / (d.parameter - c.parameter) * h;
    const double from = (before + chord) / 2, to = (chord + after) / 2;
    const double v2 = v * v, v3 = v2 * v;
    return (2 * v3 - 3 * v2 + 1) * b.at[i] + (v3 - 2 * v2 + v) * from + (3 * v2 - 2 * v3) * c.at[i] + (v3 - v2) * to;
}

}  // namespace

std::optional<SplineKind> spline_kind(Keyword keyword) {
    switch (keyword) {
        case Keyword::linear_spline:
            return SplineKind::linear;
        case Keyword::quadratic_spline:
            return SplineKind::quadratic;
        case Keyword::cubic_spline:
            return SplineKind::cubic;
        case Keyword::natural_spline:
            return SplineKind::natural;
        default:
            return std::nullopt;
    }
}

void insert_point(Spline& spline, double parameter, const Value& at) {
    spline.components = std::max(spline.components, at.count);
    const auto place = std::lower_bound(spline.points.begin(), spline.points.end(), parameter,
                                        [](const Point& point, double p) { return point.parameter < p; });
    const std::array<double, 5> position = at.count == 1 ? promoted(at, kColorComponents).v : at.v;
    if (place != spline.points.end() && place->parameter == parameter) place->at = position;
    else spline.points.insert(place, {parameter, position, {}});
}

void natural_second_derivatives(Spline& spline) {
    std::vector<Point>& p = spline.points;
    if (p.size() < 3) return;
    std::vector<double> above(p.size());
    for (std::size_t component = 0; component < 5; ++component) {
        above.front() = p.front().bend[component] = p.back().bend[component] = 0;
        for (std::size_t k = 1; k + 1 < p.size(); ++k) {
            const double left = p[k].parameter - p[k - 1].parameter, right = p[k + 1].parameter - p[k].parameter;
            const double slopes = (p[k + 1].at[component] - p[k].at[component]) / right -
                                  (p[k].at[component] - p[k - 1].at[component]) / left;
            const double diagonal = 2 * (left + right) - left * above[k - 1];
            above[k] = right / diagonal;
            p[k].bend[component] = (6 * slopes - left * p[k - 1].bend[component]) / diagonal;
        }
        for (std::size_t k = p.size() - 2; k > 0; --k) p[k].bend[component] -= above[k] * p[k + 1].bend[component];
    }
}

std::shared_ptr<const scene::FunctionSpline> pieces_of(const Spline& spline, SplineKind kind) {
    auto out = std::make_shared<scene::FunctionSpline>();
    const std::vector<Point>& p = spline.points;
    const std::size_t last = p.size() - 1;
    const bool is_inner = kind == SplineKind::cubic && p.size() > 2;
    const std::size_t first_valid = is_inner ? 1 : 0, last_valid = is_inner ? last - 1 : last;
    out->first = p[first_valid].parameter, out->last = p[last_valid].parameter;
    for (std::size_t k = first_valid; k < last_valid; ++k) {
        // Every kind is a cubic between two points: the one through four values there.
        scene::FunctionSpline::Piece piece;
        piece.start = p[k].parameter;
        const double h = p[k + 1].parameter - p[k].parameter;
        std::array<std::array<double, 5>, 4> at;
        for (std::size_t j = 0; j < 3; ++j)
            at[j] = evaluate(spline, p[k].parameter + h * static_cast<double>(j) / 3, kind).v;
        at[3] = p[k + 1].at;
        for (std::size_t i = 0; i < 5; ++i) {
            const double a = at[0][i], b = at[1][i], c = at[2][i], d = at[3][i];
            piece.coefficients[i] = {a, (-5.5 * a + 9 * b - 4.5 * c + d) / h,
                                     (9 * a - 22.5 * b + 18 * c - 4.5 * d) / (h * h),
                                     (-4.5 * a + 13.5 * b - 13.5 * c + 4.5 * d) / (h * h * h)};
        }
        out->pieces.push_back(piece);
    }
    if (out->pieces.empty()) {
        scene::FunctionSpline::Piece piece;
        piece.start = out->first;
        for (std::size_t i = 0; i < 5; ++i) piece.coefficients[i] = {p[first_valid].at[i], 0, 0, 0};
        out->pieces.push_back(piece);
        out->last = out->first;
    }
    return out;
}

Value evaluate(const Spline& spline, double parameter, SplineKind kind) {
    const std::vector<Point>& p = spline.points;
    Value value;
    value.count = spline.components;
    const std::size_t last = p.size() - 1;
    const bool is_inner = kind == SplineKind::cubic && p.size() > 2;
    const std::size_t first_valid = is_inner ? 1 : 0, last_valid = is_inner ? last - 1 : last;
    if (parameter <= p[first_valid].parameter) return value.v = p[first_valid].at, value;
    if (!(parameter < p[last_valid].parameter)) return value.v = p[last_valid].at, value;
    const auto after = std::upper_bound(p.begin(), p.end(), parameter,
                                        [](double t, const Point& point) { return t < point.parameter; });
    const auto k = static_cast<std::size_t>(after - p.begin()) - 1;
    for (std::size_t i = 0; i < spline.components; ++i) {
        if (kind == SplineKind::quadratic && p.size() > 2) {
            const std::size_t middle = std::clamp<std::size_t>(k, 1, last - 1);
            value.v[i] = quadratic(p[middle - 1], p[middle], p[middle + 1], parameter, i);
        } else if (is_inner) {
            value.v[i] = hermite(p[k - 1], p[k], p[k + 1], p[k + 2], parameter, i);
        } else if (kind == SplineKind::natural) {
            value.v[i] = natural(p[k], p[k + 1], parameter, i);
        } else {
            value.v[i] = linear(p[k], p[k + 1], parameter, i);
        }
    }
    return value;
}

}  // namespace sundog::pov
