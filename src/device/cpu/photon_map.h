// SPDX-License-Identifier: Apache-2.0
// Photons in a balanced tree (Bentley, Multidimensional Binary Search Trees, 1975), asked for the nearest ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/photons.h"

namespace sundog::cpu {

/// Immutable once built: many threads may ask.
class PhotonMap {
public:
    /// Which photons are wanted.
    struct Search {
        Vec3 point;
        /// On a surface: unit; only photons count that lie on surfaces that face about the same way, and those off the
        /// surface's plane are as if four times as far off it. Zero: all count alike.
        Vec3 normal;
        int most = 100;    ///< The nearest ones.
        float radius = 0;  ///< None further away.
    };
    /// What was found.
    struct Found {
        int count = 0;
        Vec3 power;        ///< Sum of all; half of the last one's if there are as many as were wanted.
        Vec3 toward;       ///< Where most of it came from, not normalised.
        float radius = 0;  ///< Of what was searched: up to the last one if there are as many as were wanted.
    };
    /// Memory of one caller. Keeps what the last search found, where the next one starts from: results don't depend on
    /// it.
    class Scratch {
        friend class PhotonMap;
        std::vector<std::uint64_t> candidates;  ///< What of photons is found: keys (photon_map.cpp).
        std::vector<std::uint32_t> photons;     ///< Their numbers, in order.
        Vec3 last_point;
        float last_radius = -1;  ///< Under 0: none.
    };

    PhotonMap() = default;
    explicit PhotonMap(std::vector<StoredPhoton> photons);

    [[nodiscard]] bool empty() const { return photons_.empty(); }
    [[nodiscard]] Found find(const Search& search, Scratch& scratch) const;
    /// The radius that `most` photons around a photon take, for half of all photons.
    [[nodiscard]] float typical_radius(int most) const;

private:
    struct Node {
        float split = 0;
        std::uint32_t axis = 0;
    };

    void build(std::size_t node, std::size_t begin, std::size_t end, std::size_t level);
    void collect(const Search& search, float radius, Scratch& scratch) const;

    /// Where photons are, axis by axis: a leaf's distances are computed together. As many again as a leaf has lie
    /// behind the last ones, and mean nothing.
    struct Places {
        std::vector<float> x, y, z;
    };

    std::vector<StoredPhoton> photons_;  ///< In the leaves' order.
    Places places_;                      ///< Of photons_.
    std::vector<Node> nodes_;            ///< A complete tree: children of node i are 2 i + 1 and 2 i + 2.
    std::size_t levels_ = 0;
};

}  // namespace sundog::cpu
