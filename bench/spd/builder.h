// SPDX-License-Identifier: Apache-2.0
// What the generators have in common.
#pragma once

#include <string>

#include "scene/scene.h"

namespace sundog::bench {

/// A scene under construction: matt (or, with `mirror`, reflecting) objects, an eye and lights.
class SceneBuilder {
public:
    explicit SceneBuilder(const char* name) { scene_.name = name; }

    /// The eye at `from` looks at `at`; the picture's height spans 45 degrees, as in all of the databases.
    SceneBuilder& eye(Vec3 from, Vec3 at, Vec3 up = {0, 0, 1});
    SceneBuilder& light(Vec3 place, float strength);
    /// Its index. `mirror`: how much it reflects; `glass`: it refracts.
    std::uint32_t material(Vec3 color, float mirror = 0, bool glass = false);

    /// Each object gets a name of its own.
    void sphere(Vec3 center, float radius, std::uint32_t material);
    /// The side of a cone's frustum.
    void cone(Vec3 base, float base_radius, Vec3 cap, float cap_radius, std::uint32_t material);
    void mesh(scene::Mesh mesh);
    /// A square at height z around the origin.
    void ground(float half_side, float z, std::uint32_t material);

    scene::Scene take() { return std::move(scene_); }

private:
    scene::Object& object();
    scene::Scene scene_;
};

/// Appends a triangle with corners of its own.
void add_triangle(scene::Mesh& mesh, Vec3 a, Vec3 b, Vec3 c, std::uint32_t material);

/// A unit vector at right angles to a unit vector.
Vec3 perpendicular_to(Vec3 axis);

/// Evenly spread numbers from 0 to 1, the same on every machine (xorshift, Marsaglia 2003).
class SteadyRandom {
public:
    float next() {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 17U;
        state_ ^= state_ << 5U;
        return static_cast<float>(state_ >> 8U) * (1.0F / 16777216.0F);
    }

private:
    std::uint32_t state_ = 2463534242U;
};

}  // namespace sundog::bench
