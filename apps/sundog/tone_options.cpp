// SPDX-License-Identifier: Apache-2.0
#include "tone_options.h"

#include <CLI/CLI.hpp>
#include <string>

#include "arguments.h"
#include "output/white_balance.h"
#include "usage_error.h"

namespace sundog::app {

output::ToneMapping ToneArguments::mapping() const {
    output::ToneMapping mapping;
    mapping.curve = curve.value_or(mapping.curve);
    mapping.white_point = white_point.value_or(mapping.white_point);
    mapping.white_balance_k = white_balance_k;
    return mapping;
}

void ToneArguments::check(const std::optional<output::Format>& format) const {
    if (white_point && curve != output::ToneCurve::reinhard)
        throw UsageError("--white-point is the luminance that reinhard makes white", "add --tone-map reinhard");
    if (format && output::holds_radiance(*format) && (curve || white_balance_k))
        throw UsageError("--tone-map and --white-balance are for pictures of 8 or 16 bits: .exr and .hdr hold radiance",
                         "leave them out, or write a .png");
}

void add_tone_options(CLI::App& command, ToneArguments& a) {
    using Text = const std::string&;
    command
        .add_option_function<std::string>(
            "--tone-map",
            [&a](Text text) {
                a.curve = output::tone_curve_named(
                    parse_choice("--tone-map", text, {output::kToneCurveNames.begin(), output::kToneCurveNames.end()}));
            },
            "How bright light is brought into the picture's range: linear (default: cut off), reinhard, aces, agx or "
            "gamma (numbers are light to the power 1/2.2)")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--white-point", [&a](Text text) { a.white_point = parse_float("--white-point", text, 0.1F, 1e6F); },
            "The luminance that reinhard makes white (4)")
        ->type_name("L");
    command
        .add_option_function<std::string>(
            "--white-balance",
            [&a](Text text) {
                a.white_balance_k = parse_float("--white-balance", text, output::kLeastKelvin, output::kMostKelvin);
            },
            "Colour temperature of the light that is to look white (6504: as it is)")
        ->type_name("K");
}

}  // namespace sundog::app
