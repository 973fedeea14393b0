// SPDX-License-Identifier: Apache-2.0
// What all structures have in common. Each is one class in one file, which says who described it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "device/accel/search.h"
#include "device/acceleration.h"

namespace sundog::accel {

/// Which items a ray has been tested against (mailboxing: Arnaldi, Priol and Bouatouch, "A New Space Subdivision Method
/// for Ray Tracing CSG Modelled Scenes", The Visual Computer 1987): an item that lies in many cells is tested once.
class Mailboxes {
public:
    /// Begins a ray through `count` items.
    void begin(std::uint32_t count) {
        if (letters_.size() < count) letters_.resize(count, 0);
        if (++ray_ != 0) return;
        letters_.assign(letters_.size(), 0);  // rays are counted anew after 2^32 of them
        ray_ = 1;
    }
    /// True the first time that a ray asks for the item.
    bool is_first(std::uint32_t item) { return std::exchange(letters_[item], ray_) != ray_; }

private:
    std::vector<std::uint32_t> letters_;  ///< The last ray that asked, for each item.
    std::uint32_t ray_ = 0;
};

/// What a walk needs to remember; each thread has its own, and keeps it for the next ray.
struct Scratch {
    Mailboxes mailboxes;
    /// Boxes that the ray enters, and where.
    std::vector<std::pair<float, std::uint32_t>> entered;
};

/// Finds out which primitives a ray has to be tested against.
class Structure {
public:
    Structure() = default;
    Structure(const Structure&) = delete;
    Structure& operator=(const Structure&) = delete;
    virtual ~Structure() = default;

    /// Tests every item whose box the ray meets up to search.reach(), as far as possible from near to far; ends when
    /// nothing is left in reach. Items may be tested more than once, and others too.
    virtual void walk(Search& search, Scratch& scratch) const = 0;
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;
};

// The primitives must outlive the structure, and have at least one item.
std::unique_ptr<Structure> make_no_structure(const Primitives& primitives);
std::unique_ptr<Structure> make_object_boxes(const Primitives& primitives);
std::unique_ptr<Structure> make_grid(const Primitives& primitives);
std::unique_ptr<Structure> make_octree(const Primitives& primitives);
std::unique_ptr<Structure> make_kd_tree(const Primitives& primitives);
std::unique_ptr<Structure> make_bvh(const Primitives& primitives);

/// Any but Acceleration::embree.
std::unique_ptr<Structure> make_structure(Acceleration which, const Primitives& primitives);

}  // namespace sundog::accel
