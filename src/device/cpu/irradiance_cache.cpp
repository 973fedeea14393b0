// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/irradiance_cache.h"

#include <algorithm>
#include <cmath>

namespace sundog::cpu {
namespace {

/// How far in front of a point, over its reach, a sample may lie: surfaces are curved.
constexpr float kInFront = 0.01F;
/// Least cosine between the normals of a sample and of a point that uses it.
constexpr float kLeastCosine = 0.9F;
constexpr std::size_t kFewestSlots = 1024;

/// Of one coordinate, the cell's number; far away ones share the last.
std::int64_t cell_of(float coordinate, double per_length) {
    const double cell = std::floor(static_cast<double>(coordinate) * per_length);
    return cell > -9e15 ? static_cast<std::int64_t>(std::min(cell, 9e15)) : -9'000'000'000'000'000;  // NaN, too
}

}  // namespace

IrradianceCache::IrradianceCache(float error_bound) : error_bound_(error_bound), slots_(kFewestSlots) {}

std::uint64_t IrradianceCache::key_of(const Grid& grid, std::int64_t x, std::int64_t y, std::int64_t z) {
    // Two cells that meet in one key only make for samples that are looked at in vain.
    const auto mix = [](std::uint64_t h, std::int64_t v) {
        h = (h ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15ULL;
        return h ^ (h >> 29U);
    };
    return mix(mix(mix(mix(0, grid.exponent), x), y), z);
}

const std::vector<IrradianceCache::Entry>* IrradianceCache::cell_at(std::uint64_t key) const {
    for (std::size_t i = key & (slots_.size() - 1); slots_[i].entries != 0; i = (i + 1) & (slots_.size() - 1))
        if (slots_[i].key == key) return &cells_[slots_[i].entries - 1];
    return nullptr;
}

std::vector<IrradianceCache::Entry>& IrradianceCache::make_cell(std::uint64_t key) {
    if ((cells_.size() + 1) * 2 > slots_.size()) grow();
    std::size_t i = key & (slots_.size() - 1);
    for (; slots_[i].entries != 0; i = (i + 1) & (slots_.size() - 1))
        if (slots_[i].key == key) return cells_[slots_[i].entries - 1];
    slots_[i] = {key, static_cast<std::uint32_t>(cells_.size() + 1)};
    return cells_.emplace_back();
}

void IrradianceCache::grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& slot : old) {
        if (slot.entries == 0) continue;
        std::size_t i = slot.key & (slots_.size() - 1);
        while (slots_[i].entries != 0) i = (i + 1) & (slots_.size() - 1);
        slots_[i] = slot;
    }
}

void IrradianceCache::add(const IrradianceSample& sample) {
    if (!is_finite(sample.position) || !is_finite(sample.normal) || !is_finite(sample.light)) return;
    const auto index = static_cast<std::uint32_t>(samples_.size());
    samples_.push_back(sample);
    const float radius = std::clamp(sample.reach * error_bound_, 1e-30F, 1e30F);
    const int exponent = std::ilogb(radius) + 1;  // a side of one to two radii
    auto grid =
        std::lower_bound(grids_.begin(), grids_.end(), exponent, [](const Grid& g, int e) { return g.exponent < e; });
    if (grid == grids_.end() || grid->exponent != exponent)
        grid = grids_.insert(grid, {exponent, std::ldexp(1.0, -exponent)});
    const Vec3 r{radius, radius, radius};
    const Vec3 lower = sample.position - r;
    const Vec3 upper = sample.position + r;
    const auto first = [&](float c) { return cell_of(c, grid->per_length); };
    for (std::int64_t x = first(lower.x); x <= first(upper.x); ++x)
        for (std::int64_t y = first(lower.y); y <= first(upper.y); ++y)
            for (std::int64_t z = first(lower.z); z <= first(upper.z); ++z) {
                std::vector<Entry>& cell = make_cell(key_of(*grid, x, y, z));
                // Both of two cells may have one key.
                if (cell.empty() || cell.back().sample != index)
                    cell.push_back({sample.position, sample.reach, sample.normal, index});
            }
}

template <class Visit>
void IrradianceCache::for_each_near(Vec3 position, Vec3 normal, float bound, const Visit& visit) const {
    for (const Grid& grid : grids_) {
        const std::vector<Entry>* cell =
            cell_at(key_of(grid, cell_of(position.x, grid.per_length), cell_of(position.y, grid.per_length),
                           cell_of(position.z, grid.per_length)));
        if (cell == nullptr) continue;
        for (const Entry& s : *cell) {
            const Vec3 offset = position - s.position;
            const float far = bound * s.reach;
            const float square = dot(offset, offset);
            if (square >= far * far) continue;
            const float cosine = dot(normal, s.normal);
            // By Ward's estimate alone a generous bound would let a wall light the floor.
            if (cosine < kLeastCosine) continue;
            const float error = std::sqrt(square) / s.reach + std::sqrt(std::max(1 - cosine, 0.0F));
            if (error >= bound) continue;
            // A sample in front of the point doesn't see what shades it.
            if (dot(offset, normal + s.normal) < -2 * kInFront * s.reach) continue;
            if (!visit(s, error)) return;
        }
    }
}

IrradianceLookup IrradianceCache::lookup(Vec3 position, Vec3 normal, float bound) const {
    IrradianceLookup found;
    float sum = 0;
    for_each_near(position, normal, bound, [&](const Entry& entry, float error) {
        const IrradianceSample& s = samples_[entry.sample];
        const float share = 1 - error / bound;
        const float weight = share * share;
        const Vec3 offset = position - s.position;
        const Vec3 turn = cross(s.normal, normal);
        const auto change = [&](std::size_t channel) {
            return dot(s.by_move[channel], offset) + dot(s.by_turn[channel], turn);
        };
        found.light += max(s.light + Vec3{change(0), change(1), change(2)}, {0, 0, 0}) * weight;
        sum += weight;
        ++found.count;
        return true;
    });
    if (sum > 0) found.light = found.light / sum;
    else found.count = 0;
    return found;
}

bool IrradianceCache::has(int count, Vec3 position, Vec3 normal, float bound) const {
    for_each_near(position, normal, bound, [&](const Entry&, float) { return --count > 0; });
    return count <= 0;
}

}  // namespace sundog::cpu
