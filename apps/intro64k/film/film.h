// SPDX-License-Identifier: Apache-2.0
// The film as a whole: which scene when, and the fades between them.
#pragma once

#include "stage/world.h"

namespace sundog::intro {

inline constexpr float kFilmSeconds = 100;
inline constexpr float kBeatsPerSecond = 2;

/// Sets `world` up for a moment of the film, from 0 to kFilmSeconds (others are taken to the nearest end). `aspect` is
/// the picture's width over its height.
void set_up(World& world, float seconds, float aspect);

}  // namespace sundog::intro
