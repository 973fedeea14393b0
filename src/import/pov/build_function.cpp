// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_function.h"

#include "import/pov/build_pattern.h"
#include "import/pov/build_pigment.h"
#include "import/pov/function_lowering.h"

namespace sundog::pov {

std::shared_ptr<const scene::Pigment> BlockPigments::pigment_of(const std::shared_ptr<const Block>& pigment) {
    auto& known = pigments_[pigment];
    if (!known) known = std::make_shared<const scene::Pigment>(read_pigment(context_, *pigment, {}));
    return known;
}

std::shared_ptr<const scene::Pigment> BlockPigments::pigment_of_pattern(const std::shared_ptr<const Block>& pattern) {
    auto& known = patterns_[pattern];
    if (known) return known;
    ItemReader items(context_, *pattern);
    PatternParts parts;
    while (!items.at_end())
        if (!read_pattern_item(items, parts)) items.unexpected("a pattern or a pattern's modifier");
    if (!parts.given) context_.fail(pattern->where, "a pattern { } without a pattern", "expected one such as bozo");
    scene::Pigment pigment;
    pigment.where = context_.location(pattern->where);
    pigment.pattern = parts.pattern;
    const std::size_t choices = choice_count(parts.pattern.kind);
    pigment.kind = choices > 0 ? scene::Pigment::Kind::choice : scene::Pigment::Kind::mapped;
    const std::size_t count = choices > 0 ? choices : 2;
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = static_cast<float>(i);
        pigment.entries.push_back({value, {value, value, value, 0, 0}, nullptr});
    }
    place(
        parts, [&](const Affine3d& old_from_new) { move_pigment(pigment, old_from_new); },
        [&](const scene::Warp& warp) { bend_pigment(pigment, warp); });
    return known = std::make_shared<const scene::Pigment>(std::move(pigment));
}

std::shared_ptr<const scene::Function> read_functions(
    BuildContext& context, std::span<const std::shared_ptr<const FunctionExpression>> functions,
    std::uint32_t input_count) {
    BlockPigments pigments(context);
    try {
        auto function = std::make_shared<scene::Function>(*lowered_together(functions, input_count, &pigments));
        if (!functions.empty()) function->where = context.location(functions.front()->where);
        return function;
    } catch (const FunctionError& error) {
        context.fail(error.where, error.what());
    }
}

}  // namespace sundog::pov
