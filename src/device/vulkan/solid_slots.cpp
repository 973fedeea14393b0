// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/solid_slots.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/diagnostics.h"
#include "device/vulkan/shaders/layout.h"
#include "solids/compiled_solid.h"

namespace sundog::vulkan {
namespace {

using solids::CompiledSolid;
using solids::ShapeNumbers;

/// Groups in each other: a word holds two bits for each.
constexpr std::uint32_t kMaxDepth = 16;

static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::sphere) == kernel::SHAPE_SPHERE);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::box) == kernel::SHAPE_BOX);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::half_space) == kernel::SHAPE_HALF_SPACE);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::cone) == kernel::SHAPE_CONE);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::quadric) == kernel::SHAPE_QUADRIC);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::disc) == kernel::SHAPE_DISC);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::torus) == kernel::SHAPE_TORUS);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::polynomial) == kernel::SHAPE_POLYNOMIAL);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::polygon) == kernel::SHAPE_POLYGON);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::prism) == kernel::SHAPE_PRISM);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::revolution) == kernel::SHAPE_REVOLUTION);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::lathe) == kernel::SHAPE_LATHE);
static_assert(static_cast<std::uint32_t>(ShapeNumbers::Kind::blob) == kernel::SHAPE_BLOB);
static_assert(scene::Solid::kInherited == kernel::NONE);

std::uint64_t slot(std::uint32_t low, std::uint32_t high) { return low | (std::uint64_t{high} << 32U); }

std::uint32_t flags_of(const CompiledSolid::Node& node) {
    std::uint32_t flags = 0;
    switch (node.combination) {
        case solids::Combination::leaf:
            flags = kernel::SOLID_LEAF;
            break;
        case solids::Combination::combined:
            flags = kernel::SOLID_COMBINED;
            break;
        case solids::Combination::merged:
            flags = kernel::SOLID_MERGED;
            break;
        case solids::Combination::common:
            flags = kernel::SOLID_COMMON;
            break;
        case solids::Combination::clipped:
            flags = kernel::SOLID_CLIPPED;
            break;
    }
    return flags | (node.inverted ? kernel::SOLID_INVERTED : 0U) | (node.state_beyond ? kernel::SOLID_BEYOND : 0U) |
           (node.unbounded ? kernel::SOLID_UNBOUNDED : 0U) |
           (node.gate != CompiledSolid::kNoGate ? kernel::SOLID_GATED : 0U);
}

/// Writes the trees of one solid after the other.
class SlotWriter {
public:
    explicit SlotWriter(SolidSlots& out) : out_(out) {}

    void append(const CompiledSolid& solid) {
        solid_ = &solid;
        out_.roots.push_back(here());
        waiting_.clear();
        append_node(0, kernel::NONE, 0);
        for (const auto& [node, slot_of_node] : waiting_) append_numbers(solid.nodes()[node], slot_of_node);
    }

private:
    [[nodiscard]] std::uint32_t here() const { return static_cast<std::uint32_t>(out_.slots.size()); }

    void append_node(std::uint32_t index, std::uint32_t parent, std::uint32_t depth) {
        const CompiledSolid::Node& node = solid_->nodes()[index];
        const std::uint32_t first = here();
        out_.slots.resize(first + kernel::SOLID_NODE_SLOTS);
        append_box(node.active, first + kernel::SOLID_NODE_BOX);
        std::uint32_t flags = flags_of(node);
        if (node.combination == solids::Combination::leaf) {
            const auto kind = static_cast<std::uint32_t>(solid_->leaves()[node.first].shape->numbers().kind);
            flags |= kind << kernel::SOLID_KIND_SHIFT;
            out_.kinds |= 1U << kind;
        } else {
            out_.depth = std::max(out_.depth, depth + 1);
            for (std::uint32_t child = 0; child < node.count; ++child)
                append_node(node.first + child, first, depth + 1);
        }
        out_.slots[first] = slot(flags, here());
        out_.slots[first + 1] = slot(parent, 0);
        if (node.combination == solids::Combination::leaf || node.gate != CompiledSolid::kNoGate)
            waiting_.emplace_back(index, first);
    }
    /// What nodes refer to stands behind the whole tree.
    void append_numbers(const CompiledSolid::Node& node, std::uint32_t slot_of_node) {
        if (node.gate != CompiledSolid::kNoGate) {
            out_.slots[slot_of_node + 2] = slot(here(), 0);
            out_.slots.resize(out_.slots.size() + 3);
            append_box(solid_->gates()[node.gate], here() - 3);
        }
        if (node.combination != solids::Combination::leaf) return;
        out_.slots[slot_of_node + 1] |= slot(0, here());
        const CompiledSolid::Leaf& leaf = solid_->leaves()[node.first];
        out_.slots.push_back(slot(leaf.material, leaf.interior_material));
        const Affine3d& m = leaf.shape_from_world;
        for (const Vec3d column : {m.x, m.y, m.z, m.t})
            for (const double value : {column.x, column.y, column.z}) append_number(value);
        for (const double value : leaf.shape->numbers().values) append_number(value);
    }
    void append_number(double value) { out_.slots.push_back(std::bit_cast<std::uint64_t>(value)); }

    /// Its corners, rounded outwards.
    void append_box(const Bounds3d& box, std::uint32_t at) {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const auto down = [](double v) { return std::nextafter(static_cast<float>(v), -infinity); };
        const auto up = [](double v) { return std::nextafter(static_cast<float>(v), infinity); };
        const float sides[6] = {down(box.lower.x), down(box.lower.y), down(box.lower.z),
                                up(box.upper.x),   up(box.upper.y),   up(box.upper.z)};
        for (std::uint32_t i = 0; i < 3; ++i)
            out_.slots[at + i] =
                slot(std::bit_cast<std::uint32_t>(sides[2 * i]), std::bit_cast<std::uint32_t>(sides[2 * i + 1]));
    }

    SolidSlots& out_;
    const CompiledSolid* solid_ = nullptr;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> waiting_;  ///< Nodes with numbers, and their slots.
};

std::uint32_t depth_of(const CompiledSolid& solid, std::uint32_t index) {
    const CompiledSolid::Node& node = solid.nodes()[index];
    if (node.combination == solids::Combination::leaf) return 0;
    std::uint32_t deepest = 0;
    for (std::uint32_t child = 0; child < node.count; ++child)
        deepest = std::max(deepest, depth_of(solid, node.first + child));
    return deepest + 1;
}

/// Prisms (and letters) below a node.
std::uint32_t prisms_of(const CompiledSolid& solid, std::uint32_t index) {
    const CompiledSolid::Node& node = solid.nodes()[index];
    if (node.combination == solids::Combination::leaf)
        return solid.leaves()[node.first].shape->numbers().kind == ShapeNumbers::Kind::prism ? 1 : 0;
    std::uint32_t count = 0;
    for (std::uint32_t child = 0; child < node.count; ++child) count += prisms_of(solid, node.first + child);
    return count;
}

/// Of more prisms than this that have something in common, shaders have been seen to lose strips of sides that coincide
/// (bevelled letters).
constexpr std::uint32_t kMostCommonPrisms = 2;

bool has_many_common_prisms(const CompiledSolid& solid) {
    for (std::uint32_t i = 0; i < solid.nodes().size(); ++i)
        if (solid.nodes()[i].combination == solids::Combination::common && prisms_of(solid, i) > kMostCommonPrisms)
            return true;
    return false;
}

}  // namespace

std::string not_drawn_of(const CompiledSolid& solid) {
    for (const CompiledSolid::Leaf& leaf : solid.leaves())
        if (leaf.shape->numbers().kind == ShapeNumbers::Kind::none)
            return std::string("is or has ") + leaf.kind + ", which only the CPU draws";
    if (has_many_common_prisms(solid))
        return "is or has an intersection of more than " + std::to_string(kMostCommonPrisms) +
               " prisms or letters, which only the CPU draws";
    if (depth_of(solid, 0) > kMaxDepth)
        return "has groups nested more than " + std::to_string(kMaxDepth) + " deep, which only the CPU draws";
    return {};
}

SolidSlots solid_slots(const RenderScene& scene) {
    SolidSlots out;
    SlotWriter writer(out);
    for (const PlacedSolid& placed : scene.solids) {
        writer.append(*placed.solid);
        if (out.slots.size() > kernel::NONE) throw DeviceError("the scene's exact solids are too many for a GPU");
    }
    return out;
}

}  // namespace sundog::vulkan
