// SPDX-License-Identifier: Apache-2.0
#include "scene/sun_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sundog::scene {
namespace {

/// What makes a white surface 1, in lux: full daylight.
constexpr double kOne_lux = 120'000;
constexpr double kSun_lux = 133'000;  // Outside of the air.
constexpr double kGroundAlbedo = 0.2;

using Xyz = std::array<double, 3>;

/// Linear sRGB (IEC 61966-2-1); what lies outside of its gamut is moved to its border.
Vec3 rgb_of(const Xyz& c) {
    const auto channel = [&](double x, double y, double z) {
        return static_cast<float>(std::max(x * c[0] + y * c[1] + z * c[2], 0.0));
    };
    return {channel(3.2409699, -1.5373832, -0.4986108), channel(-0.9692436, 1.8759675, 0.0415551),
            channel(0.0556301, -0.2039770, 1.0569715)};
}

/// Perez's five coefficients: darkening to the horizon, its gradient, the glow about the sun, its width, and light
/// scattered back.
struct Perez {
    double a, b, c, d, e;

    /// Equation 3; `theta` from the zenith and `gamma` from the sun.
    [[nodiscard]] double operator()(double cos_theta, double gamma) const {
        const double cos_gamma = std::cos(gamma);
        return (1 + a * std::exp(b / cos_theta)) * (1 + c * std::exp(d * gamma) + e * cos_gamma * cos_gamma);
    }
};

/// The sky of one place of the sun: what doesn't depend on where one looks.
class Sky {
public:
    Sky(double turbidity, double cos_sun) : theta_sun_(std::acos(std::clamp(cos_sun, 0.0, 1.0))) {
        const double t = turbidity, s = theta_sun_;
        luminance_ = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
                      -0.0670 * t + 0.3703};
        x_ = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
              -0.0033 * t + 0.0452};
        y_ = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
              -0.0109 * t + 0.0529};
        const double chi = (4.0 / 9 - t / 120) * (M_PI - 2 * s);
        // In kcd/m^2. Thin haze and a low sun would give less than nothing.
        zenith_luminance_ = std::max((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192, 0.05);
        const auto cubic = [s](double a, double b, double c, double d) { return ((a * s + b) * s + c) * s + d; };
        zenith_x_ = (cubic(0.00166, -0.00375, 0.00209, 0) * t + cubic(-0.02903, 0.06377, -0.03202, 0.00394)) * t +
                    cubic(0.11693, -0.21196, 0.06052, 0.25886);
        zenith_y_ = (cubic(0.00275, -0.00610, 0.00317, 0) * t + cubic(-0.04214, 0.08970, -0.04153, 0.00516)) * t +
                    cubic(0.15346, -0.26756, 0.06670, 0.26688);
    }

    /// XYZ in kcd/m^2.
    [[nodiscard]] Xyz operator()(double cos_theta, double gamma) const {
        const double above = std::max(cos_theta, 1e-3);  // Perez's formula has no horizon.
        const auto at = [&](const Perez& perez, double zenith) {
            return zenith * perez(above, gamma) / perez(1, theta_sun_);
        };
        const double luminance = std::max(at(luminance_, zenith_luminance_), 1e-3);
        const double x = at(x_, zenith_x_), y = at(y_, zenith_y_);
        return {luminance * x / y, luminance, luminance * std::max(1 - x - y, 0.0) / y};
    }

private:
    double theta_sun_;
    Perez luminance_{}, x_{}, y_{};
    double zenith_luminance_ = 0, zenith_x_ = 0, zenith_y_ = 0;
};

double angle_between(Vec3 a, Vec3 b) { return std::acos(std::clamp(static_cast<double>(dot(a, b)), -1.0, 1.0)); }

/// From kcd/m^2 to radiance as it is counted here.
constexpr double kScale = 1000 * M_PI / kOne_lux;

Vec3 radiance_of(const Sky& sky, const Daylight& daylight, Vec3 up, Vec3 direction) {
    Xyz xyz = sky(dot(direction, up), angle_between(direction, daylight.to_sun));
    for (double& c : xyz) c *= kScale;
    return rgb_of(xyz);
}

/// Ozone's absorption per centimetre, from 450 nm in steps of 10 nm (the paper's table 2).
constexpr std::array kOzone{0.003, 0.006, 0.009, 0.014, 0.021, 0.030, 0.040, 0.048, 0.063, 0.075, 0.085,
                            0.103, 0.120, 0.120, 0.115, 0.125, 0.120, 0.105, 0.090, 0.079, 0.067, 0.057,
                            0.048, 0.036, 0.028, 0.023, 0.018, 0.014, 0.011, 0.010, 0.009, 0.007, 0.004};

double ozone_absorption(double nm) {
    const double place = (nm - 450) / 10;
    if (place < 0 || place >= static_cast<double>(kOzone.size() - 1)) return 0;
    const auto below = static_cast<std::size_t>(place);
    return kOzone[below] + (kOzone[below + 1] - kOzone[below]) * (place - static_cast<double>(below));
}

/// The CIE 1931 observer, by the fits of Wyman, Sloan and Shirley, JCGT 2013, section 2.2.
Xyz observer(double nm) {
    const auto lobe = [nm](double middle, double below, double above) {
        const double t = (nm - middle) * (nm < middle ? below : above);
        return std::exp(-0.5 * t * t);
    };
    return {
        0.362 * lobe(442.0, 0.0624, 0.0374) + 1.056 * lobe(599.8, 0.0264, 0.0323) - 0.065 * lobe(501.1, 0.0490, 0.0382),
        0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322),
        1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725)};
}

/// Planck's law, of no particular scale.
double black_body(double nm, double kelvin) {
    constexpr double kC2_nm_K = 1.438777e7;
    return std::pow(nm / 550, -5) / std::expm1(kC2_nm_K / (nm * kelvin));
}

/// Share of light that comes through air of `mass` times the thickness overhead.
double transmittance(double nm, double mass, double turbidity) {
    const double um = nm / 1000;
    const double haze = 0.04608 * turbidity - 0.04586;  // Ångström's coefficient
    constexpr double kOzone_cm = 0.35, kAngstromExponent = 1.3;
    return std::exp(-mass * (0.008735 * std::pow(um, -4.08) + haze * std::pow(um, -kAngstromExponent) +
                             ozone_absorption(nm) * kOzone_cm));
}

}  // namespace

Vec3 sky_radiance(const Daylight& daylight, Vec3 up, Vec3 direction) {
    return radiance_of(Sky(daylight.turbidity, dot(daylight.to_sun, up)), daylight, up, direction);
}

Vec3 sun_color(const Daylight& daylight, Vec3 up) {
    const double cos_theta = std::clamp(static_cast<double>(dot(daylight.to_sun, up)), 0.0, 1.0);
    const double theta_deg = std::acos(cos_theta) * 180 / M_PI;
    // Kasten's relative optical mass, as the paper has it.
    const double mass = 1 / (cos_theta + 0.15 * std::pow(93.885 - theta_deg, -1.253));
    Xyz sum{};
    double unattenuated = 0;
    for (int wavelength = 380; wavelength <= 780; wavelength += 5) {
        const double nm = wavelength;
        const double light = black_body(nm, 5772), through = transmittance(nm, mass, daylight.turbidity);
        const Xyz seen = observer(nm);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += light * through * seen[i];
        unattenuated += light * seen[1];
    }
    for (double& c : sum) c *= kSun_lux / kOne_lux / unattenuated;
    return rgb_of(sum);
}

Environment make_sky(const Daylight& daylight, Vec3 up, Vec3 middle, std::uint32_t height) {
    Environment environment;
    environment.name = "sky";
    environment.width = 2 * height;
    environment.height = height;
    environment.up = up;
    environment.middle = middle;
    environment.radiance.resize(static_cast<std::size_t>(environment.width) * height);
    const Sky sky(daylight.turbidity, dot(daylight.to_sun, up));
    // Sum of radiance times cosine times solid angle, over pi: what a white surface on the ground sends back.
    Vec3 white = sun_color(daylight, up) * std::max(dot(daylight.to_sun, up), 0.0F);
    const auto place = [&](std::uint32_t x, std::uint32_t y) {
        return static_cast<std::size_t>(y) * environment.width + x;
    };
    for (std::uint32_t y = 0; y < height / 2; ++y) {
        const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
        const float share = std::cos(v * kPi) * std::sin(v * kPi) / static_cast<float>(height) * 2 * kPi /
                            static_cast<float>(environment.width);
        for (std::uint32_t x = 0; x < environment.width; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(environment.width);
            const Vec3 radiance = radiance_of(sky, daylight, up, direction_in(environment, u, v));
            environment.radiance[place(x, y)] = radiance;
            white += radiance * share;
        }
    }
    const Vec3 ground = white * static_cast<float>(kGroundAlbedo);
    std::fill(environment.radiance.begin() + static_cast<std::ptrdiff_t>(place(0, height / 2)),
              environment.radiance.end(), ground);
    return environment;
}

void put_under_sky(float azimuth_deg, float elevation_deg, float turbidity, Scene& scene) {
    constexpr std::uint32_t kHeight = 512;
    const Compass compass = compass_of(scene);
    const Daylight daylight{normalize(direction_at(compass, azimuth_deg, elevation_deg)), turbidity};
    scene.environment = make_sky(daylight, compass.up, compass.middle, kHeight);
    std::erase_if(scene.lights, [](const Light& light) { return light.kind == Light::Kind::sun; });
    Light sun;
    sun.kind = Light::Kind::sun;
    sun.place = daylight.to_sun;
    sun.color = sun_color(daylight, compass.up);
    scene.lights.push_back(sun);
}

}  // namespace sundog::scene
