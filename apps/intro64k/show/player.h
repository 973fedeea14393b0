// SPDX-License-Identifier: Apache-2.0
// The window and the sound.
#pragma once

#include "show/options.h"
#include "show/renderer.h"

namespace sundog::intro {

/// Plays the film to its end or to the Escape key; returns the exit status: 0, or 1 if there is no screen.
int play(Renderer& renderer, const Quality& quality, const Options& options);

}  // namespace sundog::intro
