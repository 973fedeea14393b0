// SPDX-License-Identifier: Apache-2.0
// What of a solid a packet's rays can be told together: all, or where alone on them it may be.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3d.h"
#include "solids/compiled_solid.h"

namespace sundog::cpu {

/// Solids of more nodes are asked ray by ray.
inline constexpr std::size_t kMaxQuickNodes = 24;
/// So many convex parts, and no more, are put together exactly.
inline constexpr std::size_t kMaxExactParts = 8;

/// A shape in its own space, as numbers (solids/shape_numbers.h).
struct QuickPart {
    enum class Kind : std::uint8_t { sphere, box, half_space, cone, quadric, torus, anything };
    /// How a part counts where the solid is put together exactly.
    enum class Role : std::uint8_t {
        keep,  ///< What is there is inside of this one; its surface shows.
        cut,   ///< Outside; its surface shows.
        clip,  ///< Inside; its surface doesn't show.
    };
    Kind kind = Kind::anything;
    Role role = Role::keep;
    std::uint32_t leaf = 0;  ///< Into CompiledSolid::leaves().
    Affine3d shape_from_world;
    std::array<double, 12> numbers{};
};

/// A node of which a stretch of each ray is known, off which it neither shows nor is inside.
struct QuickNode {
    enum class Kind : std::uint8_t {
        part,    ///< `first` is into the parts.
        common,  ///< The stretch that all children have in common.
        joined,  ///< A stretch around all children's.
        anything,
    };
    Kind kind = Kind::anything;
    std::uint32_t first = 0;  ///< Of `count` children, neighbours.
    std::uint32_t count = 0;
};

struct QuickSolid {
    std::vector<QuickPart> parts;
    std::vector<QuickNode> nodes;  ///< The root is first; empty where `exact`, or where nothing is known.
    bool exact = false;            ///< The solid is its parts by their roles, all of them convex.

    explicit QuickSolid(const solids::CompiledSolid& solid);
    [[nodiscard]] bool useful() const { return exact || !nodes.empty(); }

private:
    bool make_exact(const solids::CompiledSolid& solid);
    void make_node(const solids::CompiledSolid& solid, std::size_t from, std::size_t to);
};

}  // namespace sundog::cpu
