// SPDX-License-Identifier: Apache-2.0
// Motion by keyframes of a tree of nodes, as glTF 2.0 describes it (its specification, section 3.11 "Animations" and
// appendix C "Animation Sampler Interpolation Modes").
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "base/boxed.h"
#include "base/vec.h"
#include "scene/texture_use.h"

namespace sundog::scene {

/// A rotation by a unit quaternion x*i + y*j + z*k + w.
struct Quaternion {
    float x = 0, y = 0, z = 0, w = 1;
    friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// Numbers over time. Before the first key and after the last they stay as they are there.
struct KeyframeTrack {
    enum class Interpolation : std::uint8_t { step, linear, cubic } interpolation = Interpolation::linear;
    std::vector<float> times_s;  ///< Ascending, one or more.
    std::size_t width = 3;       ///< Numbers a key: 3, 4 (a quaternion), or as many as there are weights.
    std::vector<float> values;   ///< Of each key; cubic: its tangent before it, its value, its tangent after it.
};

/// A place in the tree, moved within its parent: scaled, then turned, then translated.
struct AnimatedNode {
    Index parent = kNone;  ///< Lies before the node.
    /// At rest. What has a track doesn't count.
    Vec3 translation{0, 0, 0};
    Quaternion rotation;
    Vec3 scale{1, 1, 1};
    Affine3 matrix;  ///< Of nodes that are placed by one and can't move; follows the others.
    Boxed<KeyframeTrack> translations, rotations, scales;
};

struct NodeTree {
    std::vector<AnimatedNode> nodes;
    Affine3 world_from_tree;
    float duration_s = 0;  ///< Then all begins again.
};

/// That something moves along with a node.
struct NodeMotion {
    std::shared_ptr<const NodeTree> tree;  ///< Never null where there is a motion.
    Index node = 0;
    Affine3 node_from_object;
};

Affine3 rotation_of(const Quaternion& q);

/// A track's value at a moment, `width` numbers; rotations are interpolated along the arc (slerp) and have length 1.
std::vector<float> value_at(const KeyframeTrack& track, float time_s, bool is_rotation);

/// The time within the tree's duration that a time stands for.
float moment_of(const NodeTree& tree, float time_s);

/// world_from_node at a moment.
Affine3 transform_at(const NodeTree& tree, Index node, float time_s);

/// world_from_object at a moment. Never singular: what is scaled to nothing is very small.
Affine3 transform_at(const NodeMotion& motion, float time_s);

}  // namespace sundog::scene
