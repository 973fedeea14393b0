// SPDX-License-Identifier: Apache-2.0
#include "output/tone.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/srgb.h"
#include "output/white_balance.h"

namespace sundog::output {
namespace {

/// What all curves take for the brightest: squares of it are finite.
constexpr float kBrightest = 1e9F;

/// The order of the comparisons sends NaN to 0.
float clamped(float value, float most) { return value > 0 ? (value < most ? value : most) : 0; }
Vec3 clamped(Vec3 v, float most) { return {clamped(v.x, most), clamped(v.y, most), clamped(v.z, most)}; }

template <class Curve>
Vec3 each(Vec3 v, const Curve& curve) {
    return {curve(v.x), curve(v.y), curve(v.z)};
}

Vec3 times(const std::array<Vec3, 3>& rows, Vec3 v) { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }

Vec3 reinhard(Vec3 color, float white_point) {
    const float bright = luminance(color);
    if (!(bright > 0)) return {0, 0, 0};
    return color * ((1 + bright / (white_point * white_point)) / (1 + bright));
}

/// Hill's fit: to AP1 with the reference transform's desaturation, a rational curve, and back with the output's.
Vec3 aces(Vec3 color) {
    constexpr std::array<Vec3, 3> kIn{
        {{0.59719F, 0.35458F, 0.04823F}, {0.07600F, 0.90834F, 0.01566F}, {0.02840F, 0.13383F, 0.83777F}}};
    constexpr std::array<Vec3, 3> kOut{
        {{1.60475F, -0.53108F, -0.07367F}, {-0.10208F, 1.10813F, -0.00605F}, {-0.00327F, -0.07276F, 1.07602F}}};
    const auto curve = [](float v) {
        // The fit dips under 0 at the dark end; what it gives for black is black.
        const float shown = (v * (v + 0.0245786F) - 0.000090537F) / (v * (0.983729F * v + 0.4329510F) + 0.238081F);
        return std::max(shown, 0.0F);
    };
    return times(kOut, each(times(kIn, color), curve));
}

/// What AgX tells apart, in stops from 1.
constexpr float kLeastEv = -12.47393F, kMostEv = 4.026069F;

/// Colours are drawn together (inset), encoded by their logarithm, bent by a sigmoid, and drawn apart again (outset).
Vec3 agx(Vec3 color) {
    constexpr std::array<Vec3, 3> kInset{{{0.842479062253094F, 0.0784335999999992F, 0.0792237451477643F},
                                          {0.0423282422610123F, 0.878468636469772F, 0.0791661274605434F},
                                          {0.0423756549057051F, 0.0784336F, 0.879142973793104F}}};
    constexpr std::array<Vec3, 3> kOutset{{{1.19687900512017F, -0.0980208811401368F, -0.0990297440797205F},
                                           {-0.0528968517574562F, 1.15190312990417F, -0.0989611768448433F},
                                           {-0.0529716355144438F, -0.0980434501171241F, 1.15107367264116F}}};
    const auto sigmoid = [](float v) {
        const float ev = v > 0 ? std::log2(v) : kLeastEv;
        const float x = (std::clamp(ev, kLeastEv, kMostEv) - kLeastEv) / (kMostEv - kLeastEv);
        return (((((15.5F * x - 40.14F) * x + 31.96F) * x - 6.868F) * x + 0.4298F) * x + 0.1191F) * x - 0.00232F;
    };
    const Vec3 encoded = times(kOutset, each(times(kInset, color), sigmoid));
    // Its numbers are for a screen with a power of 2.2; ours are to be linear.
    return each(encoded, [](float v) { return v > 0 ? std::pow(v, 2.2F) : 0.0F; });
}

float power_law(float linear) { return linear_from_srgb(std::pow(clamped(linear, 1), 1 / 2.2F)); }

}  // namespace

ToneCurve tone_curve_named(std::string_view name) {
    for (std::size_t i = 0; i < kToneCurveNames.size(); ++i)
        if (kToneCurveNames[i] == name) return static_cast<ToneCurve>(i);
    throw std::out_of_range("there is no tone curve '" + std::string(name) + "'");
}

ToneMapper::ToneMapper(const ToneMapping& mapping)
    : curve_(mapping.curve),
      white_point_(mapping.white_point),
      balances_(mapping.white_balance_k.value_or(kNeutralKelvin) != kNeutralKelvin),
      balance_(balance_matrix(mapping.white_balance_k.value_or(kNeutralKelvin))) {}

Vec3 ToneMapper::operator()(Vec3 linear) const {
    if (balances_) linear = times(balance_, clamped(linear, kBrightest));
    if (curve_ == ToneCurve::linear) return linear;
    const Vec3 color = clamped(linear, kBrightest);
    switch (curve_) {
        case ToneCurve::reinhard:
            return clamped(reinhard(color, white_point_), 1);
        case ToneCurve::aces:
            return clamped(aces(color), 1);
        case ToneCurve::agx:
            return clamped(agx(color), 1);
        default:
            return each(color, power_law);
    }
}

Image tone_mapped(Image image, const ToneMapping& mapping) {
    const ToneMapper map(mapping);
    if (map.changes_nothing()) return image;
    for (Vec3& pixel : image.pixels) pixel = map(pixel);
    return image;
}

}  // namespace sundog::output
