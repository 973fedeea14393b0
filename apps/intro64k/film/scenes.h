// SPDX-License-Identifier: Apache-2.0
// The film's scenes: each sets up a cleared world for a moment of its own time.
#pragma once

#include "stage/builder.h"

namespace sundog::intro {

/// A moment of a scene.
struct Moment {
    float seconds;  ///< Since the scene began.
    float beats;    ///< Of the soundtrack, likewise.
    float aspect;   ///< The picture's width over its height.
};

void sea(World& world, const Moment& now);        ///< A morning at sea, with two sun dogs and the title.
void colonnade(World& world, const Moment& now);  ///< Marble columns, and lamps that wander among them.
void rings(World& world, const Moment& now);      ///< Rings in rings around a light, on wood.
void mirrors(World& world, const Moment& now);    ///< Balls between mirrors that face each other.
void carvings(World& world, const Moment& now);   ///< What is left of boxes and balls when others are cut away.
void evening(World& world, const Moment& now);    ///< The sea again, at dusk, and the end.

/// The letters SUNDOG standing upright in the plane y = place.y, their middle at `place`, `size` high. `risen` from 0
/// to 1 lifts them out of the depth, one after the other.
void title(Builder& builder, vec3 place, float size, uint material, float risen, float sway);

/// Sea, sky and clouds that both scenes at sea share. Adds the water.
void open_sea(Builder& builder, World& world, const Moment& now);

/// The part of a sun dog's sky that follows from the sun's place: its dogs 22 degrees to either side, as high as it.
void place_sun(Sky& sky, float azimuth, float elevation);

}  // namespace sundog::intro
