// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/photon_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sundog::cpu {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostRings = 1e6;

/// A number in [0, 1) that belongs to a photon.
double random_of(std::uint32_t seed, std::uint32_t ring, std::uint32_t number, std::uint32_t which) {
    std::uint64_t h = (std::uint64_t{seed} << 32U | ring) * 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 30U)) + (std::uint64_t{number} << 2U | which);
    h *= 0xbf58476d1ce4e5b9ULL;
    h = (h ^ (h >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<double>((h ^ (h >> 31U)) >> 11U) * 0x1p-53;
}

/// Two unit vectors across `axis` and each other.
void set_across(const Vec3d& axis, Vec3d& side, Vec3d& up) {
    const Vec3d other = std::abs(axis.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    side = normalize(cross(axis, other));
    up = cross(side, axis);
}

}  // namespace

PhotonPattern PhotonPattern::from_point(Vec3 place, Vec3 center, float radius) {
    PhotonPattern p;
    p.origin_ = to_double(place);
    const Vec3d way = to_double(center) - p.origin_;
    const double distance = length(way);
    p.axis_ = distance > 0 ? way / distance : Vec3d{0, 0, 1};
    set_across(p.axis_, p.side_, p.up_);
    const bool inside = distance <= radius;
    p.reach_ = inside ? kPi : std::asin(radius / distance);
    // From the middle of its target a light would see the spacing under any angle.
    p.distance_ = std::max(distance, 0.5 * radius);
    return p;
}

PhotonPattern PhotonPattern::parallel(Vec3 direction, float ahead, Vec3 center, float radius) {
    PhotonPattern p;
    p.is_parallel_ = true;
    p.axis_ = to_double(direction);
    set_across(p.axis_, p.side_, p.up_);
    p.origin_ = to_double(center) - p.axis_ * static_cast<double>(ahead);
    p.reach_ = radius;
    return p;
}

double PhotonPattern::area() const {
    if (is_parallel_) return kPi * reach_ * reach_;
    return 2 * kPi * (1 - std::cos(reach_)) * distance_ * distance_;
}

void PhotonPattern::set_spacing(double spacing, double jitter, std::uint32_t seed) {
    const double step = is_parallel_ ? spacing : spacing / distance_;
    rings_ = static_cast<std::uint32_t>(std::clamp(std::ceil(reach_ / step), 1.0, kMostRings));
    step_ = reach_ / rings_;
    jitter_ = jitter;
    seed_ = seed;
}

std::uint32_t PhotonPattern::count_in(std::uint32_t ring) const {
    const double middle = (ring + 0.5) * step_;
    const double around = 2 * kPi * (is_parallel_ ? middle : std::sin(middle));
    return static_cast<std::uint32_t>(std::max(std::round(around / step_), 1.0));
}

std::uint64_t PhotonPattern::count() const {
    std::uint64_t sum = 0;
    for (std::uint32_t ring = 0; ring < rings_; ++ring) sum += count_in(ring);
    return sum;
}

double PhotonPattern::progress(std::uint32_t ring) const { return static_cast<double>(ring) / rings_; }

BatchPhoton PhotonPattern::photon(std::uint32_t ring, std::uint32_t number) const {
    const std::uint32_t count = count_in(ring);
    const double inner = ring * step_, outer = inner + step_;
    const double moved = jitter_ * (random_of(seed_, ring, number, 0) - 0.5);
    const double turned = jitter_ * (random_of(seed_, ring, number, 1) - 0.5);
    const double start = random_of(seed_, ring, 0, 2);
    const double out = std::abs((ring + 0.5 + moved) * step_);
    const double phi = 2 * kPi * (number + start + turned) / count;
    const Vec3d aside = side_ * std::cos(phi) + up_ * std::sin(phi);
    BatchPhoton p;
    p.ring = ring;
    double share = 0;
    if (is_parallel_) {
        p.origin = to_float(origin_ + aside * out);
        p.direction = to_float(axis_);
        share = kPi * (outer * outer - inner * inner) / count;
    } else {
        p.origin = to_float(origin_);
        p.direction = to_float(normalize(axis_ * std::cos(out) + aside * std::sin(out)));
        share = 2 * kPi * (std::cos(inner) - std::cos(outer)) / count;
    }
    const auto power = static_cast<float>(share);
    p.power = {power, power, power};
    return p;
}

}  // namespace sundog::cpu
