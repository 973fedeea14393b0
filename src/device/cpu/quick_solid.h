// SPDX-License-Identifier: Apache-2.0
// What of a solid a packet's rays can be told together: all, or where alone on them it may be.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3d.h"
#include "solids/compiled_solid.h"

namespace sundog::cpu {

/// Solids of more shapes or nodes are not put together for a packet.
inline constexpr std::size_t kMaxQuickParts = 16, kMaxQuickNodes = 40;

/// What must be so where a part's surface is to be seen.
struct QuickCondition {
    std::uint32_t node = 0;
    bool inside = false;  ///< Inside of that node, or outside.
};

/// A shape in its own space, as numbers (solids/shape_numbers.h).
struct QuickPart {
    enum class Kind : std::uint8_t { sphere, box, half_space, cone, quadric, disc, torus, anything };
    Kind kind = Kind::anything;
    bool exact = false;      ///< Else the stretch found on a ray is one around the shape's.
    bool all_shows = true;   ///< Else faces other than 0 aren't there: an open cone's ends, the plane around a disc.
    bool shows = true;       ///< Some of its surface may be seen: it doesn't only clip.
    bool flips = false;      ///< What is outside of it is inside of what its surface is seen as.
    std::uint32_t leaf = 0;  ///< Into CompiledSolid::leaves().
    std::uint32_t front_material = 0, back_material = 0;  ///< What rays see that come from outside, and others.
    std::vector<QuickCondition> conditions;
    Affine3d shape_from_world;
    std::array<double, 12> numbers{};
};

struct QuickNode {
    enum class Kind : std::uint8_t {
        part,    ///< `first` is into the parts.
        common,  ///< Inside all children.
        joined,  ///< Inside any.
        anything,
    };
    Kind kind = Kind::anything;
    bool inverted = false;
    std::uint32_t first = 0;  ///< Of `count` children, neighbours.
    std::uint32_t count = 0;
};

struct QuickSolid {
    std::vector<QuickPart> parts;
    std::vector<QuickNode> nodes;  ///< The root is first; empty where nothing is known.
    bool complete = false;  ///< All of the solid is here; else what lies off the nodes' stretches is known alone.

    bool plain = false;  ///< No material looks at texture coordinates.

    explicit QuickSolid(const solids::CompiledSolid& solid);
    [[nodiscard]] bool useful() const { return !nodes.empty(); }

private:
    bool make_complete(const solids::CompiledSolid& solid);
    void set_conditions(const solids::CompiledSolid& solid, std::size_t index, QuickPart above);
    void make_stretches(const solids::CompiledSolid& solid, std::size_t from, std::size_t to);
};

}  // namespace sundog::cpu
