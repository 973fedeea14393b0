// SPDX-License-Identifier: Apache-2.0
// From radiance, which has no upper end, to what a screen can show: white balance, then a tone curve.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "output/image.h"

namespace sundog::output {

/// How much light becomes how much of the screen's. All keep black black and gray gray, and none shows more light of a
/// colour darker; agx within 0.001.
enum class ToneCurve : std::uint8_t {
    linear,    ///< As it is; above 1 it is cut off.
    reinhard,  ///< Luminance, so that ToneMapping::white_point becomes white (Reinhard and others 2002, equation 4).
    aces,      ///< A fit to the academy's reference and output transforms (Stephen Hill's; Pettineo, BakingLab, 2016).
    agx,       ///< Troy Sobotka's AgX, by the polynomial of Wrensch, "Minimal AgX Implementation", 2023.
    gamma,     ///< A picture's numbers are light to the power 1/2.2, instead of sRGB's curve.
};
inline constexpr std::array<std::string_view, 5> kToneCurveNames{"linear", "reinhard", "aces", "agx", "gamma"};

/// Errors: std::out_of_range for another name.
ToneCurve tone_curve_named(std::string_view name);

/// What becomes of a picture before its numbers are encoded.
struct ToneMapping {
    ToneCurve curve = ToneCurve::linear;
    float white_point = 4;                   ///< Luminance, over 0, that `reinhard` makes white.
    std::optional<float> white_balance_k{};  ///< Colour temperature of the light that is to look white.
    friend bool operator==(const ToneMapping&, const ToneMapping&) = default;
};

/// A mapping made ready for many pixels.
class ToneMapper {
public:
    explicit ToneMapper(const ToneMapping& mapping);
    /// True where every colour stays as it is.
    [[nodiscard]] bool changes_nothing() const { return curve_ == ToneCurve::linear && !balances_; }
    /// Linear RGB, ready to be encoded by sRGB's curve. All but ToneCurve::linear give 0 to 1, and 0 for NaN.
    [[nodiscard]] Vec3 operator()(Vec3 linear) const;

private:
    ToneCurve curve_;
    float white_point_;
    bool balances_;
    std::array<Vec3, 3> balance_;
};

/// A picture for 8 and 16 bits; those of more stay without.
Image tone_mapped(Image image, const ToneMapping& mapping);

/// True for the formats that hold radiance itself, which isn't to be mapped.
constexpr bool holds_radiance(Format format) { return format == Format::exr || format == Format::hdr; }

}  // namespace sundog::output
