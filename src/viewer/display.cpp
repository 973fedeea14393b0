// SPDX-License-Identifier: Apache-2.0
#include "viewer/display.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

namespace sundog::viewer {
namespace {

// A float's exponent and the top of its mantissa index a table of codes. 2^-13 and below encode to 0 (the first code
// starts at 0.00015), 1 and above to 255; between lie 13 octaves of 1024 steps each.
constexpr std::uint32_t kMantissaBits = 10;
constexpr std::uint32_t kShift = 23 - kMantissaBits;
constexpr float kLowest = 1.0F / 8192;
constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kLowest) >> kShift;
constexpr std::uint32_t kLast = std::bit_cast<std::uint32_t>(1.0F) >> kShift;

float srgb_encoded(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

using CodeTable = std::array<std::uint8_t, kLast - kFirst + 1>;

CodeTable make_code_table() {
    CodeTable table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        const std::uint32_t middle = (1U << kShift) / 2;
        const float linear = std::min(std::bit_cast<float>(((kFirst + i) << kShift) + middle), 1.0F);
        table[i] = static_cast<std::uint8_t>(std::lround(255 * srgb_encoded(linear)));
    }
    return table;
}

// Work in blocks that stay in the first cache: plain arithmetic first, which the compiler makes vectors of, look-ups
// after it.
constexpr std::size_t kBlock = 128;

void convert_block(const std::array<float, 4>* sums, std::size_t count, float gain, const CodeTable& codes,
                   std::uint32_t* argb) {
    std::array<std::array<std::uint32_t, 4>, kBlock> index;
    for (std::size_t i = 0; i < count; ++i) {
        const float scale = gain / std::max(sums[i][3], 1.0F);
        for (std::size_t c = 0; c < 4; ++c) {
            float value = sums[i][c] * scale;
            value = value > kLowest ? value : kLowest;  // in this order, NaN becomes the lowest
            value = value < 1.0F ? value : 1.0F;
            index[i][c] = (std::bit_cast<std::uint32_t>(value) >> kShift) - kFirst;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        argb[i] = 0xff000000U | static_cast<std::uint32_t>(codes[index[i][0]]) << 16 |
                  static_cast<std::uint32_t>(codes[index[i][1]]) << 8 | codes[index[i][2]];
    }
}

}  // namespace

void to_display(const Film& film, float exposure_ev, std::span<std::uint32_t> argb) {
    static const CodeTable codes = make_code_table();
    const float gain = std::exp2(exposure_ev);
    const std::size_t pixels = std::min(film.radiance.size(), argb.size());
    const std::size_t blocks = (pixels + kBlock - 1) / kBlock;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 64), [&](const auto& range) {
        for (std::size_t b = range.begin(); b != range.end(); ++b) {
            const std::size_t first = b * kBlock;
            convert_block(film.radiance.data() + first, std::min(kBlock, pixels - first), gain, codes,
                          argb.data() + first);
        }
    });
}

output::Image to_image(const Film& film, float exposure_ev) {
    const float gain = std::exp2(exposure_ev);
    output::Image image(film.bounds.width(), film.bounds.height());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.at(x, y) = film.mean(film.bounds.x0 + x, film.bounds.y0 + y) * gain;
    return image;
}

}  // namespace sundog::viewer
