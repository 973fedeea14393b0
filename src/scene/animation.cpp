// SPDX-License-Identifier: Apache-2.0
#include "scene/animation.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace sundog::scene {
namespace {

/// Of keys, the value that keys are at (cubic keys have tangents around it).
std::span<const float> key_value(const KeyframeTrack& track, std::size_t key) {
    const bool cubic = track.interpolation == KeyframeTrack::Interpolation::cubic;
    const std::size_t first = cubic ? (3 * key + 1) * track.width : key * track.width;
    return std::span(track.values).subspan(first, track.width);
}

/// Shoemake 1985, "Animating Rotation with Quaternion Curves", the shorter way around.
void slerp(std::span<const float> from, std::span<const float> to, float t, std::span<float> out) {
    float cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += from[i] * to[i];
    const float sign = cosine < 0 ? -1.0F : 1.0F;
    const float angle = std::acos(std::min(std::abs(cosine), 1.0F));
    const float sine = std::sin(angle);
    const bool close = sine < 1e-4F;  // The straight line is as good there, and no division by 0.
    const float a = close ? 1 - t : std::sin((1 - t) * angle) / sine;
    const float b = sign * (close ? t : std::sin(t * angle) / sine);
    for (std::size_t i = 0; i < 4; ++i) out[i] = a * from[i] + b * to[i];
}

/// Hermite's cubic between key k and the next.
void cubic(const KeyframeTrack& track, std::size_t k, float step_s, float t, std::span<float> out) {
    const float t2 = t * t;
    const float t3 = t2 * t;
    const std::size_t width = track.width;
    for (std::size_t i = 0; i < width; ++i) {
        const float value = track.values[(3 * k + 1) * width + i];
        const float leaving = track.values[(3 * k + 2) * width + i];
        const float arriving = track.values[(3 * k + 3) * width + i];
        const float next = track.values[(3 * k + 4) * width + i];
        out[i] = (2 * t3 - 3 * t2 + 1) * value + step_s * (t3 - 2 * t2 + t) * leaving + (-2 * t3 + 3 * t2) * next +
                 step_s * (t3 - t2) * arriving;
    }
}

Quaternion normalized(std::span<const float> q) {
    const float len = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(len > 0) || !std::isfinite(len)) return {};
    return {q[0] / len, q[1] / len, q[2] / len, q[3] / len};
}

Affine3 local_at(const AnimatedNode& node, float time_s) {
    Vec3 t = node.translation;
    Quaternion r = node.rotation;
    Vec3 s = node.scale;
    if (node.translations) {
        const std::vector<float> v = value_at(*node.translations, time_s, false);
        t = {v[0], v[1], v[2]};
    }
    if (node.rotations) r = normalized(value_at(*node.rotations, time_s, true));
    if (node.scales) {
        const std::vector<float> v = value_at(*node.scales, time_s, false);
        s = {v[0], v[1], v[2]};
    }
    return translation(t) * rotation_of(r) * scaling(s) * node.matrix;
}

}  // namespace

Affine3 rotation_of(const Quaternion& q) {
    return {{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)},
            {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)},
            {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)},
            {0, 0, 0}};
}

std::vector<float> value_at(const KeyframeTrack& track, float time_s, bool is_rotation) {
    const auto after = std::upper_bound(track.times_s.begin(), track.times_s.end(), time_s);
    std::vector<float> out(track.width);
    const auto copy_key = [&](std::size_t key) {
        const std::span<const float> value = key_value(track, key);
        std::copy(value.begin(), value.end(), out.begin());
    };
    if (after == track.times_s.begin()) {
        copy_key(0);
        return out;
    }
    const auto k = static_cast<std::size_t>(after - track.times_s.begin()) - 1;
    if (after == track.times_s.end() || track.interpolation == KeyframeTrack::Interpolation::step) {
        copy_key(k);
        return out;
    }
    const float step_s = track.times_s[k + 1] - track.times_s[k];
    const float t = (time_s - track.times_s[k]) / step_s;
    if (track.interpolation == KeyframeTrack::Interpolation::cubic) {
        cubic(track, k, step_s, t, out);
    } else if (is_rotation) {
        slerp(key_value(track, k), key_value(track, k + 1), t, out);
    } else {
        const std::span<const float> from = key_value(track, k);
        const std::span<const float> to = key_value(track, k + 1);
        for (std::size_t i = 0; i < track.width; ++i) out[i] = from[i] + (to[i] - from[i]) * t;
    }
    return out;
}

float moment_of(const NodeTree& tree, float time_s) {
    const float duration_s = tree.duration_s;
    if (!(duration_s > 0) || (time_s >= 0 && time_s <= duration_s)) return time_s;
    return time_s - duration_s * std::floor(time_s / duration_s);
}

Affine3 transform_at(const NodeTree& tree, Index node, float time_s) {
    const float moment = moment_of(tree, time_s);
    Affine3 placed;
    for (Index at = node; at != kNone; at = tree.nodes[at].parent) placed = local_at(tree.nodes[at], moment) * placed;
    return tree.world_from_tree * placed;
}

Affine3 transform_at(const NodeMotion& motion, float time_s) {
    constexpr float kSmallest = 1e-6F;
    Affine3 placed = transform_at(*motion.tree, motion.node, time_s) * motion.node_from_object;
    const float volume = std::abs(determinant(placed));
    if (volume > kSmallest * kSmallest * kSmallest && std::isfinite(volume)) return placed;
    return translation(is_finite(placed.t) ? placed.t : Vec3{}) * scaling({kSmallest, kSmallest, kSmallest});
}

}  // namespace sundog::scene
