// SPDX-License-Identifier: Apache-2.0
#include "viewer/display.h"

#include <emmintrin.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

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

// SSE2, which every x86-64 processor has, takes the four places of a sum at once; compilers don't see that by
// themselves.
std::uint32_t argb_of(__m128 linear, const CodeTable& codes) {
    const __m128 above = _mm_max_ps(linear, _mm_set1_ps(kLowest));  // in this order, NaN becomes the lowest
    const __m128i bits = _mm_castps_si128(_mm_min_ps(above, _mm_set1_ps(1)));
    const __m128i index = _mm_sub_epi32(_mm_srli_epi32(bits, kShift), _mm_set1_epi32(kFirst));
    static_assert(std::tuple_size_v<CodeTable> <= 0x10000);  // so the lower halves of the lanes tell all
    return 0xff000000U | static_cast<std::uint32_t>(codes[_mm_extract_epi16(index, 0)]) << 16 |
           static_cast<std::uint32_t>(codes[_mm_extract_epi16(index, 2)]) << 8 | codes[_mm_extract_epi16(index, 4)];
}

/// With a mapping that changes colours.
void convert(std::span<const std::array<float, 4>> sums, float gain, const output::ToneMapper& map,
             const CodeTable& codes, std::uint32_t* argb) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const float scale = sums[i][3] > 0 ? gain / sums[i][3] : 0;
        const Vec3 shown = map({sums[i][0] * scale, sums[i][1] * scale, sums[i][2] * scale});
        argb[i] = argb_of(_mm_setr_ps(shown.x, shown.y, shown.z, 0), codes);
    }
}

void convert(std::span<const std::array<float, 4>> sums, float gain, const CodeTable& codes, std::uint32_t* argb) {
    // Neighbours mostly have the same number of samples, which saves a division each.
    float samples = 1;
    __m128 scale = _mm_set1_ps(gain);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (sums[i][3] != samples) {
            samples = sums[i][3];
            scale = _mm_set1_ps(samples > 0 ? gain / samples : 0);
        }
        argb[i] = argb_of(_mm_mul_ps(_mm_loadu_ps(sums[i].data()), scale), codes);
    }
}

}  // namespace

void to_display(const Film& film, const Exposure& exposure, std::span<std::uint32_t> argb) {
    static const CodeTable codes = make_code_table();
    const float gain = std::exp2(exposure.ev);
    const output::ToneMapper map(exposure.tone);
    const std::size_t pixels = std::min(film.radiance.size(), argb.size());
    const std::span sums(film.radiance.data(), pixels);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels, 16384), [&](const auto& range) {
        const auto some = sums.subspan(range.begin(), range.size());
        std::uint32_t* const out = argb.data() + range.begin();
        if (map.changes_nothing()) convert(some, gain, codes, out);
        else convert(some, gain, map, codes, out);
    });
}

void paint_traced(const Film& film, std::span<std::uint32_t> argb) {
    for (std::size_t i = 0; i < argb.size(); ++i)
        if (film.cost[i] > 0) argb[i] = 0xffffffffU;
}

output::Image to_image(const Film& film, const Exposure& exposure) {
    const float gain = std::exp2(exposure.ev);
    output::Image image(film.bounds.width(), film.bounds.height());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.at(x, y) = film.mean(film.bounds.x0 + x, film.bounds.y0 + y) * gain;
    return output::tone_mapped(std::move(image), exposure.tone);
}

}  // namespace sundog::viewer
