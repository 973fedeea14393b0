// SPDX-License-Identifier: Apache-2.0
#include "solids/shape.h"

namespace sundog::solids {

void refuse_shape(const SourceLocation& where, const std::string& message, const std::string& hint) {
    throw InputError({Severity::error, where, message, "", hint});
}

}  // namespace sundog::solids
