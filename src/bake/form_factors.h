// SPDX-License-Identifier: Apache-2.0
// Which surfaces a point gets light from, and how much of its view they take: a hierarchy of radiosity (Hanrahan,
// Salzman and Aupperle, A Rapid Hierarchical Radiosity Algorithm, SIGGRAPH 1991) whose links end at points.
#pragma once

#include <vector>

#include "bake/element_tree.h"
#include "device/cpu/triangle_occluders.h"

namespace sundog::bake {

/// Surfaces that exchange light. All arrays of vertices are parallel.
struct Surfaces {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  ///< Unit; a vertex's front is where it points.
    std::vector<Vec3> inside;   ///< Where the light of each vertex arrives: beside it, in the middle of a face.
    std::vector<TriangleIndices> triangles;
};

/// How far off surfaces rays begin and end, for rounding.
float lift_of(std::span<const Vec3> positions);

/// Something for the front and the back of a surface.
template <class T>
using Sides = std::array<T, 2>;

/// Immutable once built: any number of threads may ask, each with a Query of its own.
class FormFactors {
public:
    /// One side of a node of tree(), and which share of a point's view it takes.
    struct Link {
        std::uint32_t node : 31;
        std::uint32_t back : 1;
        float share;
    };
    struct Query {
        std::vector<Link> links;
        std::vector<std::uint32_t> stack;
    };

    /// `occluders`, which must outlive this, stop light; no reference to `surfaces` is kept. `detail`, for each
    /// triangle: how many times smaller than kMostShare its shares are to be, 1 or more; empty: 1 for all.
    FormFactors(const Surfaces& surfaces, const cpu::TriangleOccluders& occluders, std::span<const float> detail);

    /// Puts all that a point of a surface sees into query.links, in an order that doesn't vary. Nodes are as large as
    /// their shares allow, so links are about as many, however fine triangles are: each has a share of at most
    /// kMostShare (by its detail), and one ray to its middle (Wallace, Elmquist and Haines 1989). Triangles that take
    /// more are divided until rays to their parts are that dense, and measured exactly where they are near
    /// (triangle_form_factor()).
    void find(Vec3 point, Vec3 normal, Query& query) const;

    [[nodiscard]] const ElementTree& tree() const { return tree_; }
    /// Triangles on which something stands between middle and corners: what is beyond it, seen from the middle, takes
    /// part as if it were one node more, after those of the tree, in this order.
    [[nodiscard]] const std::vector<std::uint32_t>& divided() const { return divided_; }
    /// A triangle's unit normal, by the order of its corners.
    [[nodiscard]] Vec3 face(std::uint32_t triangle) const { return faces_[triangle]; }

    /// Whether something stands on the surface between two of its points, on either of its sides: then light on both
    /// sides of that has nothing in common.
    [[nodiscard]] bool is_walled(Vec3 a, Vec3 b, Vec3 normal) const;
    /// Whether something stands on a triangle between its middle and where the light of a corner arrives.
    [[nodiscard]] bool is_corner_walled(std::uint32_t triangle, std::size_t corner) const {
        return (walled_[triangle] >> corner & 1) != 0;
    }

    static constexpr float kMostShare = 1.0F / 128;

private:
    struct Receiver {
        Vec3 point, normal, origin;
    };
    struct Corners {
        Vec3 a, b, c;
    };
    static Vec3 middle_of(const Corners& t) { return (t.a + t.b + t.c) / 3; }

    [[nodiscard]] bool sees(const Receiver& receiver, Vec3 place, Vec3 normal) const;
    /// Of a triangle: of what is on its middle's side of any wall, and beyond.
    struct Shares {
        float here = 0, beyond = 0;
    };
    /// Adds what is seen of a triangle's part; parts of that take about `most` each.
    void add_share(const Receiver& receiver, std::uint32_t triangle, const Corners& part, float area, float most,
                   int level, Shares& shares) const;
    /// About the middle of what of a triangle is above the horizon, which one of its corners is.
    [[nodiscard]] static Vec3 part_above(const Receiver& receiver, Corners t);
    /// Where a node is looked at: in its middle, or in that of its part above the horizon.
    [[nodiscard]] Vec3 place_of(const Receiver& receiver, const ElementTree::Node& node) const;
    /// The share of a node as a disc, if that is good enough; else negative.
    [[nodiscard]] static float share_of(const Receiver& receiver, const ElementTree::Node& node, float most);

    std::vector<Corners> corners_;
    std::vector<Vec3> faces_;  ///< Unit normals of triangles.
    std::vector<float> most_;  ///< The largest share of each node.
    std::vector<std::uint32_t> divided_;
    std::vector<std::uint8_t> walled_;  ///< Of each triangle: bits of its corners, for is_corner_walled().
    ElementTree tree_;
    const cpu::TriangleOccluders& occluders_;
    float lift_;
};

}  // namespace sundog::bake
