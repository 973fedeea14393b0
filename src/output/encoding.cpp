// SPDX-License-Identifier: Apache-2.0
#include "output/encoding.h"

#include <cmath>

#include "output/srgb.h"

namespace sundog::output {
namespace {

/// The order of the comparisons sends NaN to 0.
double clamped(double value) { return value > 0 ? (value < 1 ? value : 1) : 0; }

double encoded(double linear, const std::optional<double>& gamma) {
    return gamma ? std::pow(linear, 1 / *gamma) : srgb_from_linear(linear);
}

}  // namespace

int channels_of(const Image& image, const Encoding& encoding) {
    return (encoding.grayscale ? 1 : 3) + (image.alpha.empty() ? 0 : 1);
}

std::vector<std::uint16_t> codes_of(const Image& image, const Encoding& encoding, int bits) {
    const double largest = (1 << bits) - 1;
    const auto code = [&](double value) { return static_cast<std::uint16_t>(std::floor(value * largest + 0.5)); };
    const auto color = [&](double linear) { return code(encoded(clamped(linear), encoding.gamma)); };
    std::vector<std::uint16_t> codes;
    codes.reserve(image.pixels.size() * static_cast<std::size_t>(channels_of(image, encoding)));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Vec3 pixel = image.pixels[i];
        if (encoding.grayscale) {
            codes.push_back(color(0.2126 * clamped(pixel.x) + 0.7152 * clamped(pixel.y) + 0.0722 * clamped(pixel.z)));
        } else {
            for (const float channel : {pixel.x, pixel.y, pixel.z}) codes.push_back(color(channel));
        }
        if (!image.alpha.empty()) codes.push_back(code(clamped(image.alpha[i])));
    }
    return codes;
}

std::vector<std::uint8_t> codes8_of(const Image& image, const Encoding& encoding) {
    // The usual case has a fast way of its own.
    if (!encoding.gamma && !encoding.grayscale && image.alpha.empty()) return to_srgb8(image);
    const std::vector<std::uint16_t> codes = codes_of(image, encoding, 8);
    const auto channels = static_cast<std::size_t>(channels_of(image, encoding));
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels.size() * 4);
    for (std::size_t i = 0; i < codes.size(); i += channels) {
        for (std::size_t c = 0; c < 3; ++c)
            bytes.push_back(static_cast<std::uint8_t>(codes[i + (encoding.grayscale ? 0 : c)]));
        if (!image.alpha.empty()) bytes.push_back(static_cast<std::uint8_t>(codes[i + channels - 1]));
    }
    return bytes;
}

}  // namespace sundog::output
