// SPDX-License-Identifier: Apache-2.0
// Sets up a World, a call a thing.
#pragma once

#include "stage/world.h"

namespace sundog::intro {

/// A solid's own space: its origin and its axes, orthonormal, in the world.
struct Pose {
    vec3 origin{0, 0, 0};
    vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

/// Turned by angles in radians around the world's z, then x, then z again.
Pose turned(vec3 origin, float first_z, float then_x, float then_z);

class Builder {
public:
    explicit Builder(World& world) : world_(world) {}

    /// All return the new thing's number.
    uint material(const Material& m);
    /// Metal of a colour that mirrors.
    uint metal(vec3 color);
    /// Polished stone or wood.
    uint polished(const Texture& t);
    /// Something that shines by itself.
    uint glowing(vec3 light);
    uint texture(const Texture& t);

    /// Its texture lies in the space of `pose`.
    void plane(vec3 unit_normal, float offset, uint material, const Pose& pose = {});
    void sphere(vec3 middle, float radius, uint material);
    void torus(const Pose& pose, float ring, float tube, uint material);
    /// A box that stands straight.
    void box(vec3 middle, vec3 half, uint material);
    /// From z0 to z1, upright.
    void cylinder(vec3 foot, float height, float radius, uint material);

    /// Begins a solid of parts in its own space, which the calls below add; the sphere around `middle` (in its own
    /// space) must hold it.
    Builder& carve(const Pose& pose, vec3 middle, float radius, uint material);
    Builder& ball(vec3 middle, float radius);
    Builder& block(vec3 middle, vec3 half);
    Builder& tube(uint axis, vec3 middle, float radius);
    Builder& half_space(vec3 unit_normal, float offset);
    /// From here on parts are cut away.
    Builder& without();
    /// The last solid casts no shadow.
    void shadowless() { world_.solids[world_.solid_count - 1].casts_shadow = false; }

    Lamp& lamp(vec3 place, vec3 color, float reach, float glow);
    /// A lamp in a small ball that is seen.
    void lantern(vec3 place, float radius, vec3 color, float bright, float reach, float glow);
    Lamp& sun(vec3 direction, vec3 color);
    Lamp& spot(vec3 place, vec3 at, vec3 color, float half_angle, float softness);

    /// `lens` is the distance of a window two units wide.
    void camera(vec3 eye, vec3 at, float lens, float aspect, float roll);

private:
    Solid& solid(SolidKind kind, const Pose& pose, uint material);
    Builder& part(const Part& p);

    World& world_;
    bool cutting_ = false;
};

}  // namespace sundog::intro
