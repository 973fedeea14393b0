// SPDX-License-Identifier: Apache-2.0
// Functions of the built scene: as flat ones, with the pigments that they call.
#pragma once

#include <map>
#include <memory>
#include <span>

#include "import/pov/build_context.h"
#include "import/pov/functions.h"
#include "scene/function.h"

namespace sundog::pov {

/// Reads pigments and patterns of functions, each once.
class BlockPigments : public FunctionPigments {
public:
    explicit BlockPigments(BuildContext& context) : context_(context) {}
    std::shared_ptr<const scene::Pigment> pigment_of(const std::shared_ptr<const Block>& pigment) override;
    std::shared_ptr<const scene::Pigment> pigment_of_pattern(const std::shared_ptr<const Block>& pattern) override;
    [[nodiscard]] std::span<const scene::Texture> textures() const override { return context_.scene.textures; }

private:
    using Known = std::map<std::shared_ptr<const Block>, std::shared_ptr<const scene::Pigment>>;
    BuildContext& context_;
    Known pigments_, patterns_;
};

/// One or more functions of the same `input_count` inputs as a flat one with an output each; those with fewer
/// parameters take the first inputs. A colour counts by its grey. Errors: InputError.
std::shared_ptr<const scene::Function> read_functions(
    BuildContext& context, std::span<const std::shared_ptr<const FunctionExpression>> functions,
    std::uint32_t input_count);

}  // namespace sundog::pov
