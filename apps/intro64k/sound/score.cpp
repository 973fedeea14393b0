// SPDX-License-Identifier: Apache-2.0
#include "sound/score.h"

namespace sundog::intro {
namespace {

enum : std::uint8_t { D, B, G, A, C, F, E };  // Dm9, Bb maj7, Gm7, Am7, C add 9, F maj7, A with its major third

constexpr Chord kChords[] = {
    {38, {53, 57, 60, 64}}, {34, {53, 57, 58, 62}}, {31, {53, 55, 58, 62}}, {33, {52, 55, 57, 60}},
    {36, {52, 55, 60, 62}}, {41, {52, 57, 60, 65}}, {33, {52, 57, 61, 64}},
};

constexpr std::uint8_t kProgression[kBars] = {
    D, D, B, B, G, G, E, E,        // a morning at sea
    D, B, F, C, D, B, G, E,        // rings
    B, C, D, D, B, C, A, D,        // columns
    D, F, C, G, D, F, C, E,        // carvings
    B, F, C, D, B, F, G, E,        // mirrors
    B, C, D, D, B, C, A, D, D, D,  // evening
};

// Eighths; a is D5, and on along the minor scale to h, D6.
constexpr char kThemes[][65] = {
    "................e...........d.c.d...........c.d.e...............",
    "........................e...c...........f...e...d...c...e.......",
    "h..gf.e.d...e.g.e.........c.d.e.f..ed.c.d..cb.c.e...c.b.a.......",
    "........a...c.......d...b......................c.d.e.g.f.e.d.b..",
    "h.f.h.g.e.c.e.f.g.e.d.e.c...a.b.c.d.f.e.e.g.h.g.f.d.f.h.e.......",
};
constexpr std::uint8_t kScale[] = {74, 76, 77, 79, 81, 82, 84, 86};

constexpr std::uint8_t kWalk[kStepsPerBar] = {0, 1, 2, 3, 4, 3, 2, 1, 0, 2, 1, 3, 4, 2, 3, 5};

constexpr Arrangement kArrangements[] = {
    {8, 0, 0, 6, 0, 0, 0, 0, 0},
    {8, 4, 0, 6, 0, 0, 0, 0, 0},
    {5, 6, 6, 4, 4, 0x4949, 0x0101, 0x0000, 0x4444},
    {6, 5, 6, 7, 5, 0x0101, 0x0401, 0x1010, 0x4444},
    {4, 6, 8, 4, 8, 0x5b5b, 0x1111, 0x1010, 0x5555},
    {6, 7, 8, 7, 8, 0x6d6d, 0x1111, 0x9010, 0xdd5d},
    {8, 4, 3, 7, 0, 0x0001, 0, 0, 0},
    {8, 0, 2, 0, 0, 0x0001, 0, 0, 0},
};
// A digit for every two bars.
constexpr char kForm[] = "0011223333334444555566677";

unsigned scene_of(unsigned bar) { return bar / 8; }

}  // namespace

const Chord& chord_of(unsigned bar) { return kChords[kProgression[bar]]; }

const Arrangement& arrangement_of(unsigned bar) { return kArrangements[kForm[bar / 2] - '0']; }

unsigned bell_note(unsigned bar, unsigned eighth) {
    // The evening remembers the columns.
    const unsigned theme = scene_of(bar) == 5 ? 2 : scene_of(bar);
    if (bar >= 48) return 0;
    const char letter = kThemes[theme][bar % 8 * 8 + eighth];
    return letter == '.' ? 0 : kScale[letter - 'a'];
}

unsigned pluck_note(unsigned bar, unsigned step) {
    const unsigned walk = kWalk[step];
    return chord_of(bar).notes[walk % kVoicing] + 12U + walk / kVoicing * 12U;
}

}  // namespace sundog::intro
