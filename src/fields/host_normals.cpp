// SPDX-License-Identifier: Apache-2.0
// Normals with formulas of their own that only the host computes, as pictures of povray 3.7 show them.
#include <cmath>
#include <limits>
#include <numbers>

#include "fields/host_fields.h"
#include "fields/quilted.h"
#include "kernel/patterns/noise.h"

namespace sundog::fields {
namespace {

/// The seams' slopes grow towards the corners of cells.
class QuiltedNormal final : public HostField {
public:
    QuiltedNormal(double control0, double control1) : control0_(control0), control1_(control1) {}
    [[nodiscard]] Vec3d at(const FieldPoint& point) const override {
        const Vec3d d = from_cell_middle(point.position);
        return d * (std::numbers::sqrt3 * quilted_curve(control0_, control1_, length(d)));
    }

private:
    double control0_, control1_;
};

/// Ten bits of a hash as a number in -1..1.
double random_part(std::uint32_t bits) { return static_cast<double>(kernel::signed_unit(bits)); }

kernel::vec3 to_kernel_vec(Vec3d v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The nearest of points that are strewn one a cell.
struct StrewnPoint {
    Vec3d place;
    std::uint32_t hash = 0;
};
StrewnPoint nearest_strewn(Vec3d p) {
    const Vec3d home{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    StrewnPoint best;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 27; ++i) {
        const int plane = i / 9;
        const Vec3d cell = home + Vec3d{i % 3 - 1.0, i / 3 % 3 - 1.0, plane - 1.0};
        const std::uint32_t hash = kernel::cell_hash(to_kernel_vec(cell), 0x17U);
        const Vec3d jitter{random_part(hash), random_part(hash >> 10U), random_part(hash >> 20U)};
        const Vec3d place = cell + jitter * 0.5 + Vec3d{0.5, 0.5, 0.5};
        const Vec3d offset = place - p;
        if (const double d = dot(offset, offset); d < nearest) nearest = d, best = {place, hash};
    }
    return best;
}

class FacetsNormal final : public HostField {
public:
    FacetsNormal(double coords, double size) : coords_(coords), size_(size) {}
    [[nodiscard]] Vec3d at(const FieldPoint& point) const override {
        if (size_ > 0) return normalize(nearest_strewn(point.normal / size_).place) - point.normal;
        constexpr double kCellsPerUnit = 10, kSpread = 0.42;
        const std::uint32_t hash = kernel::hash_word(nearest_strewn(point.position * kCellsPerUnit).hash);
        return Vec3d{random_part(hash), random_part(hash >> 10U), random_part(hash >> 20U)} * (kSpread * coords_);
    }

private:
    double coords_, size_;
};

}  // namespace

std::unique_ptr<HostField> make_host_normal(const scene::Pattern& pattern) {
    if (pattern.kind == scene::Pattern::Kind::facets)
        return std::make_unique<FacetsNormal>(pattern.facet_coords, pattern.facet_size);
    return std::make_unique<QuiltedNormal>(pattern.control0, pattern.control1);
}

}  // namespace sundog::fields
