// SPDX-License-Identifier: Apache-2.0
// Splines as POV-Ray's language declares them: a vector that depends on a number.
#pragma once

#include <optional>
#include <vector>

#include "import/pov/entity.h"
#include "scene/function.h"

namespace sundog::pov {

/// How a Spline goes from point to point.
enum class SplineKind : std::uint8_t { linear, quadratic, cubic, natural };

/// The kind that a keyword names: linear_spline, quadratic_spline, cubic_spline or natural_spline.
std::optional<SplineKind> spline_kind(Keyword keyword);

/// `spline { kind  t0, <…>  t1, <…> … }`.
struct Spline {
    struct Point {
        double parameter = 0;
        std::array<double, 5> at{};
        /// Second derivatives of the natural spline; see natural_second_derivatives().
        std::array<double, 5> bend{};
    };
    SplineKind kind = SplineKind::linear;
    std::uint8_t components = 2;  ///< Of the longest of its vectors, 2 to 5.
    std::vector<Point> points;    ///< By ascending parameter, no two alike.
};

/// Puts a point in its place; one with the same parameter is replaced.
void insert_point(Spline& spline, double parameter, const Value& at);

/// Computes Spline::Point::bend of all points: the natural cubic spline's second derivatives (zero at both ends), by
/// the tridiagonal system (Press et al. 1992, section 3.3). To be called when all points are in.
void natural_second_derivatives(Spline& spline);

/// The spline of another kind, perhaps, as cubic pieces. It must have a point.
std::shared_ptr<const scene::FunctionSpline> pieces_of(const Spline& spline, SplineKind kind);

/// The spline at `parameter`; before the first and behind the last point it stays at them. A cubic spline
/// takes the mean of the slopes on both sides of a point for its own (on even parameters, Catmull and Rom's of 1974);
/// it is defined between the second point and the last but one. `spline` must have a point.
Value evaluate(const Spline& spline, double parameter, SplineKind kind);

}  // namespace sundog::pov
