// SPDX-License-Identifier: Apache-2.0
#include "output/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "output/srgb.h"

namespace sundog::output {
namespace {

constexpr float kPixelsPerDegree = 67;

using Colour = std::array<double, 3>;

// Linear sRGB to CIE XYZ (IEC 61966-2-1), and the XYZ of white.
constexpr std::array<Colour, 3> kXyzFromRgb{
    {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
constexpr std::array<Colour, 3> kRgbFromXyz{
    {{3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560}, {0.0556434, -0.2040259, 1.0572252}}};
constexpr Colour kWhite{0.4124564 + 0.3575761 + 0.1804375, 0.2126729 + 0.7151522 + 0.0721750,
                        0.0193339 + 0.1191920 + 0.9503041};

constexpr Colour product(const std::array<Colour, 3>& m, const Colour& v) {
    Colour result{};
    for (std::size_t row = 0; row < 3; ++row) result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    return result;
}

/// XYZ relative to white to a space of opponent colours: brightness, red-green, blue-yellow. YCxCz takes the plain
/// numbers, L*a*b* their cube roots (section 4.1).
constexpr Colour opponents(const Colour& xyz) {
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Colour ycxcz_from_linear(const Colour& rgb) {
    Colour xyz = product(kXyzFromRgb, rgb);
    for (std::size_t c = 0; c < 3; ++c) xyz[c] /= kWhite[c];
    return opponents(xyz);
}

Colour linear_from_ycxcz(const Colour& ycxcz) {
    const double y = (ycxcz[0] + 16) / 116;
    return product(kRgbFromXyz, {(y + ycxcz[1] / 500) * kWhite[0], y * kWhite[1], (y - ycxcz[2] / 200) * kWhite[2]});
}

/// CIE L*a*b* (1976), with colourfulness reduced in the dark after Hunt (section 4.1.2).
Colour hunt_lab_from_linear(const Colour& rgb) {
    constexpr double kDelta = 6.0 / 29;
    Colour xyz = product(kXyzFromRgb, rgb);
    for (std::size_t c = 0; c < 3; ++c) {
        const double t = xyz[c] / kWhite[c];
        xyz[c] = t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
    }
    Colour lab = opponents(xyz);
    lab[1] *= 0.01 * lab[0];
    lab[2] *= 0.01 * lab[0];
    return lab;
}

/// The distance HyAB: city-block between brightness and colour, Euclidean within colour.
double hyab(const Colour& a, const Colour& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

/// A picture's three YCxCz planes.
using Planes = std::array<Plane, 3>;

Planes ycxcz_planes(const std::vector<std::uint8_t>& codes, int width, int height) {
    Planes planes{Plane(width, height), Plane(width, height), Plane(width, height)};
    const std::array<float, 256>& linear = linear_of_srgb8();
    for (std::size_t i = 0; i < planes[0].values.size(); ++i) {
        const Colour colour =
            ycxcz_from_linear({linear[codes[3 * i]], linear[codes[3 * i + 1]], linear[codes[3 * i + 2]]});
        for (std::size_t c = 0; c < 3; ++c) planes[c].values[i] = static_cast<float>(colour[c]);
    }
    return planes;
}

/// One of the Gaussians a sqrt(pi/b) exp(-pi^2 x^2 / b), x in degrees, whose sum is the spatial filter that has a
/// channel's contrast sensitivity (section 4.1.1, table 1).
struct SensitivityTerm {
    double a, b;
};

// Out to three standard deviations of the widest Gaussian (b = 0.04).
const int kSensitivityRadius =
    static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * std::numbers::pi * std::numbers::pi)) * kPixelsPerDegree));

Plane filtered_by(const Plane& plane, const std::vector<SensitivityTerm>& terms) {
    // A Gaussian of x*x + y*y is a product of one in x and one in y; their sum isn't, so the terms are filtered apart.
    // Each has the weight of its unnormalised two-dimensional kernel within the sum.
    std::vector<Kernel> kernels;
    std::vector<double> weights;
    double total = 0;
    for (const SensitivityTerm& term : terms) {
        const auto sigma_px =
            static_cast<float>(std::sqrt(term.b / (2 * std::numbers::pi * std::numbers::pi)) * kPixelsPerDegree);
        kernels.push_back(gaussian(sigma_px, kSensitivityRadius));
        const double centre = kernels.back()[static_cast<std::size_t>(kSensitivityRadius)];
        // The normalised kernel's centre is 1 / (sum of exp), so this is the 2D kernel's sum.
        weights.push_back(term.a * std::sqrt(std::numbers::pi / term.b) / (centre * centre));
        total += weights.back();
    }
    Plane result(plane.width, plane.height);
    for (std::size_t t = 0; t < terms.size(); ++t) {
        const Plane part = filtered(plane, kernels[t], kernels[t]);
        const auto weight = static_cast<float>(weights[t] / total);
        for (std::size_t i = 0; i < part.values.size(); ++i) result.values[i] += weight * part.values[i];
    }
    return result;
}

/// What is left of the picture at this distance, for comparing colours.
std::vector<Colour> seen_colours(const Planes& ycxcz) {
    const Plane brightness = filtered_by(ycxcz[0], {{1, 0.0047}});
    const Plane red_green = filtered_by(ycxcz[1], {{1, 0.0053}});
    const Plane blue_yellow = filtered_by(ycxcz[2], {{34.1, 0.04}, {13.5, 0.025}});
    std::vector<Colour> colours(brightness.values.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        Colour rgb = linear_from_ycxcz({brightness.values[i], red_green.values[i], blue_yellow.values[i]});
        for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
        colours[i] = hunt_lab_from_linear(rgb);
    }
    return colours;
}

/// Colour errors are compressed, and those under 0.4 of the largest are spread over nearly all of 0..1 (4.1.3).
class ColourError {
public:
    double operator()(const Colour& a, const Colour& b) const {
        const double error = std::pow(hyab(a, b), kExponent);
        if (error < knee_) return kKneeError / knee_ * error;
        return kKneeError + (error - knee_) / (largest_ - knee_) * (1 - kKneeError);
    }

private:
    static constexpr double kExponent = 0.7, kKneeFraction = 0.4, kKneeError = 0.95;
    // The pair of colours furthest apart.
    double largest_ = std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), kExponent);
    double knee_ = kKneeFraction * largest_;
};

/// Scales the positive weights to the sum 1 and the negative ones to -1.
void balance(Kernel& kernel) {
    float positive = 0, negative = 0;
    for (const float weight : kernel) (weight > 0 ? positive : negative) += weight;
    for (float& weight : kernel) weight /= weight > 0 ? positive : -negative;
}

/// How strong edges and points are in a picture's brightness (section 4.2).
struct Features {
    explicit Features(const Plane& ycxcz_y) : edges(ycxcz_y.width, ycxcz_y.height), points(edges) {
        constexpr float kFeatureWidth_deg = 0.082F;
        constexpr float kSigma = 0.5F * kFeatureWidth_deg * kPixelsPerDegree;
        const int radius = static_cast<int>(std::ceil(3 * kSigma));
        const Kernel smooth = gaussian(kSigma, radius);
        Kernel first = smooth, second = smooth;  // Derivatives
        for (int x = -radius; x <= radius; ++x) {
            const auto i = static_cast<std::size_t>(x + radius);
            const auto offset = static_cast<float>(x);
            first[i] *= -offset;
            second[i] *= offset * offset / (kSigma * kSigma) - 1;
        }
        balance(first);
        balance(second);
        Plane brightness = ycxcz_y;
        for (float& value : brightness.values) value = (value + 16) / 116;
        const auto strength = [&](const Kernel& derivative, Plane& out) {
            const Plane x = filtered(brightness, derivative, smooth);
            const Plane y = filtered(brightness, smooth, derivative);
            for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = std::hypot(x.values[i], y.values[i]);
        };
        strength(first, edges);
        strength(second, points);
    }
    Plane edges, points;
};

}  // namespace

Plane flip_errors(const std::vector<std::uint8_t>& codes_a, const std::vector<std::uint8_t>& codes_b, int width,
                  int height) {
    const Planes a = ycxcz_planes(codes_a, width, height), b = ycxcz_planes(codes_b, width, height);
    const std::vector<Colour> colours_a = seen_colours(a), colours_b = seen_colours(b);
    const Features features_a(a[0]), features_b(b[0]);
    const ColourError colour_error;
    Plane errors(width, height);
    for (std::size_t i = 0; i < errors.values.size(); ++i) {
        const float edge = std::abs(features_a.edges.values[i] - features_b.edges.values[i]);
        const float point = std::abs(features_a.points.values[i] - features_b.points.values[i]);
        const double feature_error = std::min(1.0, std::sqrt(std::max(edge, point) * std::numbers::sqrt2 / 2));
        errors.values[i] = static_cast<float>(std::pow(colour_error(colours_a[i], colours_b[i]), 1 - feature_error));
    }
    return errors;
}

}  // namespace sundog::output
