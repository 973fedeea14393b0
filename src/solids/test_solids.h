// SPDX-License-Identifier: Apache-2.0
// What the tests of shapes and of their combinations share: solids by a word, and properties that all of them have.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "solids/compiled_solid.h"

namespace sundog::solids::tests {

using SolidPointer = std::shared_ptr<const scene::Solid>;

template <class T>
scene::Solid solid_of(T shape, std::uint32_t material = scene::Solid::kInherited) {
    scene::Solid solid;
    solid.shape = std::move(shape);
    solid.material = material;
    return solid;
}
template <class T>
SolidPointer pointer_to(T shape, std::uint32_t material = scene::Solid::kInherited) {
    return std::make_shared<scene::Solid>(solid_of(std::move(shape), material));
}
SolidPointer inverted(const SolidPointer& solid);
SolidPointer moved(const SolidPointer& solid, const Affine3d& by);
SolidPointer group(scene::SolidGroup::Kind kind, std::vector<SolidPointer> children);
SolidPointer united(std::vector<SolidPointer> children);
SolidPointer merged(std::vector<SolidPointer> children);
SolidPointer intersected(std::vector<SolidPointer> children);
/// The first without the others.
SolidPointer difference(std::vector<SolidPointer> children);

/// Rotation by `angle` radians about the unit axis, then a move.
Affine3d turned(Vec3d axis, double angle, Vec3d move = {});
Affine3d scaled(Vec3d factors);

class RandomRays {
public:
    explicit RandomRays(unsigned seed) : random_(seed) {}
    double number(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(random_); }
    Vec3d point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
    /// From somewhere in a cube of side 2*reach to somewhere in one of half that size; direction not of unit length.
    Ray ray(double reach) {
        const Vec3d from = point(reach);
        return {from, (point(0.5 * reach) - from) * number(0.1, 10)};
    }

private:
    std::mt19937 random_;
};

/// All visible surfaces along a ray, found by asking for the nearest again and again.
std::vector<Hit> all_hits(const CompiledSolid& solid, const Ray& ray, Range range = {});

struct Expectations {
    double reach = 2;  ///< Rays start within a cube of side 2*reach around the origin.
    int rays = 300;
    bool alternates = true;       ///< Every surface parts inside from outside (no inner surfaces, no mere surfaces).
    double surface_error = 1e-6;  ///< How far off the surface a hit may be, in units of length.
};

/// Checks along random rays that surfaces part inside from outside, that normals are unit and point outwards, that hits
/// are within the bounds, and that a hit's point lies on the surface (inside on one side, outside on the other).
void expect_solid_properties(const scene::Solid& solid, unsigned seed, const Expectations& expectations = {});

/// Checks that the shape's normal agrees with how inside() changes around the hit: the plane that the normal gives
/// parts inside from outside in most of a small neighbourhood.
void expect_normals_agree(const scene::Solid& solid, unsigned seed, double reach = 2, double step = 1e-4);

}  // namespace sundog::solids::tests
