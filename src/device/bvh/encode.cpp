// SPDX-License-Identifier: Apache-2.0
#include "device/bvh/encode.h"

#include <algorithm>
#include <cmath>

namespace sundog::bvh {
namespace {

using kernel::BVH_WIDTH;

constexpr int kExponentBias = 127;
constexpr int kSmallestExponent = -126;  // 2^e stays a normal float
constexpr int kLargestExponent = 127;

void put_byte(std::uint32_t (&words)[2], std::uint32_t slot, std::uint32_t byte) {
    words[slot / 4] |= byte << (8 * (slot % 4));
}

std::uint32_t byte_of(const std::uint32_t (&words)[2], std::uint32_t slot) {
    return (words[slot / 4] >> (8 * (slot % 4))) & 0xFFU;
}

/// The smallest e with origin + 255 * 2^e >= upper.
int exponent_for(float origin, float upper) {
    const double extent = static_cast<double>(upper) - static_cast<double>(origin);
    if (extent <= 0) return kSmallestExponent;
    int e = 0;
    std::frexp(extent / 255, &e);  // extent / 255 < 2^e
    if (std::ldexp(255.0, e - 1) >= extent) --e;
    return std::clamp(e, kSmallestExponent, kLargestExponent);
}

/// Byte planes of one axis of one child. Differences of floats are exact enough in double: what rounding there is
/// is undone by checking.
void quantise(float origin, int exponent, float lower, float upper, std::uint32_t& lower_q, std::uint32_t& upper_q) {
    const double step = std::ldexp(1.0, exponent);
    const double o = origin;
    const auto byte = [](double q) { return static_cast<std::uint32_t>(std::clamp(q, 0.0, 255.0)); };
    lower_q = byte(std::floor((lower - o) / step));
    if (lower_q > 0 && o + lower_q * step > lower) --lower_q;
    upper_q = byte(std::ceil((upper - o) / step));
    if (upper_q < 255 && o + upper_q * step < upper) ++upper_q;
}

/// Matches children to slots so that each lies as far as possible towards its slot's corner of the node: greedily,
/// the best of all pairs first.
std::array<std::uint32_t, BVH_WIDTH> assign_slots(std::span<const Child> children, Vec3 center) {
    std::array<std::array<float, BVH_WIDTH>, BVH_WIDTH> gain{};
    for (std::size_t c = 0; c < children.size(); ++c) {
        const Vec3 d = children[c].bounds.center() - center;
        for (std::uint32_t slot = 0; slot < BVH_WIDTH; ++slot) {
            gain[c][slot] = (slot & 1U ? d.x : -d.x) + (slot & 2U ? d.y : -d.y) + (slot & 4U ? d.z : -d.z);
        }
    }
    std::array<std::uint32_t, BVH_WIDTH> child_in_slot;
    child_in_slot.fill(BVH_WIDTH);
    std::array<bool, BVH_WIDTH> placed{};
    for (std::size_t round = 0; round < children.size(); ++round) {
        std::uint32_t best_child = BVH_WIDTH;
        std::uint32_t best_slot = 0;
        for (std::uint32_t c = 0; c < children.size(); ++c) {
            if (placed[c]) continue;
            for (std::uint32_t slot = 0; slot < BVH_WIDTH; ++slot) {
                if (child_in_slot[slot] != BVH_WIDTH) continue;
                if (best_child == BVH_WIDTH || gain[c][slot] > gain[best_child][best_slot]) {
                    best_child = c;
                    best_slot = slot;
                }
            }
        }
        child_in_slot[best_slot] = best_child;
        placed[best_child] = true;
    }
    return child_in_slot;
}

}  // namespace

PackedNode pack(std::span<const Child> children) {
    PackedNode packed{};
    kernel::WideNode& node = packed.node;
    Bounds3 bounds;
    for (const Child& child : children) bounds.include(child.bounds);
    if (bounds.empty()) bounds = {{0, 0, 0}, {0, 0, 0}};
    packed.child_in_slot = assign_slots(children, bounds.center());

    node.origin = {bounds.lower.x, bounds.lower.y, bounds.lower.z};
    std::array<int, 3> exponents{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        exponents[axis] = exponent_for(bounds.lower[axis], bounds.upper[axis]);
        node.exponents |= static_cast<std::uint32_t>(exponents[axis] + kExponentBias) << (8 * axis);
    }
    std::uint32_t primitive_count = 0;
    for (std::uint32_t slot = 0; slot < BVH_WIDTH; ++slot) {
        if (packed.child_in_slot[slot] == BVH_WIDTH) continue;
        const Child& child = children[packed.child_in_slot[slot]];
        if (child.leaf_count == 0) {
            node.exponents |= 1U << (24 + slot);
        } else {
            put_byte(node.leaves, slot, child.leaf_count << 5U | primitive_count);
            primitive_count += child.leaf_count;
        }
        std::array<std::uint32_t, 3> lower{};
        std::array<std::uint32_t, 3> upper{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            quantise(bounds.lower[axis], exponents[axis], child.bounds.lower[axis], child.bounds.upper[axis],
                     lower[axis], upper[axis]);
        }
        put_byte(node.lower_x, slot, lower[0]), put_byte(node.upper_x, slot, upper[0]);
        put_byte(node.lower_y, slot, lower[1]), put_byte(node.upper_y, slot, upper[1]);
        put_byte(node.lower_z, slot, lower[2]), put_byte(node.upper_z, slot, upper[2]);
    }
    return packed;
}

Bounds3 unpack(const kernel::WideNode& node, std::uint32_t slot) {
    const auto plane = [&](float origin, std::uint32_t axis, std::uint32_t byte, float towards) {
        const int exponent = static_cast<int>((node.exponents >> (8 * axis)) & 0xFFU) - kExponentBias;
        const double exact = static_cast<double>(origin) + std::ldexp(static_cast<double>(byte), exponent);
        const auto rounded = static_cast<float>(exact);
        const bool inside = towards < 0 ? rounded > exact : rounded < exact;
        return inside ? std::nextafter(rounded, towards) : rounded;
    };
    Bounds3 box;
    box.lower = {plane(node.origin.x, 0, byte_of(node.lower_x, slot), -INFINITY),
                 plane(node.origin.y, 1, byte_of(node.lower_y, slot), -INFINITY),
                 plane(node.origin.z, 2, byte_of(node.lower_z, slot), -INFINITY)};
    box.upper = {plane(node.origin.x, 0, byte_of(node.upper_x, slot), INFINITY),
                 plane(node.origin.y, 1, byte_of(node.upper_y, slot), INFINITY),
                 plane(node.origin.z, 2, byte_of(node.upper_z, slot), INFINITY)};
    return box;
}

}  // namespace sundog::bvh
