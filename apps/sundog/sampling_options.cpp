// SPDX-License-Identifier: Apache-2.0
#include "sampling_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

using Way = SamplingArguments::Way;

/// By their numbers.
constexpr std::array<std::string_view, 4> kPatterns{"r2", "regular", "jittered", "sobol"};
static_assert(kPatterns.size() == kernel::SAMPLES_SOBOL + 1);

struct Filter {
    std::string_view name;
    float radius;  ///< Where none is given, in pixels.
};
/// By their numbers; `pixel`, which needs no radius, is the box of half a pixel.
constexpr std::array<Filter, 6> kFilters{
    {{"pixel", 0.5F}, {"box", 0.5F}, {"tent", 1}, {"gaussian", 1.5F}, {"mitchell", 2}, {"blackman-harris", 1.5F}}};
static_assert(kFilters.size() == kernel::FILTER_BLACKMAN_HARRIS + 1);

constexpr int kAdaptiveSamples = 9;
constexpr int kErrorDrivenSamples = 1024;
constexpr int kRecursion = 3;
constexpr float kDepthRatio = 0.1F;
constexpr float kLongestTime_s = 1e6F;
/// With fewer, the weights below 0 of Mitchell's filter may outweigh the others.
constexpr int kFewestForNegativeWeights = 16;

template <std::size_t N>
std::uint32_t numbered(std::string_view option, std::string_view text, const std::array<std::string_view, N>& names) {
    const std::string name = parse_choice(option, text, {names.begin(), names.end()});
    std::uint32_t number = 0;
    while (names[number] != name) ++number;
    return number;
}

std::uint32_t filter_named(std::string_view text) {
    std::array<std::string_view, kFilters.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kFilters[i].name;
    return numbered("--filter", text, names);
}

/// "color", "object" and "depth", with commas between them.
void parse_differences(const std::string& text, SamplingArguments& a) {
    a.adaptive_by_object = a.adaptive_by_depth = false;
    std::string_view rest = text;
    while (true) {
        const std::size_t comma = rest.find(',');
        const std::string name = parse_choice("--adaptive-by", rest.substr(0, comma), {"color", "object", "depth"});
        if (name == "object") a.adaptive_by_object = true;
        if (name == "depth") a.adaptive_by_depth = true;
        if (comma == std::string_view::npos) return;
        rest.remove_prefix(comma + 1);
    }
}

int square_root_of(int samples) { return static_cast<int>(std::lround(std::floor(std::sqrt(samples + 0.5)))); }

}  // namespace

Way SamplingArguments::way() const {
    if (target_error || time_limit_s) return Way::to_error;
    if (adaptive) return adaptive_method.value_or(1) == 2 ? Way::recursive : Way::adaptive;
    return preview ? Way::preview : Way::fixed;
}

int SamplingArguments::most_samples() const {
    switch (way()) {
        case Way::to_error:
            return samples.value_or(kErrorDrivenSamples);
        case Way::adaptive:
            return samples.value_or(kAdaptiveSamples);
        case Way::recursive: {
            const int side = (1 << adaptive_depth.value_or(kRecursion)) + 1;
            return side * side;
        }
        default:
            return samples.value_or(1);
    }
}

kernel::PixelSampling SamplingArguments::pixel_sampling() const {
    const std::uint32_t filter = pixel_filter.value_or(kernel::FILTER_PIXEL);
    // Single samples are in the middle.
    const bool one = way() != Way::fixed || most_samples() == 1;
    const std::uint32_t where = pattern.value_or(one ? kernel::SAMPLES_R2 : kernel::SAMPLES_SOBOL);
    const bool grid = where == kernel::SAMPLES_REGULAR || where == kernel::SAMPLES_JITTERED;
    return {where, grid ? static_cast<std::uint32_t>(square_root_of(most_samples())) : 0, filter,
            filter_radius.value_or(kFilters[filter].radius)};
}

std::uint32_t SamplingArguments::planes() const {
    return (adaptive_by_object.value_or(false) ? kernel::AOV_OBJECT : 0U) |
           (adaptive_by_depth.value_or(false) ? kernel::AOV_DEPTH : 0U);
}

AdaptiveSampling SamplingArguments::adaptive_sampling(float gain) const {
    AdaptiveSampling sampling;
    sampling.threshold = adaptive.value();
    sampling.samples = static_cast<std::uint32_t>(most_samples());
    sampling.by_object = adaptive_by_object.value_or(false);
    sampling.depth_ratio = adaptive_by_depth.value_or(false) ? kDepthRatio : 0;
    sampling.preview = preview.value_or(0.0F);
    sampling.preview_method = preview_method.value_or(RefinementMethod::grid);
    sampling.gain = gain;
    return sampling;
}

RecursiveSampling SamplingArguments::recursive_sampling() const {
    RecursiveSampling sampling;
    sampling.threshold = adaptive.value();
    sampling.depth = adaptive_depth.value_or(kRecursion);
    return sampling;
}

ErrorTarget SamplingArguments::error_target(float gain) const {
    ErrorTarget target;
    target.error = target_error.value_or(0.0F);
    if (time_limit_s) target.time_limit_s = *time_limit_s;
    target.most_samples = static_cast<std::uint32_t>(most_samples());
    target.gain = gain;
    return target;
}

void SamplingArguments::check() const {
    const Way chosen = way();
    const bool differences = adaptive_by_object.has_value();
    if (!adaptive && (adaptive_method || adaptive_depth || differences))
        throw UsageError("--adaptive-method, --adaptive-depth and --adaptive-by say how --adaptive goes about it",
                         "add --adaptive 0.3");
    if (preview_method && !preview)
        throw UsageError("--preview-method says how --preview chooses what to trace", "add --preview 0.1");
    if (filter_radius && !pixel_filter)
        throw UsageError("--filter-radius is that of a --filter", "for example --filter gaussian");
    if (chosen == Way::to_error && (adaptive || preview))
        throw UsageError(
            "--target-error and --time-limit choose the pixels themselves: leave --adaptive and --preview out");
    if (chosen == Way::preview && samples.value_or(1) > 1)
        throw UsageError("--preview takes one sample a pixel at most", "add --adaptive 0.3 for more at edges");
    if (pattern && chosen != Way::fixed)
        throw UsageError("--sampler is for pictures with the same number of samples in each pixel",
                         "leave it out, or --adaptive, --preview, --target-error and --time-limit");
    if (adaptive_depth && chosen != Way::recursive)
        throw UsageError("--adaptive-depth is for the recursive method", "add --adaptive-method 2, or use --spp");
    if (chosen == Way::recursive && (samples || preview || differences || pixel_filter))
        throw UsageError("--adaptive-method 2 knows no --spp, --preview, --adaptive-by or --filter",
                         "--adaptive-depth says how often a pixel may be divided");
    if (chosen == Way::adaptive && most_samples() < 2)
        throw UsageError("--adaptive needs more than one sample where pixels differ", "for example --spp 9");
    if (preview && planes() != 0)
        throw UsageError("--adaptive-by object and depth need every pixel traced: leave --preview out");
    if (preview && pixel_filter) throw UsageError("--preview traces the pixels' middles: leave --filter out");
    constexpr int kFewest = static_cast<int>(kSampleBlock * kFewestBlocks);
    if (target_error && most_samples() < kFewest)
        throw UsageError(
            fmt::format("--target-error needs {} samples of a pixel to tell its error, and --spp allows {}", kFewest,
                        most_samples()));
    if (pixel_filter == kernel::FILTER_MITCHELL && (chosen != Way::fixed || most_samples() < kFewestForNegativeWeights))
        throw UsageError(
            "--filter mitchell has weights below 0 and so needs the same, large number of samples in each pixel",
            fmt::format("--spp {} or more", kFewestForNegativeWeights));
    if (pattern == kernel::SAMPLES_REGULAR || pattern == kernel::SAMPLES_JITTERED) {
        const int side = square_root_of(most_samples());
        if (side * side != most_samples())
            throw UsageError(fmt::format("--sampler {} needs a square number of samples, not {}", kPatterns[*pattern],
                                         most_samples()),
                             fmt::format("--spp {} or {}", side * side, (side + 1) * (side + 1)));
    }
}

void add_sampling_options(CLI::App& command, SamplingArguments& a) {
    using Text = const std::string&;
    const auto add = [&](const char* name, auto read, const char* help, const char* type) {
        command.add_option_function<std::string>(name, read, help)->type_name(type);
    };
    add(
        "--spp", [&a](Text text) { a.samples = parse_int("--spp", text, 1, 65536); },
        "Samples a pixel (1); the most that one gets with --adaptive (9) and --target-error (1024)", "N");
    add(
        "--sampler", [&a](Text text) { a.pattern = numbered("--sampler", text, kPatterns); },
        "Where in a pixel they go: sobol (default), r2, regular or jittered", "NAME");
    add(
        "--filter", [&a](Text text) { a.pixel_filter = filter_named(text); },
        "How they are weighed: pixel (default), box, tent, gaussian, mitchell or blackman-harris", "NAME");
    add(
        "--filter-radius", [&a](Text text) { a.filter_radius = parse_float("--filter-radius", text, 0.1F, 16); },
        "How far the filter reaches, in pixels (box 0.5, tent 1, gaussian and blackman-harris 1.5, mitchell 2)", "R");
    add(
        "--preview", [&a](Text text) { a.preview = parse_float("--preview", text, 0, 1); },
        "Trace fewer rays than pixels: interpolate between points that see the same and differ by less than this for "
        "the eye (0.1 is hardly seen; 0 traces all)",
        "T");
    add(
        "--preview-method", [&a](Text text) { a.preview_method = parse_refinement_method(text); },
        "grid: squares whose corners agree are interpolated (default); scanline: so are spans of scan lines whose "
        "ends agree; scanline-assumed: between ends that see the same, pixels are shaded without a search",
        "NAME");
    add(
        "--adaptive", [&a](Text text) { a.adaptive = parse_float("--adaptive", text, 0, 3); },
        "More samples only where neighbours' red, green and blue differ by this much in sum (0.3 is POV-Ray's)", "T");
    add(
        "--adaptive-method", [&a](Text text) { a.adaptive_method = parse_int("--adaptive-method", text, 1, 2); },
        "1 (default): --spp samples there; 2: squares are divided where their corners differ", "M");
    add(
        "--adaptive-depth",
        [&a](Text text) { a.adaptive_depth = parse_int("--adaptive-depth", text, 1, kMostRecursion); },
        "How often method 2 may halve a pixel (3)", "D");
    add(
        "--adaptive-by", [&a](Text text) { parse_differences(text, a); },
        "What makes neighbours differ for method 1: color (always), object, depth", "LIST");
    add(
        "--target-error", [&a](Text text) { a.target_error = parse_float("--target-error", text, 1e-4F, 1); },
        "Sample until each pixel is this sure: half of its 95% confidence interval, for the eye (0.01 is clean)", "E");
    add(
        "--time-limit", [&a](Text text) { a.time_limit_s = parse_float("--time-limit", text, 0.01F, kLongestTime_s); },
        "Sample where the error is largest until so many seconds are over", "S");
}

}  // namespace sundog::app
