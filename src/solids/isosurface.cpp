// SPDX-License-Identifier: Apache-2.0
// Where a function is below a threshold within a container. Roots along a ray are isolated by bounds of the function
// over parts of the ray (reduced affine arithmetic: Knoll et al. 2009), so none is stepped over, however steep it is.
#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "fields/function_evaluator.h"
#include "solids/bounds_tree.h"
#include "solids/lazy_cells.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

using fields::Affine;

constexpr std::uint32_t kSurface = 0, kContainer = 1;

class Isosurface final : public Shape {
public:
    Isosurface(const scene::Isosurface& s, std::span<const scene::Texture> textures)
        : s_(s), function_(s.function, textures), box_(container_box(s)) {
        const Vec3d size = box_.upper - box_.lower;
        size_ = std::max({size.x, size.y, size.z});
        // Of functions of pigments only the range of values is known: parts of the ray this short are taken by their
        // ends.
        finest_ = size_ * (s.function->pigments.empty() ? 1e-8 : 1.0 / 500);
        // To what single precision can tell apart; in it, pigments are computed.
        exactness_ = s.function->pigments.empty() ? 1e-10 : 1e-8;
        explore();
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, false);
    }
    bool first_crossing(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, true);
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        if (!in_container(p)) return false;
        fields::NoiseCells cells;
        return fields::PointEvaluation(function_, cells).value(std::array{p.x, p.y, p.z}) < s_.threshold;
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing& crossing) const override {
        if (crossing.part == kContainer) return container_normal(p);
        fields::NoiseCells cells;
        fields::GradientEvaluation<3> gradient(function_, cells);
        gradient.run(std::array{p.x, p.y, p.z});
        const std::array<double, 3>& by = gradient.output(0).by;
        const Vec3d g{by[0], by[1], by[2]};
        if (is_finite(g) && length(g) > 0) return g;
        return differences(p, cells);
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, reach_); }

private:
    static Bounds3d container_box(const scene::Isosurface& s) {
        if (!s.in_sphere) return {s.lower, s.upper};
        const Vec3d r{s.radius, s.radius, s.radius};
        return {s.center - r, s.center + r};
    }
    [[nodiscard]] bool in_container(Vec3d p) const {
        if (s_.in_sphere) return dot(p - s_.center, p - s_.center) <= s_.radius * s_.radius;
        return contains(box_, p);
    }
    [[nodiscard]] Vec3d container_normal(Vec3d p) const {
        if (s_.in_sphere) return p - s_.center;
        const Vec3d center = 0.5 * (box_.lower + box_.upper), half = 0.5 * (box_.upper - box_.lower);
        Vec3d n;
        double most = -1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double share = std::abs(p[axis] - center[axis]) / half[axis];
            if (!(share > most)) continue;
            most = share;
            n = {};
            n[axis] = p[axis] < center[axis] ? -1 : 1;
        }
        return n;
    }
    [[nodiscard]] Range container_range(const Ray& ray) const {
        if (!s_.in_sphere) return clip(box_, ray, {-kInfinity, kInfinity});
        const double a = dot(ray.direction, ray.direction);
        const double middle = dot(s_.center - ray.origin, ray.direction) / a;
        const Vec3d offset = ray.at(middle) - s_.center;
        const double discriminant = s_.radius * s_.radius - dot(offset, offset);
        if (!(discriminant > 0)) return {1, 0};
        const double half = std::sqrt(discriminant / a);
        return {middle - half, middle + half};
    }
    /// The slope where the function itself has none: by points a little apart.
    [[nodiscard]] Vec3d differences(Vec3d p, fields::NoiseCells& cells) const {
        fields::PointEvaluation f(function_, cells);
        Vec3d g;
        const double step = 1e-5 * size_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Vec3d above = p, below = p;
            above[axis] += step, below[axis] -= step;
            const double rise =
                f.value(std::array{above.x, above.y, above.z}) - f.value(std::array{below.x, below.y, below.z});
            g[axis] = std::isfinite(rise) ? rise : 0;
        }
        return g == Vec3d{} ? Vec3d{0, 1, 0} : g;
    }

    enum class Content : std::uint8_t { outside, inside, unknown };
    /// Whether all of a box is outside or inside of the surface.
    [[nodiscard]] Content content_of(const Bounds3d& box, fields::RangeEvaluation<3>& ranges) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            ranges.set_input(axis, fields::input_range<3>(axis, box.lower[axis], box.upper[axis]));
        ranges.run();
        const Affine<3> value = ranges.output(0);
        if (value.lower > s_.threshold) return Content::outside;
        return value.upper < s_.threshold && !ranges.may_be_undefined() ? Content::inside : Content::unknown;
    }

    /// Halves the container again and again, and keeps the boxes in which the surface may be.
    void explore() {
        fields::NoiseCells cells;
        fields::RangeEvaluation<3> ranges(function_, cells);
        // Costly functions and simple ones take about as long.
        const std::size_t cost = std::max<std::size_t>(s_.function->code.size(), 8);
        std::size_t budget = std::clamp<std::size_t>(10'000 / cost, 100, 500);
        std::vector<Bounds3d> kept;
        std::deque<Bounds3d> open{box_};
        const double smallest = size_ / 20;
        while (!open.empty()) {
            const Bounds3d box = open.front();
            open.pop_front();
            const Content content = content_of(box, ranges);
            if (budget > 0) --budget;
            if (content == Content::outside) continue;
            reach_ = joined(reach_, box);
            if (content == Content::inside) continue;
            std::size_t longest = 0;
            const Vec3d size = box.upper - box.lower;
            for (std::size_t axis = 1; axis < 3; ++axis)
                if (size[axis] > size[longest]) longest = axis;
            if (budget < open.size() || size[longest] < smallest) {
                kept.push_back(padded(box));
                continue;
            }
            Bounds3d low = box, high = box;
            low.upper[longest] = high.lower[longest] = 0.5 * (box.lower[longest] + box.upper[longest]);
            open.push_back(low), open.push_back(high);
        }
        reach_ = padded(reach_);
        tree_ = BoundsTree(kept);
        cells_ = LazyCells(kept.size());
        boxes_ = std::move(kept);
    }

    /// A ray under way.
    struct March {
        March(const Isosurface& shape, const Ray& ray)
            : ray(ray),
              pigments(shape.function_.pigments()),
              points(shape.function_, cells, &pigments),
              ranges(shape.function_, cells, &pigments) {}
        const Ray& ray;
        fields::NoiseCells cells;
        fields::PigmentMemo pigments;
        fields::PointEvaluation points;
        fields::RangeEvaluation<1> ranges;
        std::optional<fields::RangeEvaluation<3>> boxes;  ///< Made when it is needed.
        int budget = 2000;  ///< Bounds that may be asked for; after that, parts are taken by their ends.

        double value(double t) {
            const Vec3d p = ray.at(t);
            return points.value(std::array{p.x, p.y, p.z});
        }
        /// Bounds of the function between two places.
        Affine<1> between(double a, double b) {
            const double middle = 0.5 * (a + b), half = std::max(b - middle, middle - a);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double o = ray.origin[axis], d = ray.direction[axis], p = o + d * a, q = o + d * b;
                const double rounding =
                    2 * fields::kRounding * (std::abs(o) + std::abs(d) * std::max(std::abs(a), std::abs(b)));
                Affine<1> x;
                x.lower = std::min(p, q) - rounding, x.upper = std::max(p, q) + rounding;
                x.centre = o + d * middle;
                x.slope[0] = d * half;
                x.error = rounding;
                ranges.set_input(axis, x);
            }
            ranges.run();
            return ranges.output(0);
        }
    };
    /// A part of a ray, and whether its ends are inside.
    struct Part {
        double a, b;
        bool a_inside, b_inside;
    };

    /// The place of a change between two places, as exactly as the function is known.
    [[nodiscard]] double refined(March& march, Part part) const {
        double fa = march.value(part.a) - s_.threshold, fb = march.value(part.b) - s_.threshold;
        const double enough = exactness_ * size_ / length(march.ray.direction);
        for (int i = 0; i < 100 && part.b - part.a > enough; ++i) {
            const double width = part.b - part.a, middle = 0.5 * (part.a + part.b);
            if (!(middle > part.a && middle < part.b)) break;
            // Regula falsi by Illinois's rule (Dowell and Jarratt 1971), a little beyond the guess so that both ends
            // draw near; every third step halves.
            double t = part.a - fa * width / (fb - fa);
            t += std::abs(fa) < std::abs(fb) ? 0.4 * enough : -0.4 * enough;
            if (i % 3 == 2 || !(t > part.a && t < part.b)) t = middle;
            const double f = march.value(t) - s_.threshold;
            if (f == 0) return t;
            if ((f < 0) == part.a_inside) {
                part.a = t, fa = f;
                fb *= 0.5;
            } else {
                part.b = t, fb = f;
                fa *= 0.5;
            }
        }
        return 0.5 * (part.a + part.b);
    }

    /// Appends all changes within a part in order; with `only_first`, stops after one.
    void isolate(March& march, Part whole, double finest, Range range, CrossingList& out, bool only_first) const {
        SmallVector<Part, 48> stack;
        stack.push_back(whole);
        while (!stack.empty()) {
            const Part part = stack.back();
            stack.pop_back();
            const double middle = 0.5 * (part.a + part.b);
            const bool splittable = part.b - part.a > finest && middle > part.a && middle < part.b;
            if (!splittable || march.budget <= 0) {
                if (part.a_inside == part.b_inside) continue;
                const double t = refined(march, part);
                if (range.contains(t)) out.push_back({t, 0, 0, kSurface});
                if (only_first && !out.empty()) return;
                continue;
            }
            --march.budget;
            const Affine<1> f = march.between(part.a, part.b);
            if (f.lower > s_.threshold) continue;
            const bool defined = !march.ranges.may_be_undefined();
            if (f.upper < s_.threshold && defined) continue;
            // Where the linear form leaves no doubt, only a middle piece is left.
            const double rise = f.slope[0];
            if (defined && f.error < std::abs(rise)) {
                const double at = (s_.threshold - f.centre) / rise, reach = f.error / std::abs(rise) + 1e-14;
                const double half = 0.5 * (part.b - part.a);
                Part rest = part;
                if (at - reach > -1) rest.a = std::max(part.a, middle + half * (at - reach)), rest.a_inside = rise > 0;
                if (at + reach < 1) rest.b = std::min(part.b, middle + half * (at + reach)), rest.b_inside = rise < 0;
                if (!(rest.a < rest.b)) continue;
                if (rest.b - rest.a < 0.6 * (part.b - part.a)) {
                    stack.push_back(rest);
                    continue;
                }
            }
            const bool middle_inside = march.value(middle) < s_.threshold;
            stack.push_back({middle, part.b, middle_inside, part.b_inside});
            stack.push_back({part.a, middle, part.a_inside, middle_inside});
        }
    }

    /// One of `boxes_` on a ray's way.
    struct BoxMet {
        Range part;
        std::uint32_t number;
    };

    bool find(const Ray& ray, Range range, CrossingList& out, bool only_first) const {
        const Range container = container_range(ray);
        if (!(container.lower < container.upper)) return false;
        const Range within{std::max(container.lower, range.lower), std::min(container.upper, range.upper)};
        if (!(within.lower < within.upper)) return false;
        const double speed = length(ray.direction);
        const double gap = 1e-9 * size_ / speed;
        SmallVector<BoxMet, 32> met;
        Range reach = within;
        tree_.along(ray, reach, [&](std::uint32_t i) {
            const Range part = clip(boxes_[i], ray, within);
            if (!part.empty()) met.push_back({part, i});
        });
        std::sort(met.begin(), met.end(), [](const BoxMet& p, const BoxMet& q) { return p.part.lower < q.part.lower; });

        March march(*this, ray);
        bool inside = march.value(within.lower) < s_.threshold;
        const bool starts_inside = inside && container.lower <= range.lower;
        if (inside && range.contains(container.lower)) {
            out.push_back({container.lower, 0, 0, kContainer, true, !s_.open});
            if (only_first && !s_.open) return false;
        }
        const std::size_t before = out.size();
        // Parts that follow one another are looked at as one.
        Range part{1, 0};
        const auto look_at = [&] {
            if (part.lower > part.upper) return false;
            // Between parts nothing changes: a part may begin a little early.
            part.lower = std::max(within.lower, part.lower - gap);
            part.upper = std::min(within.upper, part.upper + gap);
            const bool ends_inside = march.value(part.upper) < s_.threshold;
            isolate(march, {part.lower, part.upper, inside, ends_inside}, finest_ / speed, within, out, only_first);
            inside = ends_inside;
            return only_first && out.size() > before;
        };
        bool found = false;
        const auto add = [&](const Range& next) {
            if (found) return;
            if (part.lower <= part.upper && next.lower <= part.upper + gap) {
                part.upper = std::max(part.upper, next.upper);
                return;
            }
            found = look_at();
            part = next;
        };
        const auto may_hold = [&](const Bounds3d& cell) {
            if (!march.boxes) march.boxes.emplace(function_, march.cells, &march.pigments);
            return content_of(cell, *march.boxes) == Content::unknown;
        };
        for (const BoxMet& box : met) {
            if (s_.function->pigments.empty())
                cells_.along(box.number, boxes_[box.number], ray, box.part, may_hold, add);
            else add(box.part);
            if (found) return starts_inside;
        }
        if (look_at()) return starts_inside;
        if (inside && range.contains(container.upper))
            out.push_back({container.upper, 0, 0, kContainer, true, !s_.open});
        return starts_inside;
    }

    scene::Isosurface s_;
    fields::FunctionEvaluator function_;
    Bounds3d box_, reach_;
    double size_ = 1, finest_ = 1e-8;
    double exactness_ = 1e-10;     ///< Of places, as a share of the size.
    std::vector<Bounds3d> boxes_;  ///< Where the surface may be.
    LazyCells cells_;              ///< Of each of them.
    BoundsTree tree_;
};

}  // namespace

ShapePointer make_shape(const scene::Isosurface& isosurface, const SourceLocation& where,
                        std::span<const scene::Texture> textures) {
    const bool flat = isosurface.in_sphere
                          ? !(isosurface.radius > 0)
                          : !(isosurface.lower.x < isosurface.upper.x && isosurface.lower.y < isosurface.upper.y &&
                              isosurface.lower.z < isosurface.upper.z);
    if (flat) refuse_shape(where, "an isosurface needs a container of some size", "expected a box or a sphere");
    return std::make_shared<Isosurface>(isosurface, textures);
}

}  // namespace sundog::solids
