// SPDX-License-Identifier: Apache-2.0
#include "compile/pigment_range.h"

#include <cmath>
#include <numbers>

#include "compile/pattern_range.h"
#include "fields/function_evaluator.h"
#include "fields/pigment_code.h"

namespace sundog {
namespace {

using scene::Pattern;
using scene::Pigment;
using scene::PigmentColor;

ColorRange exactly(const PigmentColor& c) { return {Range{c.r, c.r}, Range{c.g, c.g}, Range{c.b, c.b}}; }

ColorRange either(const ColorRange& a, const ColorRange& b) {
    return {sundog::either(a[0], b[0]), sundog::either(a[1], b[1]), sundog::either(a[2], b[2])};
}

/// Between two entries of a map.
Range between(Range a, Range b, double share) { return a * (1 - share) + b * share; }

/// A medium is asked at points of space, which are on no surface: what depends on one is 0 there.
bool needs_surface(Pattern::Kind kind) { return kind == Pattern::Kind::aoi || kind == Pattern::Kind::slope; }

}  // namespace

PigmentRange::PigmentRange(const Pigment& pigment, std::span<const scene::Texture> textures) : pigment_(pigment) {
    prepare(pigment, textures);
}

void PigmentRange::prepare(const Pigment& pigment, std::span<const scene::Texture> textures) {
    const Pattern& pattern = pigment.pattern;
    if (pattern.kind == Pattern::Kind::function && pattern.function && !functions_.contains(pattern.function.get()))
        functions_[pattern.function.get()] =
            std::make_shared<const fields::FunctionEvaluator>(pattern.function, textures);
    if (pattern.pigment) prepare(*pattern.pigment, textures);
    for (const scene::PigmentEntry& entry : pigment.entries)
        if (entry.pigment) prepare(*entry.pigment, textures);
}

ColorRange PigmentRange::colors_over(const Pigment& pigment, const RangeBox& box) const {
    switch (pigment.kind) {
        case Pigment::Kind::solid:
            return exactly(pigment.color);
        case Pigment::Kind::image: {
            const scene::ImageMap& image = pigment.image;
            // Shown once, a picture is black outside of its square.
            const RangeBox at = pattern_box(pigment.pattern, box);
            const auto outside = [](Range r) { return r.upper < 0 || r.lower > 1; };
            if (image.once && image.map_type == 0 && (outside(at[0]) || outside(at[1]))) return {};
            return {Range{0, 1}, Range{0, 1}, Range{0, 1}};
        }
        case Pigment::Kind::mapped:
        case Pigment::Kind::choice:
            break;
    }
    return entries_over(pigment, box);
}

ColorRange PigmentRange::entries_over(const Pigment& pigment, const RangeBox& box) const {
    const auto& entries = pigment.entries;
    if (entries.empty()) return {};
    const auto colors_of = [&](const scene::PigmentEntry& entry) {
        return entry.pigment ? colors_over(*entry.pigment, box) : exactly(entry.color);
    };
    if (pigment.kind == Pigment::Kind::mapped && pigment.pattern.kind == Pattern::Kind::average) {
        double total = 0;
        for (const scene::PigmentEntry& entry : entries) total += static_cast<double>(entry.at);
        ColorRange sum{};
        for (const scene::PigmentEntry& entry : entries) {
            const double share =
                total > 0 ? static_cast<double>(entry.at) / total : 1 / static_cast<double>(entries.size());
            const ColorRange colors = colors_of(entry);
            for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + colors[i] * share;
        }
        return sum;
    }
    if (pigment.kind == Pigment::Kind::choice) {
        ColorRange all = colors_of(entries[0]);
        for (const scene::PigmentEntry& entry : entries) all = either(all, colors_of(entry));
        // Numbers beyond the list have no entry, and are black.
        return either(all, {});
    }
    // A map is linear between its entries: extremes lie at those within the range of values, and at its ends.
    const Range value = value_over(pigment.pattern, box);
    std::optional<ColorRange> all;
    const auto add = [&](const ColorRange& colors) { all = all ? either(*all, colors) : colors; };
    const auto add_end = [&](double v) {
        std::size_t next = 0;
        while (next < entries.size() && static_cast<double>(entries[next].at) <= v) ++next;
        if (next == 0) return add(colors_of(entries.front()));
        if (next == entries.size()) return add(colors_of(entries.back()));
        const auto before = static_cast<double>(entries[next - 1].at), after = static_cast<double>(entries[next].at);
        const ColorRange a = colors_of(entries[next - 1]), b = colors_of(entries[next]);
        const double share = (v - before) / (after - before);
        add({between(a[0], b[0], share), between(a[1], b[1], share), between(a[2], b[2], share)});
    };
    add_end(value.lower);
    add_end(value.upper);
    for (const scene::PigmentEntry& entry : entries)
        if (static_cast<double>(entry.at) >= value.lower && static_cast<double>(entry.at) <= value.upper)
            add(colors_of(entry));
    return *all;
}

Range PigmentRange::value_over(const Pattern& pattern, const RangeBox& box) const {
    const RangeBox at = pattern_box(pattern, box);
    return wave_over(pattern, field_over(pattern, at));
}

Range PigmentRange::field_over(const Pattern& pattern, const RangeBox& at) const {
    if (needs_surface(pattern.kind)) return {0, 0};
    if (pattern.kind == Pattern::Kind::function && pattern.function) return function_over(pattern, at);
    const bool is_gray =
        pattern.pigment != nullptr && (pattern.kind == Pattern::Kind::pigment || pattern.kind == Pattern::Kind::image);
    if (!is_gray) return sundog::field_over(pattern, at);
    if (pattern.uses_alpha) return kAnyValue;
    const ColorRange colors = colors_over(*pattern.pigment, at);
    return colors[0] * 0.297 + colors[1] * 0.589 + colors[2] * 0.114;
}

Range PigmentRange::function_over(const Pattern& pattern, const RangeBox& at) const {
    // Far out nothing is to be learned, and numbers may become too large.
    constexpr double kFar = 1e6;
    const fields::FunctionEvaluator& evaluator = *functions_.at(pattern.function.get());
    if (evaluator.function().input_count != 3 || std::max({at[0].most(), at[1].most(), at[2].most()}) > kFar)
        return kAnyValue;
    fields::NoiseCells cells;
    fields::RangeEvaluation<3> evaluation(evaluator, cells);
    for (std::size_t i = 0; i < 3; ++i) evaluation.set_input(i, fields::input_range<3>(i, at[i].lower, at[i].upper));
    evaluation.run();
    const fields::Affine<3> value = evaluation.output(0);
    if (!std::isfinite(value.lower) || !std::isfinite(value.upper)) return kAnyValue;
    Range range{value.lower, value.upper};
    // What the host answers where there is no value, and beyond 1. Powers of pigments that are below 0 are 0.
    if (evaluation.may_be_undefined() || !evaluator.function().pigments.empty()) range = sundog::either(range, {0, 0});
    return range.upper > 1 ? sundog::either(range, {0, 1}) : range;
}

int PigmentRange::cost_of(const Pigment& pigment) {
    int cost = pigment.kind == Pigment::Kind::solid ? 1 : pattern_cost(pigment.pattern);
    if (pigment.pattern.pigment) cost += cost_of(*pigment.pattern.pigment);
    for (const scene::PigmentEntry& entry : pigment.entries)
        if (entry.pigment) cost += cost_of(*entry.pigment);
    return cost;
}

}  // namespace sundog
