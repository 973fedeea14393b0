// SPDX-License-Identifier: Apache-2.0
// A small software synthesiser: a pad, a plucked string, a bass, a bell, drums, an echo and a room.
#pragma once

#include "sound/score.h"

namespace sundog::intro {

inline constexpr unsigned kSampleRate = 44100;

/// Something that is struck and dies away.
struct Voice {
    float phase, step;  ///< In turns, and turns a sample.
    float level, decay;
    float side;  ///< -1 left to 1 right.
};

/// A filter with one state for each of two integrators (Chamberlin, Musical Applications of Microprocessors, 1985,
/// chapter 14).
struct Filter {
    float low, band;
};

inline constexpr unsigned kPlucks = 6, kBells = 4, kCombs = 4, kCombLength = 2048, kEchoLength = 1U << 15;

/// All of the synthesiser's state; zeros are its start.
struct Synth {
    unsigned long long sample;
    Voice plucks[kPlucks], bells[kBells];
    Voice bass, kick, snare, hat;
    unsigned next_pluck, next_bell;
    float pad_phase[kVoicing * 2];
    float pad_level;
    Filter pad_filter[2], bass_filter, noise_filter;
    unsigned noise;
    float echo[2][kEchoLength];
    float comb[2][kCombs][kCombLength];
    float damped[2][kCombs];
    float duck;  ///< How far the kick pushes all else down.
};

/// The next `count` pairs of samples, left and right, -1 to 1.
void play(Synth& synth, float* out, unsigned count);

}  // namespace sundog::intro
