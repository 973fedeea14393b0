// SPDX-License-Identifier: Apache-2.0
#include "output/srgb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace sundog::output {
namespace {

// A float in [2^-13, 1) is told apart by its exponent and the upper 7 bits of its mantissa: 13 * 128 bins, each
// narrower than the step between two codes, so that at most one code begins inside a bin.
constexpr int kLowBits = 16;
constexpr std::uint32_t kLowMask = (1U << kLowBits) - 1;
constexpr float kSmallest = 0x1p-13F;       // Its code is 0 (12.92 * 255 * 2^-13 < 0.5).
constexpr float kLargest = 0x1.fffffep-1F;  // Its code is 255.
constexpr std::uint32_t kFirstBin = std::bit_cast<std::uint32_t>(kSmallest) >> kLowBits;
constexpr std::uint32_t kBinCount = (std::bit_cast<std::uint32_t>(kLargest) >> kLowBits) - kFirstBin + 1;

int code_of(float linear) { return static_cast<int>(std::floor(srgb_from_linear(linear) * 255 + 0.5)); }

/// For each bin: (code at its start << 16) + (65536 - low bits of the first value with the next code, if it has one).
/// Adding a value's low bits carries into the code exactly when the value has reached the next code.
std::array<std::uint32_t, kBinCount> make_bins() {
    std::array<std::uint32_t, kBinCount> bins{};
    for (std::uint32_t bin = 0; bin < kBinCount; ++bin) {
        const std::uint32_t start = (kFirstBin + bin) << kLowBits;
        const auto code_at = [&](std::uint32_t low) { return code_of(std::bit_cast<float>(start + low)); };
        const int code = code_at(0);
        bins[bin] = static_cast<std::uint32_t>(code) << kLowBits;
        if (code_at(kLowMask) == code) continue;
        std::uint32_t below = 0, at_or_above = kLowMask;
        while (at_or_above - below > 1) {
            const std::uint32_t middle = (below + at_or_above) / 2;
            (code_at(middle) == code ? below : at_or_above) = middle;
        }
        bins[bin] += (1U << kLowBits) - at_or_above;
    }
    return bins;
}

}  // namespace

double srgb_from_linear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

void encode_srgb8(std::span<const Vec3> linear, std::span<std::uint8_t> codes) {
    if (codes.size() / 3 < linear.size()) throw std::invalid_argument("encode_srgb8: too few bytes for the codes");
    static const std::array<std::uint32_t, kBinCount> bins = make_bins();
    // In two loops, as the compiler makes branches of clamping and look-up together, and SIMD code of clamping alone.
    constexpr std::size_t kBlock = 256;
    std::array<float, 3 * kBlock> values{};
    std::array<std::uint32_t, 3 * kBlock> bits{};
    static_assert(sizeof(Vec3) == 3 * sizeof(float));
    std::uint8_t* out = codes.data();
    while (!linear.empty()) {
        const std::span<const Vec3> block = linear.first(std::min(kBlock, linear.size()));
        linear = linear.subspan(block.size());
        const std::size_t count = 3 * block.size();
        std::memcpy(values.data(), block.data(), block.size_bytes());
        for (std::size_t i = 0; i < count; ++i) {
            // The order of the comparisons sends NaN to kSmallest.
            const float at_least = values[i] > kSmallest ? values[i] : kSmallest;
            bits[i] = std::bit_cast<std::uint32_t>(at_least < kLargest ? at_least : kLargest);
        }
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t bin = bins[(bits[i] >> kLowBits) - kFirstBin];
            out[i] = static_cast<std::uint8_t>((bin + (bits[i] & kLowMask)) >> kLowBits);
        }
        out += count;
    }
}

}  // namespace sundog::output
