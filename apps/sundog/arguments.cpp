// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/diagnostics.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr int kMostFrames = 1'000'000;

/// The whole text as a number; nothing where it is no number or does not fit.
template <class T>
std::optional<T> number(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// What stands before and after the first `separator`.
struct Halves {
    std::string_view left, right;
};
std::optional<Halves> split(std::string_view text, std::string_view separator) {
    const std::size_t at = text.find(separator);
    if (at == std::string_view::npos) return std::nullopt;
    return Halves{text.substr(0, at), text.substr(at + separator.size())};
}

/// Values are echoed as they were given, so they are cut to a line and freed of control characters.
std::string shown(std::string_view text) {
    std::string clean(text.substr(0, 60));
    for (char& c : clean)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return text.size() > 60 ? clean + "…" : clean;
}

[[noreturn]] void fail(std::string_view option, std::string_view text, const std::string& expected,
                       const std::string& hint = {}) {
    throw UsageError(fmt::format("{} '{}': {}", option, shown(text), expected), hint);
}

/// Names all that are valid, whether or not one is near to the word.
[[noreturn]] void fail_choice(std::string_view option, std::string_view text,
                              const std::vector<std::string_view>& valid) {
    std::string expected = "expected ";
    for (std::size_t i = 0; i < valid.size(); ++i) {
        if (i > 0) expected += i + 1 < valid.size() ? ", " : " or ";
        expected += valid[i];
    }
    fail(option, text, expected, nearest_names(text, valid).empty() ? "" : suggest(text, valid));
}

}  // namespace

Size parse_size(std::string_view text) {
    const std::string expected = fmt::format("width and height must be whole numbers from 1 to {}", kLargestSide);
    const std::string hint = "for example --size 1920x1080";
    const auto sides = split(text, "x");
    if (!sides) fail("--size", text, expected, hint);
    const auto width = number<int>(sides->left);
    const auto height = number<int>(sides->right);
    const auto valid = [](std::optional<int> side) { return side && *side >= 1 && *side <= kLargestSide; };
    if (!valid(width) || !valid(height)) fail("--size", text, expected, hint);
    return {*width, *height};
}

Pixel parse_pixel(std::string_view text, std::string_view option) {
    const auto halves = split(text, ",");
    const auto x = halves ? number<int>(halves->left) : std::nullopt;
    const auto y = halves ? number<int>(halves->right) : std::nullopt;
    if (!x || !y || *x < 0 || *y < 0)
        fail(option, text, "expected x,y counted from 0 at the upper left",
             "for example " + std::string(option) + " 320,240");
    return {*x, *y};
}

FrameRange parse_frames(std::string_view text) {
    const auto halves = split(text, "..");
    const auto first = number<int>(halves ? halves->left : text);
    const auto last = halves ? number<int>(halves->right) : first;
    if (!first || !last || *first < 0 || *last < *first || *last >= kMostFrames)
        fail("--frames", text, fmt::format("expected A..B with 0 <= A <= B < {}", kMostFrames),
             "for example --frames 0..249");
    return {*first, *last};
}

int parse_int(std::string_view option, std::string_view text, int least, int most) {
    const auto value = number<int>(text);
    if (!value || *value < least || *value > most)
        fail(option, text, fmt::format("expected a whole number from {} to {}", least, most));
    return *value;
}

float parse_float(std::string_view option, std::string_view text, float least, float most) {
    const auto value = number<float>(text);
    if (!value || !std::isfinite(*value) || *value < least || *value > most)
        fail(option, text, fmt::format("expected a number from {} to {}", least, most));
    return *value;
}

bool parse_switch(std::string_view option, std::string_view text) {
    return parse_choice(option, text, {"on", "off"}) == "on";
}

std::string parse_choice(std::string_view option, std::string_view text, const std::vector<std::string_view>& valid) {
    for (const std::string_view name : valid)
        if (text == name) return std::string(name);
    fail_choice(option, text, valid);
}

AovChoice parse_aovs(std::string_view text) {
    struct Plane {
        std::string_view name;
        AovChoice choice;
    };
    constexpr std::array<Plane, 7> kPlanes{
        {{"depth", {kernel::AOV_DEPTH, false}},
         {"normal", {kernel::AOV_NORMAL, false}},
         {"albedo", {kernel::AOV_ALBEDO, false}},
         {"object", {kernel::AOV_OBJECT, false}},
         {"samples", {0, true}},
         {"cost", {kernel::AOV_COST, false}},
         {"all",
          {kernel::AOV_DEPTH | kernel::AOV_NORMAL | kernel::AOV_ALBEDO | kernel::AOV_OBJECT | kernel::AOV_COST,
           true}}}};
    AovChoice choice;
    std::string_view rest = text;
    while (true) {
        const auto halves = split(rest, ",");
        const std::string_view name = halves ? halves->left : rest;
        bool known = false;
        for (const Plane& plane : kPlanes)
            if (plane.name == name) {
                choice.planes |= plane.choice.planes;
                choice.samples = choice.samples || plane.choice.samples;
                known = true;
            }
        if (!known) {
            std::vector<std::string_view> names;
            names.reserve(std::size(kPlanes));
            for (const Plane& plane : kPlanes) names.push_back(plane.name);
            fail_choice("--aov", name, names);
        }
        if (!halves) return choice;
        rest = halves->right;
    }
}

Acceleration parse_acceleration(std::string_view text) {
    return acceleration_named(parse_choice("--accel", text, {kAccelerationNames.begin(), kAccelerationNames.end()}));
}

RefinementMethod parse_refinement_method(std::string_view text) {
    const std::string name = parse_choice("--preview-method", text, {"grid", "scanline", "scanline-assumed"});
    if (name == "grid") return RefinementMethod::grid;
    return name == "scanline" ? RefinementMethod::scanline : RefinementMethod::scanline_assumed;
}

PrimaryHits parse_primary(std::string_view text) {
    return primary_hits_named(parse_choice("--primary", text, {kPrimaryHitsNames.begin(), kPrimaryHitsNames.end()}));
}

std::string parse_device(std::string_view text) { return parse_choice("--device", text, {"auto", "cpu", "gpu"}); }

}  // namespace sundog::app
