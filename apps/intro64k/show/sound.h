// SPDX-License-Identifier: Apache-2.0
// Sends the soundtrack to the loudspeakers.
#pragma once

#include <SDL.h>

#include "sound/synth.h"
#include "stage/block.h"

namespace sundog::intro {

/// Plays from the film's start while it exists; silent where there is no audio device.
class Sound {
public:
    explicit Sound(bool wanted);
    ~Sound();
    Sound(const Sound&) = delete;
    Sound& operator=(const Sound&) = delete;

private:
    Block<Synth> synth_;
    SDL_AudioDeviceID device_ = 0;
};

}  // namespace sundog::intro
