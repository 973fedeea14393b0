// SPDX-License-Identifier: Apache-2.0
// Plane curves made of polynomial pieces, as lathes and prisms take them (POV-Ray's reference, section 3.4.5.1.8).
#pragma once

#include <array>
#include <vector>

#include "scene/solid.h"
#include "solids/roots.h"

namespace sundog::solids {

/// One piece, for parameters 0 to 1: Bernstein coefficients of degree 3 of both coordinates. Pieces of lower degree are
/// raised to it, which keeps their ends exact.
struct CurvePiece {
    std::array<double, 4> x, y;
    bool straight = false;  ///< And evenly paced: both coordinates go linearly from their first to their last.

    [[nodiscard]] std::array<double, 2> at(double u) const;
    [[nodiscard]] std::array<double, 2> derivative(double u) const;
};

/// A curve without gaps; `closed` where its end is its beginning.
struct Curve {
    std::vector<CurvePiece> pieces;
    [[nodiscard]] bool closed() const;
};

/// The curve through (or, bezier, steered by) the points. Throws nothing; too few points give no pieces.
Curve curve_through(scene::SplineKind kind, const std::vector<std::array<double, 2>>& points);

/// A prism's outlines: several closed curves in one list of points, each ended by its own first point (section
/// 3.4.5.1.11). An outline that isn't closed is closed by a straight piece.
std::vector<Curve> closed_curves(scene::SplineKind kind, const std::vector<std::array<double, 2>>& points);

/// Whether a line from (x, y) in +x direction meets a piece an odd number of times.
bool is_met_oddly(const CurvePiece& piece, double x, double y);

/// Whether (x, y) is inside of an odd number of the curves' loops: pieces are counted that a line in +x direction
/// meets.
bool inside_curves(const std::vector<Curve>& curves, double x, double y);

/// Appends the parameters in (0, 1) at which a piece crosses the line where a coordinate is 0, from that coordinate's
/// Bernstein coefficients.
void append_piece_roots(const CurvePiece& piece, const std::array<double, 4>& coefficients, RootList& roots);

/// Value of the polynomial with these Bernstein coefficients.
double evaluate_cubic(const std::array<double, 4>& c, double u);

}  // namespace sundog::solids
