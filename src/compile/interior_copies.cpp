// SPDX-License-Identifier: Apache-2.0
#include "compile/interior_copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "compile/materials_of.h"
#include "kernel/shared.h"
#include "scene/bounds.h"

namespace sundog {
namespace {

using Numbers = std::vector<std::uint32_t>;  // Of interiors, ascending.

/// The numbers of the interiors of all materials of an object.
Numbers numbers_of(const scene::Scene& scene, const scene::Object& object) {
    Numbers found;
    std::uint32_t last = scene::kNone;
    for_each_material(object, [&](std::uint32_t material) {
        if (material == last || material >= scene.materials.size()) return;
        last = material;
        const scene::Material& m = scene.materials[material];
        if (m.patterned && m.patterned->interior_number != 0) found.push_back(m.patterned->interior_number);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// An object that has interiors with numbers.
struct Holder {
    std::size_t object;
    Numbers interiors;
    Bounds3 bounds;  ///< Empty: unknown, or without an end.
};

bool share(const Numbers& a, const Numbers& b) {
    return std::any_of(a.begin(), a.end(), [&](std::uint32_t n) { return std::binary_search(b.begin(), b.end(), n); });
}

/// Small objects by the cells of a grid that they lie in.
class Neighbours {
public:
    explicit Neighbours(const std::vector<Holder>& holders) {
        double sum = 0;
        std::size_t count = 0;
        for (const Holder& h : holders)
            if (!h.bounds.empty()) sum += static_cast<double>(longest_side(h.bounds)), ++count;
        side_ = count > 0 ? static_cast<float>(2 * sum / static_cast<double>(count)) : 1.0F;
        if (!(side_ > 0)) side_ = 1;
    }
    /// None for objects that are too large for it.
    [[nodiscard]] bool takes(const Bounds3& b) const {
        constexpr float kMostCells = 3;
        constexpr float kFarthest = 1e9F;
        const auto near = [&](Vec3 p) {
            return std::abs(p.x) < kFarthest * side_ && std::abs(p.y) < kFarthest * side_ &&
                   std::abs(p.z) < kFarthest * side_;
        };
        return !b.empty() && longest_side(b) <= kMostCells * side_ && near(b.lower) && near(b.upper);
    }
    template <class Visit>
    void for_each_cell(const Bounds3& b, const Visit& visit) {
        const auto cell = [&](float x) { return static_cast<std::int32_t>(std::floor(x / side_)); };
        for (std::int32_t x = cell(b.lower.x); x <= cell(b.upper.x); ++x)
            for (std::int32_t y = cell(b.lower.y); y <= cell(b.upper.y); ++y)
                for (std::int32_t z = cell(b.lower.z); z <= cell(b.upper.z); ++z) visit(cells_[{x, y, z}]);
    }

private:
    static float longest_side(const Bounds3& b) {
        const Vec3 e = b.extent();
        return std::max(e.x, std::max(e.y, e.z));
    }
    float side_ = 1;
    std::map<std::array<std::int32_t, 3>, std::vector<std::size_t>> cells_;
};

}  // namespace

InteriorCopies interior_copies(const scene::Scene& scene) {
    InteriorCopies copies;
    const bool any = std::any_of(scene.materials.begin(), scene.materials.end(), [](const scene::Material& m) {
        return m.patterned && m.patterned->interior_number != 0;
    });
    if (!any) return copies;

    std::vector<Holder> holders;
    std::unordered_map<std::uint32_t, std::size_t> parts;  // How many objects each owner has.
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        Numbers numbers = numbers_of(scene, object);
        if (numbers.empty()) continue;
        ++parts[object.interior_owner];
        const bool known = !scene::moves(object) && !std::holds_alternative<scene::Plane>(object.shape);
        holders.push_back({i, std::move(numbers), known ? scene::bounds_of(object) : Bounds3{}});
    }
    copies.of_object.assign(scene.objects.size(), 0);

    Neighbours neighbours(holders);
    std::vector<const Holder*> large;
    for (std::size_t h = 0; h < holders.size(); ++h) {
        const Holder& holder = holders[h];
        const std::uint32_t owner = scene.objects[holder.object].interior_owner;
        if (!neighbours.takes(holder.bounds) || (owner != 0 && parts[owner] > 1)) {
            large.push_back(&holder);
            continue;
        }
        std::vector<bool> taken;
        neighbours.for_each_cell(holder.bounds, [&](std::vector<std::size_t>& cell) {
            for (const std::size_t other : cell) {
                if (!scene::overlap(holder.bounds, holders[other].bounds)) continue;
                if (!share(holder.interiors, holders[other].interiors)) continue;
                const std::uint32_t copy = copies.of_object[holders[other].object];
                if (taken.size() <= copy) taken.resize(copy + 1);
                taken[copy] = true;
            }
            cell.push_back(h);
        });
        const auto free = static_cast<std::uint32_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
        copies.of_object[holder.object] = free;
        for (const std::uint32_t n : holder.interiors) copies.counts[n] = std::max(copies.counts[n], free + 1);
    }
    std::unordered_map<std::uint32_t, std::uint32_t> of_owner;
    for (const Holder* const holder : large) {
        const std::uint32_t owner = scene.objects[holder->object].interior_owner;
        std::uint32_t copy = 0;
        if (const auto known = of_owner.find(owner); owner != 0 && known != of_owner.end()) copy = known->second;
        else
            for (const std::uint32_t n : holder->interiors) copy = std::max(copy, copies.counts[n]);
        of_owner[owner] = copy;
        copies.of_object[holder->object] = copy;
        for (const std::uint32_t n : holder->interiors) copies.counts[n] = std::max(copies.counts[n], copy + 1);
    }

    std::size_t total = 0;
    for (const auto& [number, count] : copies.counts) total += count;
    constexpr std::size_t kMost = kernel::MAX_INTERIORS - 16;  // Some aren't interiors of objects.
    if (total > kMost) {
        const auto most = std::max(static_cast<std::uint32_t>(kMost / copies.counts.size()), 1U);
        for (std::uint32_t& copy : copies.of_object) copy %= most;
        for (auto& [number, count] : copies.counts) count = std::min(count, most);
    }
    return copies;
}

}  // namespace sundog
