// SPDX-License-Identifier: Apache-2.0
// The bounding volume hierarchy that GPUs walk too (device/bvh): eight children a node, in boxes of one byte a side,
// built by the surface area heuristic over binned centroids (Wald 2007); the walk goes by Ylitie, Karras and Laine
// (2017). Its box test errs on the side of visiting too much.
#include <array>
#include <bit>

#include "device/accel/structure.h"
#include "device/bvh/build.h"

namespace sundog::accel {
namespace {

class Bvh final : public Structure {
public:
    explicit Bvh(const Primitives& primitives) : bvh_(bvh::build(primitives.bounds())) {}

    void walk(Search& search, Scratch&) const override {
        const kernel::Ray& ray = search.ray();
        const kernel::BoxRay box_ray = kernel::box_ray(ray.origin, ray.direction);
        // The children yet to visit of each node between the root and the current one: so many there are at most.
        std::array<Family, kernel::BVH_MAX_DEPTH> stack;
        std::size_t depth = 0;
        std::uint32_t current = 0;
        while (true) {
            search.visit();
            const kernel::WideNode& node = bvh_.nodes[current];
            kernel::word inner = 0;
            kernel::word leaves = 0;
            kernel::node_hits(node, box_ray, ray.t_min, search.reach(), inner, leaves);
            for (; leaves != 0 && !search.done(); leaves &= leaves - 1)
                search.test(bvh_.order[node.primitive_base + static_cast<std::uint32_t>(std::countr_zero(leaves))]);
            if (search.done()) return;
            if (inner != 0) stack[depth++] = {node.child_base, node.exponents >> 24U, inner};
            if (depth == 0) return;
            current = next_child(stack[depth - 1], box_ray.octant);
            if (stack[depth - 1].hits == 0) --depth;
        }
    }
    [[nodiscard]] std::size_t memory_bytes() const override {
        return bvh_.nodes.capacity() * sizeof(kernel::WideNode) + bvh_.order.capacity() * sizeof(std::uint32_t);
    }

private:
    /// Children of a node.
    struct Family {
        std::uint32_t first, slots;  ///< The first's node, and which slots hold nodes.
        std::uint32_t hits;          ///< Those to visit, by slot ^ octant: the lowest is the nearest.
    };

    /// Takes the nearest child out; its node.
    static std::uint32_t next_child(Family& family, std::uint32_t octant) {
        const std::uint32_t slot = static_cast<std::uint32_t>(std::countr_zero(family.hits)) ^ octant;
        family.hits &= family.hits - 1;
        return family.first + static_cast<std::uint32_t>(std::popcount(family.slots & ((1U << slot) - 1)));
    }

    bvh::WideBvh bvh_;
};

}  // namespace

std::unique_ptr<Structure> make_bvh(const Primitives& primitives) { return std::make_unique<Bvh>(primitives); }

}  // namespace sundog::accel
