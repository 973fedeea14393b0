// SPDX-License-Identifier: Apache-2.0
#include "fields/function_evaluator.h"

#include "fields/pigment_evaluator.h"

namespace sundog::fields {

FunctionEvaluator::FunctionEvaluator(std::shared_ptr<const scene::Function> function,
                                     std::span<const scene::Texture> textures)
    : function_(std::move(function)) {
    if (!function_->pigments.empty())
        pigments_ = std::make_shared<const PigmentEvaluator>(function_->pigments, textures);
}

}  // namespace sundog::fields
