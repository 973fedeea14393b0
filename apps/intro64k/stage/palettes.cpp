// SPDX-License-Identifier: Apache-2.0
#include "stage/palettes.h"

namespace sundog::intro {
namespace {

struct Stop {
    unsigned char palette, entry;
    unsigned char r, g, b;  ///< As screens show them.
};

// Each palette's from entry 0 to 255, in order.
constexpr Stop kStops[] = {
    {kClouds, 0, 0, 0, 0},
    {kClouds, 105, 0, 0, 0},
    {kClouds, 140, 70, 70, 70},
    {kClouds, 185, 190, 190, 190},
    {kClouds, 255, 245, 245, 245},
    {kWhiteMarble, 0, 236, 232, 226},
    {kWhiteMarble, 120, 226, 222, 214},
    {kWhiteMarble, 190, 198, 192, 184},
    {kWhiteMarble, 230, 150, 142, 138},
    {kWhiteMarble, 255, 92, 84, 86},
    {kBlackMarble, 0, 22, 22, 26},
    {kBlackMarble, 150, 30, 32, 38},
    {kBlackMarble, 215, 52, 54, 62},
    {kBlackMarble, 244, 128, 118, 100},
    {kBlackMarble, 255, 214, 186, 128},
    {kMarbleTiles, 0, 234, 226, 212},
    {kMarbleTiles, 80, 214, 200, 180},
    {kMarbleTiles, 127, 168, 148, 128},
    {kMarbleTiles, 128, 38, 30, 32},
    {kMarbleTiles, 215, 66, 44, 40},
    {kMarbleTiles, 255, 150, 112, 84},
    {kWood, 0, 170, 108, 56},
    {kWood, 110, 152, 92, 46},
    {kWood, 190, 122, 68, 32},
    {kWood, 240, 88, 46, 22},
    {kWood, 255, 70, 36, 18},
    {kJade, 0, 26, 74, 60},
    {kJade, 120, 58, 128, 96},
    {kJade, 210, 124, 182, 138},
    {kJade, 255, 210, 228, 190},
    {kSandstone, 0, 210, 168, 122},
    {kSandstone, 110, 196, 148, 104},
    {kSandstone, 200, 168, 118, 84},
    {kSandstone, 255, 132, 88, 66},
};

}  // namespace

void make_palettes(uint* entries) {
    const Stop* a = kStops;
    for (uint palette = 0; palette < kPaletteCount; ++palette) {
        for (uint i = 0; i < kPaletteSize; ++i) {
            while (a->palette < palette || a[1].entry < i) ++a;
            const Stop& b = a[1];
            const uint span = b.entry - a->entry;
            const uint along = i - a->entry;
            const auto mixed = [&](uint from, uint to) {
                return (from * (span - along) + to * along) * 1023 / (255 * span);
            };
            *entries++ = mixed(a->r, b.r) | mixed(a->g, b.g) << 10 | mixed(a->b, b.b) << 20;
        }
        a += 2;  // past the stops 254 to 255
    }
}

}  // namespace sundog::intro
