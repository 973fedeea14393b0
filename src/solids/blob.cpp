// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "solids/bounds_tree.h"
#include "solids/roots.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

/// strength*(1 - d^2/radius^2)^2, d the distance to a point, or to an axis within its length.
struct Component {
    enum class Kind : std::uint8_t { ball, axis } kind;
    Affine3d component_from_blob;  ///< For a ball: to the unit ball. For an axis: to the unit cylinder about z.
    double length;                 ///< Of the axis, in units of the radius.
    double strength;
    std::uint32_t material;

    /// 1 - d^2/radius^2 in the component's own space, where `part` is the piece that a point belongs to.
    enum class Part : std::uint8_t { side, start, end };
    [[nodiscard]] Part part_of(Vec3d q) const {
        return kind == Kind::ball || q.z < 0 ? Part::start : q.z > length ? Part::end : Part::side;
    }
    [[nodiscard]] double reach(Vec3d q, Part part) const {
        const double z = part == Part::side ? 0 : part == Part::start ? q.z : q.z - length;
        return 1 - q.x * q.x - q.y * q.y - z * z;
    }
    [[nodiscard]] double field(Vec3d p) const {
        const Vec3d q = transform_point(component_from_blob, p);
        const double r = reach(q, part_of(q));
        return r > 0 ? strength * r * r : 0;
    }
    [[nodiscard]] Vec3d gradient(Vec3d p) const {
        const Vec3d q = transform_point(component_from_blob, p);
        const Part part = part_of(q);
        const double r = reach(q, part);
        if (!(r > 0)) return {};
        const double z = part == Part::side ? 0 : part == Part::start ? q.z : q.z - length;
        return transform_normal(component_from_blob, Vec3d{q.x, q.y, z} * (-4 * strength * r));
    }
};

Component compiled(const scene::BlobComponent& c) {
    const Vec3d axis = c.is_cylinder ? c.end - c.center : Vec3d{};
    const double length = sundog::length(axis);
    Vec3d z = length > 0 ? axis / length : Vec3d{0, 0, 1};
    const Vec3d aside = std::abs(z.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d x = normalize(cross(aside, z));
    const Vec3d y = cross(z, x);
    const Affine3d own{x * c.radius, y * c.radius, z * c.radius, c.center};
    return {length > 0 ? Component::Kind::axis : Component::Kind::ball, inverse(c.blob_from_component * own),
            length / c.radius, c.strength, c.material};
}

/// A stretch of a ray in one part of one component.
struct Stretch {
    Range range;
    std::uint32_t component;
    Component::Part part;
};
using Stretches = SmallVector<Stretch, 16>;

// Along a ray the field is, between the places where it enters or leaves a part of a component, one polynomial of
// degree four: the sum of squares of quadratics.
class Blob final : public Shape {
public:
    explicit Blob(const scene::Blob& blob) : threshold_(blob.threshold) {
        std::vector<Bounds3d> boxes;
        for (const scene::BlobComponent& c : blob.components) {
            const Component component = compiled(c);
            const Affine3d blob_from_component = inverse(component.component_from_blob);
            boxes.push_back(transformed(blob_from_component, {{-1, -1, -1}, {1, 1, component.length + 1}}));
            // Nothing can be inside where only components of negative strength are.
            if (c.strength > 0) box_ = joined(box_, boxes.back());
            components_.push_back(component);
        }
        tree_ = BoundsTree(boxes);
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, false);
    }
    bool first_crossing(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, true);
    }
    bool find(const Ray& ray, Range range, CrossingList& out, bool only_first) const {
        Stretches stretches;
        Range whole = range;
        tree_.along(ray, whole, [&](std::uint32_t i) { append_stretches(ray, range, i, stretches); });
        if (stretches.empty()) return 0 > threshold_;
        SmallVector<double, 32> cuts;
        for (const Stretch& s : stretches) {
            cuts.push_back(s.range.lower);
            cuts.push_back(s.range.upper);
        }
        std::sort(cuts.begin(), cuts.end());
        // What is inside is carried from piece to piece: where rounding disagrees at a cut, the surface is there.
        const bool starts_inside = cuts[0] <= range.lower ? inside(ray.at(range.lower)) : 0 > threshold_;
        bool is_inside = starts_inside;
        for (std::size_t i = 1; i < cuts.size() && !(only_first && !out.empty()); ++i)
            if (cuts[i - 1] < cuts[i]) append_piece(ray, {cuts[i - 1], cuts[i]}, stretches, range, is_inside, out);
        return starts_inside;
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        double sum = 0;
        tree_.any_at(p, [&](std::uint32_t i) {
            sum += components_[i].field(p);
            return false;
        });
        return sum > threshold_;
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override {
        Vec3d sum;
        tree_.any_at(p, [&](std::uint32_t i) {
            sum += components_[i].gradient(p);
            return false;
        });
        return -sum;
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    /// That of the component whose field is strongest here.
    [[nodiscard]] std::uint32_t material(Vec3d p, const Crossing&) const override {
        std::uint32_t material = scene::Solid::kInherited;
        double strongest = 0;
        for (const Component& c : components_) {
            const double field = c.field(p);
            if (field > strongest) strongest = field, material = c.material;
        }
        return material;
    }
    [[nodiscard]] std::vector<std::uint32_t> materials() const override {
        std::vector<std::uint32_t> found;
        for (const Component& c : components_)
            if (c.material != scene::Solid::kInherited) found.push_back(c.material);
        return found;
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        if (!materials().empty()) return {};
        ShapeNumbers out{ShapeNumbers::Kind::blob, {}};
        out.add(threshold_).add(static_cast<double>(components_.size()));
        for (const Component& c : components_) {
            const Affine3d& m = c.component_from_blob;
            out.add(m.x).add(m.y).add(m.z).add(m.t);
            out.add(c.kind == Component::Kind::axis ? c.length : 0).add(c.strength);
        }
        return out;
    }

private:
    /// Where the ray is within a part's reach and extent.
    void append_stretches(const Ray& ray, Range range, std::uint32_t index, Stretches& out) const {
        const Component& c = components_[index];
        const Ray own = transform_ray(c.component_from_blob, ray);
        if (c.kind == Component::Kind::ball) {
            append_stretch(range, index, Component::Part::start, quadratic_range(own, {1, 1, 1}, 0), out);
            return;
        }
        const double z = own.origin.z;
        const double dz = own.direction.z;
        Range before{-kInfinity, kInfinity};
        Range within = before;
        Range after = before;
        if (dz == 0) {
            if (z < 0) within = after = {1, 0};
            else if (z > c.length) before = within = {1, 0};
            else before = after = {1, 0};
        } else {
            const double t0 = -z / dz;
            const double t1 = (c.length - z) / dz;
            before = dz > 0 ? Range{-kInfinity, t0} : Range{t0, kInfinity};
            within = {std::min(t0, t1), std::max(t0, t1)};
            after = dz > 0 ? Range{t1, kInfinity} : Range{-kInfinity, t1};
        }
        append_stretch(common_range(range, before), index, Component::Part::start, quadratic_range(own, {1, 1, 1}, 0),
                       out);
        append_stretch(common_range(range, within), index, Component::Part::side, quadratic_range(own, {1, 1, 0}, 0),
                       out);
        append_stretch(common_range(range, after), index, Component::Part::end,
                       quadratic_range(own, {1, 1, 1}, c.length), out);
    }
    static Range common_range(Range a, Range b) { return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)}; }
    static void append_stretch(Range range, std::uint32_t index, Component::Part part, Range reach, Stretches& out) {
        const Range r = common_range(range, reach);
        if (r.lower < r.upper) out.push_back({r, index, part});
    }
    /// Where weights*(p - (0, 0, z))^2 < 1 along the ray.
    static Range quadratic_range(const Ray& ray, Vec3d weights, double z) {
        const Vec3d o = ray.origin - Vec3d{0, 0, z};
        const double a = dot(ray.direction * weights, ray.direction);
        if (a == 0) return dot(o * weights, o) < 1 ? Range{-kInfinity, kInfinity} : Range{1, 0};
        const double middle = -dot(o * weights, ray.direction) / a;
        const Vec3d nearest = o + ray.direction * middle;
        const double discriminant = 1 - dot(nearest * weights, nearest);
        if (!(discriminant > 0)) return {1, 0};
        const double half = std::sqrt(discriminant / a);
        return {middle - half, middle + half};
    }

    void append_piece(const Ray& ray, Range piece, const Stretches& stretches, Range range, bool& is_inside,
                      CrossingList& out) const {
        std::array<double, 5> sum;
        sum.fill(-threshold_);
        const double middle = 0.5 * (piece.lower + piece.upper);
        bool any = false;
        for (const Stretch& s : stretches) {
            if (!(s.range.lower <= piece.lower && s.range.upper >= piece.upper)) continue;
            any = true;
            const Component& c = components_[s.component];
            const auto reach_at = [&](double t) {
                return c.reach(transform_point(c.component_from_blob, ray.at(t)), s.part);
            };
            // A quadratic's Bernstein coefficients from its values at the ends and in the middle, then their square's.
            const double b0 = reach_at(piece.lower);
            const double b2 = reach_at(piece.upper);
            const double b1 = 2 * reach_at(middle) - 0.5 * (b0 + b2);
            sum[0] += c.strength * b0 * b0;
            sum[1] += c.strength * b0 * b1;
            sum[2] += c.strength * (b0 * b2 + 2 * b1 * b1) / 3;
            sum[3] += c.strength * b1 * b2;
            sum[4] += c.strength * b2 * b2;
        }
        const auto toggle_at = [&](double t) {
            if (range.contains(t)) out.push_back({t});
            is_inside = !is_inside;
        };
        if (!any) {
            if (is_inside != (0 > threshold_)) toggle_at(piece.lower);
            return;
        }
        if (sum[0] != 0 && (sum[0] > 0) != is_inside) toggle_at(piece.lower);
        RootList roots;
        append_bernstein_roots(sum, roots);
        for (const double s : roots) toggle_at(piece.lower + s * (piece.upper - piece.lower));
    }

    double threshold_;
    std::vector<Component> components_;
    BoundsTree tree_;
    Bounds3d box_;
};

}  // namespace

std::function<double(Vec3d)> component_field(const scene::BlobComponent& component) {
    return [compiled = compiled(component)](Vec3d p) { return compiled.field(p); };
}

ShapePointer make_shape(const scene::Blob& blob, const SourceLocation& where) {
    if (!(blob.threshold > 0)) refuse_shape(where, "a blob's threshold must be greater than 0");
    if (blob.components.empty()) refuse_shape(where, "a blob must have a component");
    for (const scene::BlobComponent& c : blob.components)
        if (!(c.radius > 0)) refuse_shape(where, "a blob component's radius must be greater than 0");
    return std::make_shared<Blob>(blob);
}

}  // namespace sundog::solids
