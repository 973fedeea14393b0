// SPDX-License-Identifier: Apache-2.0
// Surfaces whose x, y and z are functions of u and v. The (u, v) rectangle is quartered until bounds of the functions
// (affine arithmetic) are small boxes; within a box, a ray and the surface meet where Newton's method from the two
// triangles of its corners ends (Toth 1985).
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <vector>

#include "fields/function_evaluator.h"
#include "solids/bounds_tree.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

struct Patch {
    std::array<double, 2> lower{}, upper{};  ///< Of u and v.
};

class Parametric final : public Shape {
public:
    Parametric(const scene::Parametric& p, std::span<const scene::Texture> textures)
        : p_(p), function_(p.function, textures) {
        container_ = p.in_sphere ? Bounds3d{p.center - Vec3d{p.radius, p.radius, p.radius},
                                            p.center + Vec3d{p.radius, p.radius, p.radius}}
                                 : Bounds3d{p.lower, p.upper};
        explore();
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        find(ray, range, out);
        std::sort(out.begin(), out.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
        return false;
    }
    [[nodiscard]] bool inside(Vec3d) const override { return false; }
    [[nodiscard]] Vec3d normal(Vec3d, const Crossing& crossing) const override {
        fields::NoiseCells cells;
        fields::GradientEvaluation<2> surface(function_, cells);
        const auto slope_at = [&](double u, double v) {
            surface.run(std::array{u, v, 0.0});
            const Frame f = frame_of(surface);
            return cross(f.by_u, f.by_v);
        };
        const Vec3d n = slope_at(crossing.u, crossing.v);
        if (is_finite(n) && dot(n, n) > 1e-24) return n;
        // At poles: as a little further inside.
        const double u = crossing.u + 1e-4 * (0.5 * (p_.first[0] + p_.last[0]) - crossing.u);
        const double v = crossing.v + 1e-4 * (0.5 * (p_.first[1] + p_.last[1]) - crossing.v);
        const Vec3d near = slope_at(u, v);
        return is_finite(near) && dot(near, near) > 0 ? near : Vec3d{0, 1, 0};
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, reach_); }
    [[nodiscard]] std::array<double, 2> uv(Vec3d, const Crossing& crossing) const override {
        return {crossing.u, crossing.v};
    }

private:
    struct Frame {
        Vec3d place, by_u, by_v;
    };
    static Frame frame_of(const fields::GradientEvaluation<2>& surface) {
        Frame f;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& value = surface.output(axis);
            f.place[axis] = value.value, f.by_u[axis] = value.by[0], f.by_v[axis] = value.by[1];
        }
        return f;
    }
    [[nodiscard]] bool in_container(Vec3d p) const {
        if (p_.in_sphere) return dot(p - p_.center, p - p_.center) <= p_.radius * p_.radius;
        return contains(container_, p);
    }

    /// Quarters the rectangle, dropping what lies off the container.
    void explore() {
        fields::NoiseCells cells;
        fields::RangeEvaluation<2> ranges(function_, cells);
        if (p_.function->input_count > 2) ranges.set_input(2, fields::AffineMath<2>::constant(0));
        const Vec3d size = container_.upper - container_.lower;
        const double small = std::max({size.x, size.y, size.z}) / 150;
        const std::size_t cost = std::max<std::size_t>(p_.function->code.size(), 8);
        std::size_t budget = std::clamp<std::size_t>(4'000'000 / cost, 4'000, 60'000);
        std::deque<Patch> open{{p_.first, p_.last}};
        std::vector<Bounds3d> boxes;
        while (!open.empty()) {
            const Patch patch = open.front();
            open.pop_front();
            for (std::size_t i = 0; i < 2; ++i)
                ranges.set_input(i, fields::input_range<2>(i, patch.lower[i], patch.upper[i]));
            ranges.run();
            Bounds3d box;
            std::array<double, 2> stretch{};
            double doubt = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const fields::Affine<2> value = ranges.output(axis);
                box.lower[axis] = value.lower, box.upper[axis] = value.upper;
                for (std::size_t i = 0; i < 2; ++i) stretch[i] = std::max(stretch[i], std::abs(value.slope[i]));
                doubt = std::max(doubt, value.error);
            }
            if (budget > 0) --budget;
            const Bounds3d part = common(box, container_);
            if (!(part.lower.x <= part.upper.x && part.lower.y <= part.upper.y && part.lower.z <= part.upper.z))
                continue;
            const Vec3d extent = box.upper - box.lower;
            const bool done = std::max({extent.x, extent.y, extent.z}) < small;
            if (done || budget < open.size() || !can_halve(patch)) {
                patches_.push_back(patch);
                boxes.push_back(padded(part));
                reach_ = joined(reach_, boxes.back());
                continue;
            }
            // Across the direction in which it is longer in space; while that is in doubt, in its share of the
            // rectangle.
            if (!(doubt < 0.5 * std::max(stretch[0], stretch[1])))
                for (std::size_t i = 0; i < 2; ++i)
                    stretch[i] = (patch.upper[i] - patch.lower[i]) / (p_.last[i] - p_.first[i]);
            const std::size_t longer = stretch[0] >= stretch[1] ? 0 : 1;
            Patch low = patch;
            Patch high = patch;
            low.upper[longer] = high.lower[longer] = 0.5 * (patch.lower[longer] + patch.upper[longer]);
            open.push_back(low), open.push_back(high);
        }
        tree_ = BoundsTree(boxes);
        boxes_ = std::move(boxes);
    }
    static bool can_halve(const Patch& patch) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double middle = 0.5 * (patch.lower[i] + patch.upper[i]);
            if (!(middle > patch.lower[i] && middle < patch.upper[i])) return false;
        }
        return true;
    }

    /// A ray as the line in which two planes meet: a point is on it where both are 0.
    struct Line {
        explicit Line(const Ray& ray) {
            const Vec3d d = ray.direction;
            const Vec3d side = std::abs(d.x) < std::abs(d.y) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
            a = normalize(cross(d, side));
            b = normalize(cross(d, a));
            a_at = dot(a, ray.origin), b_at = dot(b, ray.origin);
        }
        Vec3d a, b;
        double a_at, b_at;
    };

    void find(const Ray& ray, Range range, CrossingList& out) const {
        fields::NoiseCells cells;
        fields::GradientEvaluation<2> surface(function_, cells);
        const Line line(ray);
        Range reach = range;
        tree_.along(ray, reach, [&](std::uint32_t i) {
            if (!clip(boxes_[i], ray, range).empty()) find_in(patches_[i], surface, line, ray, range, out);
        });
    }

    void find_in(const Patch& patch, fields::GradientEvaluation<2>& surface, const Line& line, const Ray& ray,
                 Range range, CrossingList& out) const {
        const std::array<double, 2> width{patch.upper[0] - patch.lower[0], patch.upper[1] - patch.lower[1]};
        const std::size_t before = out.size();
        for (const double start : {0.25, 0.75}) {
            std::array<double, 2> at{patch.lower[0] + start * width[0], patch.lower[1] + start * width[1]};
            bool arrived = false;
            for (int step = 0; step < 12 && !arrived; ++step) {
                surface.run(std::array{at[0], at[1], 0.0});
                const Frame f = frame_of(surface);
                const double r = dot(line.a, f.place) - line.a_at;
                const double s = dot(line.b, f.place) - line.b_at;
                const double ru = dot(line.a, f.by_u);
                const double rv = dot(line.a, f.by_v);
                const double su = dot(line.b, f.by_u);
                const double sv = dot(line.b, f.by_v);
                const double determinant = ru * sv - rv * su;
                if (!(std::abs(determinant) > 0)) break;
                const double du = (r * sv - rv * s) / determinant;
                const double dv = (ru * s - r * su) / determinant;
                if (!std::isfinite(du) || !std::isfinite(dv)) break;
                at[0] -= du, at[1] -= dv;
                // Far off its patch it is another one's.
                if (std::abs(at[0] - patch.lower[0] - 0.5 * width[0]) > 2.5 * width[0] ||
                    std::abs(at[1] - patch.lower[1] - 0.5 * width[1]) > 2.5 * width[1])
                    break;
                arrived = std::abs(du) <= 1e-9 * width[0] + 1e-15 && std::abs(dv) <= 1e-9 * width[1] + 1e-15;
            }
            if (!arrived) continue;
            constexpr double kSlack = 1e-7;
            bool within = true;
            for (std::size_t i = 0; i < 2; ++i)
                within = within && at[i] >= patch.lower[i] - kSlack * width[i] &&
                         at[i] <= patch.upper[i] + kSlack * width[i];
            if (!within) continue;
            surface.run(std::array{at[0], at[1], 0.0});
            const Vec3d place = frame_of(surface).place;
            const double t = dot(place - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
            if (!range.contains(t) || !in_container(place)) continue;
            bool known = false;
            for (std::size_t i = before; i < out.size(); ++i)
                known = known || std::abs(out[i].t - t) <= 1e-9 * std::abs(t);
            if (!known) out.push_back({t, at[0], at[1], 0, false, true});
        }
    }

    scene::Parametric p_;
    fields::FunctionEvaluator function_;
    Bounds3d container_, reach_;
    std::vector<Patch> patches_;
    std::vector<Bounds3d> boxes_;  ///< Around each of the patches.
    BoundsTree tree_;
};

}  // namespace

ShapePointer make_shape(const scene::Parametric& parametric, const SourceLocation& where,
                        std::span<const scene::Texture> textures) {
    if (!(parametric.first[0] < parametric.last[0]) || !(parametric.first[1] < parametric.last[1]))
        refuse_shape(where, "a parametric surface's ranges of u and v must not be empty");
    return std::make_shared<Parametric>(parametric, textures);
}

}  // namespace sundog::solids
