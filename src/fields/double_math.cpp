// SPDX-License-Identifier: Apache-2.0
#include "fields/double_math.h"

#include "fields/run.h"

namespace sundog::fields {

double DoubleMath::unary(scene::FunctionOp op, double a) {
    static const scene::Function none;
    return compute(DoubleMath{}, none, {op, 0, 0, 0, 0, 0}, &a);
}

double DoubleMath::binary(scene::FunctionOp op, double a, double b) {
    static const scene::Function none;
    const std::array<double, 2> operands{a, b};
    return compute(DoubleMath{}, none, {op, 0, 0, 0, 1, 0}, operands.data());
}

}  // namespace sundog::fields
