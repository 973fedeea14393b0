// SPDX-License-Identifier: Apache-2.0
// The soundtrack, composed for this film: fifty bars in D minor, eight a scene, 120 beats a minute.
#pragma once

#include <cstdint>

namespace sundog::intro {

inline constexpr unsigned kStepsPerBar = 16;
inline constexpr unsigned kBars = 50;
inline constexpr unsigned kVoicing = 4;

/// Notes are numbered as MIDI does: 69 is A4, 440 Hz.
struct Chord {
    std::uint8_t root;
    std::uint8_t notes[kVoicing];
};

/// How a scene is played: levels from 0 to 9, and patterns of a bar's sixteen steps, the first the lowest bit.
struct Arrangement {
    std::uint8_t pad, pluck, bass, bell, drums;
    std::uint16_t bass_steps, kick_steps, snare_steps, hat_steps;
};

const Chord& chord_of(unsigned bar);
const Arrangement& arrangement_of(unsigned bar);
/// What the bell plays at an eighth of a bar, 0 to 7; 0: nothing new.
unsigned bell_note(unsigned bar, unsigned eighth);
/// The plucked string's note at a step.
unsigned pluck_note(unsigned bar, unsigned step);

}  // namespace sundog::intro
