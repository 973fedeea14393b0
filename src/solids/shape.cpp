// SPDX-License-Identifier: Apache-2.0
#include "solids/shape.h"

namespace sundog::solids {

bool Shape::stretch(const Ray& ray, Range range, Stretch& out) const {
    CrossingList list;
    const bool starts_inside = crossings(ray, range, list);
    if (!starts_inside && list.empty()) return false;
    out.begins = !starts_inside;
    if (out.begins) out.lower = list[0];
    // The last one ends it: rounding may tear it in two.
    out.ends = (list.size() % 2 == 0) != starts_inside;
    if (out.ends) out.upper = list.back();
    return true;
}

void refuse_shape(const SourceLocation& where, const std::string& message, const std::string& hint) {
    throw InputError({Severity::error, where, message, "", hint});
}

}  // namespace sundog::solids
