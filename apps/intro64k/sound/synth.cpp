// SPDX-License-Identifier: Apache-2.0
#include "sound/synth.h"

#include <cmath>

#include "kernel/math.h"

namespace sundog::intro {
namespace {

constexpr float kRate = static_cast<float>(kSampleRate);
constexpr unsigned kBarSamples = kSampleRate * 2;

/// Of a note, in turns a sample.
float frequency(unsigned note) { return 440 / kRate * std::exp2((static_cast<float>(note) - 69) * (1.0F / 12)); }

/// A decay by which a level halves in `seconds`.
float halving(float seconds) { return std::exp2(-1 / (seconds * kRate)); }

float wave(float turns) { return kernel::sine(turns * 6.2831853F); }

/// Steps a phase on and wraps it.
float advance(float& phase, float step) {
    phase += step;
    if (phase >= 1) phase -= 1;
    return phase;
}

/// A saw without most of its aliasing: its step is rounded off (Välimäki and Huovilainen 2007, polynomial steps).
float saw(float phase, float step) {
    float x = 2 * phase - 1;
    if (phase < step) {
        const float t = phase / step;
        x -= t + t - t * t - 1;
    } else if (phase > 1 - step) {
        const float t = (phase - 1) / step;
        x -= t * t + t + t + 1;
    }
    return x;
}

/// Low-passed; `cutoff` in radians a sample, under about 1.
float low_pass(Filter& f, float in, float cutoff, float damping) {
    f.low += cutoff * f.band;
    f.band += cutoff * (in - f.low - damping * f.band);
    return f.low;
}

float noise(Synth& s) {
    s.noise = s.noise * 1664525U + 1013904223U;
    return static_cast<float>(static_cast<int>(s.noise)) * (1.0F / 2147483648.0F);
}

void strike(Voice& v, unsigned note, float level, float half_seconds, float side) {
    v = {0, frequency(note), level, halving(half_seconds), side};
}

bool has(std::uint16_t steps, unsigned step) { return (steps >> step & 1) != 0; }

void begin_step(Synth& s, unsigned bar, unsigned step) {
    const Arrangement& a = arrangement_of(bar);
    if (a.pluck != 0) {
        const float accent = step % 4 == 0 ? 1.0F : 0.7F;
        const float side = step % 2 == 0 ? -0.5F : 0.5F;
        strike(s.plucks[s.next_pluck++ % kPlucks], pluck_note(bar, step), accent * 0.016F * a.pluck, 0.09F, side);
    }
    if (step % 2 == 0 && a.bell != 0) {
        const unsigned note = bell_note(bar, step / 2);
        if (note != 0) strike(s.bells[s.next_bell++ % kBells], note, 0.022F * a.bell, 0.55F, 0.2F);
    }
    if (has(a.bass_steps, step))
        strike(s.bass, chord_of(bar).root + (step % 4 == 3 ? 12U : 0U), 0.034F * a.bass, a.drums == 0 ? 0.9F : 0.14F,
               0);
    const float drums = 0.05F * a.drums;
    if (has(a.kick_steps, step)) strike(s.kick, 33, drums * 1.5F, 0.07F, 0);
    if (has(a.snare_steps, step)) strike(s.snare, 55, drums * 0.75F, 0.05F, 0.1F);
    if (has(a.hat_steps, step)) strike(s.hat, 60, drums * 0.3F, step % 4 == 2 ? 0.03F : 0.012F, -0.3F);
}

struct Stereo {
    float left, right;
    void add(float x, float side) {
        left += x * (1 - side);
        right += x * (1 + side);
    }
};

Stereo pad(Synth& s, unsigned bar, float bar_part) {
    const Chord& chord = chord_of(bar);
    const float wanted = static_cast<float>(arrangement_of(bar).pad) * 0.011F;
    s.pad_level += (wanted - s.pad_level) * 0.00002F;
    float sides[2] = {0, 0};
    for (unsigned i = 0; i < kVoicing * 2; ++i) {
        const float step = frequency(chord.notes[i / 2]) * (i % 2 == 0 ? 0.997F : 1.003F);
        sides[i % 2] += saw(advance(s.pad_phase[i], step), step);
    }
    // The filter breathes, once in four bars.
    const float breath = 0.5F - 0.5F * wave((static_cast<float>(bar % 4) + bar_part) * 0.25F + 0.25F);
    const float cutoff = 0.045F + 0.12F * breath;
    return {low_pass(s.pad_filter[0], sides[0], cutoff, 1.1F) * s.pad_level,
            low_pass(s.pad_filter[1], sides[1], cutoff, 1.1F) * s.pad_level};
}

float drums(Synth& s) {
    float sum = 0;
    if (s.kick.level > 1e-5F) {
        // A sine that falls fast.
        const float sweep = s.kick.level * 60;
        advance(s.kick.phase, s.kick.step * (1 + (sweep > 6 ? 6 : sweep)));
        sum += wave(s.kick.phase) * s.kick.level;
        s.kick.level *= s.kick.decay;
    }
    s.duck = s.kick.level;
    const float hiss = noise(s);
    if (s.snare.level > 1e-5F) {
        sum += (wave(advance(s.snare.phase, s.snare.step)) * 0.5F + hiss * 0.7F) * s.snare.level;
        s.snare.level *= s.snare.decay;
    }
    if (s.hat.level > 1e-5F) {
        // What is left without the low part.
        sum += (hiss - low_pass(s.noise_filter, hiss, 0.9F, 1.2F)) * s.hat.level;
        s.hat.level *= s.hat.decay;
    }
    return sum;
}

void strings(Synth& s, Stereo& dry, Stereo& wet) {
    for (Voice& v : s.plucks) {
        if (v.level < 1e-5F) continue;
        const float p = advance(v.phase, v.step);
        // Brighter while it is loud.
        const float x = (wave(p) + wave(p * 2) * v.level * 5 + wave(p * 3) * v.level * 3) * v.level;
        dry.add(x, v.side);
        wet.add(x * 0.6F, -v.side);
        v.level *= v.decay;
    }
    for (Voice& v : s.bells) {
        if (v.level < 1e-5F) continue;
        const float p = advance(v.phase, v.step);
        // Frequency modulation (Chowning 1973) at 3.5 times the tone.
        const float x = wave(p + 0.9F * v.level * wave(p * 3.5F)) * v.level;
        dry.add(x, v.side);
        wet.add(x * 0.9F, 0);
        v.level *= v.decay;
    }
    if (s.bass.level > 1e-5F) {
        const float x = saw(advance(s.bass.phase, s.bass.step), s.bass.step) + 0.6F * wave(s.bass.phase);
        const float y = low_pass(s.bass_filter, x, 0.03F + 0.5F * s.bass.level, 0.6F);
        dry.add(y * s.bass.level, 0);
        s.bass.level *= s.bass.decay;
    }
}

/// Echoes of three sixteenths from side to side, then a room of combs (Schroeder 1962; lengths share no factor).
Stereo echo_and_room(Synth& s, Stereo in) {
    constexpr unsigned kLengths[2][kCombs] = {{1559, 1621, 1493, 1423}, {1583, 1637, 1511, 1447}};
    constexpr unsigned kDelay = kBarSamples / kStepsPerBar * 3;
    const unsigned at = static_cast<unsigned>(s.sample);
    const unsigned now = at % kEchoLength;
    const unsigned before = (at - kDelay) % kEchoLength;
    const float left = s.echo[0][before];
    const float right = s.echo[1][before];
    s.echo[0][now] = in.left + right * 0.45F;
    s.echo[1][now] = in.right + left * 0.45F;
    const float fed[2] = {in.left + left * 0.6F, in.right + right * 0.6F};
    float room[2] = {0, 0};
    for (unsigned side = 0; side < 2; ++side)
        for (unsigned i = 0; i < kCombs; ++i) {
            float& cell = s.comb[side][i][at % kLengths[side][i]];
            float& damped = s.damped[side][i];
            damped += (cell - damped) * 0.55F;
            room[side] += cell;
            cell = fed[side] * 0.25F + damped * 0.84F;
        }
    return {left * 0.7F + room[0] * 0.45F, right * 0.7F + room[1] * 0.45F};
}

/// Bends what is too loud instead of cutting it off.
float soft(float x) {
    x = kernel::clamp(x, -1.5F, 1.5F);
    return x - x * x * x * (4.0F / 27);
}

}  // namespace

void play(Synth& synth, float* out, unsigned count) {
    constexpr unsigned kStep = kBarSamples / kStepsPerBar;
    for (unsigned i = 0; i < count; ++i, ++synth.sample) {
        const unsigned at = static_cast<unsigned>(synth.sample);
        const unsigned bar = at / kBarSamples;
        Stereo sum{0, 0};
        if (bar < kBars) {
            // A bar's samples are not a multiple of its steps: the last step is a little longer.
            const unsigned in_bar = at % kBarSamples;
            if (in_bar % kStep == 0 && in_bar / kStep < kStepsPerBar) begin_step(synth, bar, in_bar / kStep);
            Stereo wet = pad(synth, bar, static_cast<float>(in_bar) / kBarSamples);
            Stereo dry = wet;
            wet.left *= 0.5F;
            wet.right *= 0.5F;
            const float beat = drums(synth);
            strings(synth, dry, wet);
            const float push = 1 - synth.duck * 0.9F;
            const Stereo space = echo_and_room(synth, wet);
            sum = {(dry.left + space.left) * push + beat, (dry.right + space.right) * push + beat};
            const float left_of_film = static_cast<float>(kBars * kBarSamples - at) / kRate;
            const float fade = kernel::min(left_of_film * 0.25F, 1.0F);
            sum.left *= fade;
            sum.right *= fade;
        }
        *out++ = soft(sum.left);
        *out++ = soft(sum.right);
    }
}

}  // namespace sundog::intro
