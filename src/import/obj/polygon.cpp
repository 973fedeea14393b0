// SPDX-License-Identifier: Apache-2.0
#include "import/obj/polygon.h"

#include <algorithm>
#include <cmath>

namespace sundog::import {
namespace {

/// Point-in-triangle tests that a corner may cost on average before the search for ears is given up: bounds the time
/// that a hostile file can take.
constexpr std::uint64_t kTestsPerCorner = 4000;

}  // namespace

std::span<const PolygonCutter::Triangle> PolygonCutter::cut(std::span<const Vec3> corners) {
    triangles_.clear();
    approximate_ = false;
    const auto count = static_cast<std::uint32_t>(corners.size());
    if (count == 4) cut_quad(corners);
    else if (count == 3 || !project(corners) || convex()) cut_fan(count);
    else cut_ears();
    return triangles_;
}

void PolygonCutter::cut_fan(std::uint32_t count) {
    for (std::uint32_t i = 2; i < count; ++i) triangles_.push_back({0, i - 1, i});
}

void PolygonCutter::cut_quad(std::span<const Vec3> corners) {
    // In a quad with an inward corner, only the diagonal through that corner lies inside; across the other one the two
    // triangles face against each other.
    const Vec3 diagonal = corners[2] - corners[0];
    const float one_way = dot(cross(corners[1] - corners[0], diagonal), cross(diagonal, corners[3] - corners[0]));
    const Vec3 other_diagonal = corners[3] - corners[1];
    const float other_way =
        dot(cross(corners[2] - corners[1], other_diagonal), cross(other_diagonal, corners[0] - corners[1]));
    // Where both are possible, a straight corner still makes a sliver of one. Where none is (no area, or it crosses
    // itself), any will do.
    constexpr float kSliver = 1e-5F;
    if (!(other_way > 0) || one_way > kSliver * other_way) return cut_fan(4);
    triangles_.push_back({1, 2, 3});
    triangles_.push_back({1, 3, 0});
}

bool PolygonCutter::project(std::span<const Vec3> corners) {
    double normal[3] = {0, 0, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& a = corners[i];
        const Vec3& b = corners[i + 1 < corners.size() ? i + 1 : 0];
        normal[0] += (double{a.y} - b.y) * (double{a.z} + b.z);
        normal[1] += (double{a.z} - b.z) * (double{a.x} + b.x);
        normal[2] += (double{a.x} - b.x) * (double{a.y} + b.y);
    }
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    if (normal[axis] == 0) return false;
    std::size_t u = (axis + 1) % 3;
    std::size_t v = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u, v);
    const auto count = static_cast<std::uint32_t>(corners.size());
    corners_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i)
        corners_[i] = {corners[i][u], corners[i][v], i > 0 ? i - 1 : count - 1, i + 1 < count ? i + 1 : 0,
                       false,         false};
    return true;
}

double PolygonCutter::twice_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Corner& p = corners_[a];
    const Corner& q = corners_[b];
    const Corner& r = corners_[c];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

bool PolygonCutter::convex() const {
    // All turns strictly to the left (a fan would make slivers of straight corners), and once around: the direction of
    // travel changes between left and right just twice.
    int changes = 0;
    double last_direction = 0;
    double first_direction = 0;
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        const Corner& corner = corners_[i];
        if (twice_area(corner.previous, i, corner.next) <= 0) return false;
        const double direction = corners_[corner.next].x - corner.x;
        if (direction == 0) continue;
        if (first_direction == 0) first_direction = direction;
        if (last_direction * direction < 0) ++changes;
        last_direction = direction;
    }
    if (last_direction * first_direction < 0) ++changes;
    return changes <= 2;
}

bool PolygonCutter::is_ear(std::uint32_t corner) {
    if (tests_left_ == 0) return false;
    --tests_left_;
    const std::uint32_t a = corners_[corner].previous;
    const std::uint32_t c = corners_[corner].next;
    if (twice_area(a, corner, c) <= 0) return false;
    const Corner& p = corners_[a];
    const Corner& q = corners_[corner];
    const Corner& r = corners_[c];
    const auto [low_x, high_x] = std::minmax({p.x, q.x, r.x});
    const auto [low_y, high_y] = std::minmax({p.y, q.y, r.y});
    // Only an inward corner can lie in an ear without another one lying there too.
    auto it = std::lower_bound(reflex_by_x_.begin(), reflex_by_x_.end(), low_x,
                               [&](std::uint32_t i, double x) { return corners_[i].x < x; });
    for (; it != reflex_by_x_.end() && corners_[*it].x <= high_x; ++it) {
        if (tests_left_ == 0) return false;
        --tests_left_;
        const Corner& other = corners_[*it];
        if (other.removed || !other.reflex || other.y < low_y || other.y > high_y) continue;
        const auto same_place = [&](const Corner& at) { return at.x == other.x && at.y == other.y; };
        if (same_place(p) || same_place(q) || same_place(r)) continue;
        if (twice_area(a, corner, *it) >= 0 && twice_area(corner, c, *it) >= 0 && twice_area(c, a, *it) >= 0)
            return false;
    }
    return true;
}

void PolygonCutter::remove_ear(std::uint32_t ear) {
    Corner& corner = corners_[ear];
    const std::uint32_t a = corner.previous;
    const std::uint32_t c = corner.next;
    triangles_.push_back({a, ear, c});
    corner.removed = true;
    corners_[a].next = c;
    corners_[c].previous = a;
    // An inward corner may open when its neighbour goes; the others stay as they are.
    for (const std::uint32_t i : {a, c})
        if (corners_[i].reflex) corners_[i].reflex = twice_area(corners_[i].previous, i, corners_[i].next) <= 0;
}

void PolygonCutter::cut_ears() {
    const auto count = static_cast<std::uint32_t>(corners_.size());
    tests_left_ = kTestsPerCorner * count;
    reflex_by_x_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        corners_[i].reflex = twice_area(corners_[i].previous, i, corners_[i].next) <= 0;
        if (corners_[i].reflex) reflex_by_x_.push_back(i);
    }
    std::sort(reflex_by_x_.begin(), reflex_by_x_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return corners_[a].x < corners_[b].x; });

    std::uint32_t left = count;
    std::uint32_t at = 0;
    std::uint32_t looked_at = 0;  // corners since the last ear
    while (left > 3) {
        if (is_ear(at)) {
            const std::uint32_t next = corners_[at].next;
            remove_ear(at);
            --left;
            looked_at = 0;
            at = corners_[next].next;  // Every other corner first: fewer slivers than a fan around one corner.
            continue;
        }
        at = corners_[at].next;
        if (++looked_at <= left && tests_left_ > 0) continue;
        // No ear: take a corner on a straight line (or a spike), which covers nothing; else, as a last resort, any
        // corner that turns the right way.
        std::uint32_t chosen = at;
        bool straight = false;
        for (std::uint32_t i = 0; i < left && !straight; ++i, at = corners_[at].next) {
            const double area = twice_area(corners_[at].previous, at, corners_[at].next);
            straight = area == 0;
            if (straight || area > 0) chosen = at;
            if (tests_left_ == 0) break;
        }
        approximate_ = approximate_ || !straight;
        at = corners_[chosen].next;
        remove_ear(chosen);
        --left;
        looked_at = 0;
    }
    triangles_.push_back({corners_[at].previous, at, corners_[at].next});
}

}  // namespace sundog::import
