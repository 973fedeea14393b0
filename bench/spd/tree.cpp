// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "spd/builder.h"
#include "spd/spd.h"

namespace sundog::bench {
namespace {

constexpr int kLevels = 11;
// Branching in Aono and Kunii's manner ("Botanical Tree Image Generation", IEEE Computer Graphics and Applications
// 1984): each branch ends in two, bent to either side, shorter and thinner, and turned about the branch.
constexpr float kBend1 = 40, kBend2 = 25, kTurn = 140, kShorter = 0.65F, kThinner = 0.67F;

struct Branch {
    Vec3 from, along, side;  ///< Unit vectors.
    float length, radius;
};

void add_branch(SceneBuilder& scene, const Branch& b, int levels, std::uint32_t material) {
    const Vec3 end = b.from + b.along * b.length;
    scene.cone(b.from, b.radius, end, b.radius * kThinner, material);
    scene.sphere(end, b.radius * kThinner, material);
    if (levels == 0) return;
    const auto bent = [&](float angle_deg) {
        const Vec3 hinge = cross(b.along, b.side);
        const Affine3 bend = rotation(hinge, angle_deg);
        const Vec3 along = normalize(transform_vector(bend, b.along));
        const Vec3 side = normalize(transform_vector(rotation(along, kTurn), transform_vector(bend, b.side)));
        return Branch{end, along, side, b.length * kShorter, b.radius * kThinner};
    };
    add_branch(scene, bent(kBend1), levels - 1, material);
    add_branch(scene, bent(-kBend2), levels - 1, material);
}

}  // namespace

scene::Scene spd_tree() {
    SceneBuilder scene("tree");
    scene.eye({4.5F, 0.4F, 2}, {0, 0, 1.5F});
    for (const Vec3 place : {Vec3{-5, 5, 50}, Vec3{30, -30, 30}, Vec3{-40, -30, 20}, Vec3{10, 30, 40},
                             Vec3{-30, 40, 10}, Vec3{50, 25, 20}, Vec3{-10, -60, 30}})
        scene.light(place, 0.38F);
    const std::uint32_t grass = scene.material({0.2F, 0.7F, 0.2F});
    const std::uint32_t bark = scene.material({0.55F, 0.4F, 0.2F});
    scene.ground(50, 0, grass);
    add_branch(scene, {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1, 0.15F}, kLevels, bark);
    return scene.take();
}

}  // namespace sundog::bench
