// SPDX-License-Identifier: Apache-2.0
#include "import/pov/transform_block.h"

#include "import/pov/values.h"

namespace sundog::pov {
namespace {

Vec3d vec(const Value& value) {
    const Value v = promoted(value, 3);
    return {v.v[0], v.v[1], v.v[2]};
}

Vec3d turned(Vec3d axis, const Value& degrees) {
    const Value v = rotated(vector_value(axis.x, axis.y, axis.z), degrees);
    return {v.v[0], v.v[1], v.v[2]};
}

}  // namespace

Affine3d transform_of(const Block& block) {
    Affine3d all;
    bool inverted = false;
    for (std::size_t i = 0; i < block.items.size(); ++i) {
        const Item& item = block.items[i];
        if (const auto* inner = std::get_if<std::shared_ptr<const Block>>(&item.content)) {
            all = transform_of(**inner) * all;
            continue;
        }
        const auto* keyword = std::get_if<Keyword>(&item.content);
        if (keyword == nullptr) continue;
        inverted = inverted || *keyword == Keyword::inverse;
        const auto value_at = [&](std::size_t k) {
            const auto* value = k < block.items.size() ? std::get_if<Value>(&block.items[k].content) : nullptr;
            return value == nullptr ? Value{} : *value;
        };
        const Value operand = value_at(i + 1);
        Affine3d step;
        if (*keyword == Keyword::translate) {
            step.t = vec(operand);
        } else if (*keyword == Keyword::scale) {
            // POV-Ray takes a scale of 0 for 1.
            const Vec3d s = vec(operand);
            step.x.x = s.x == 0 ? 1 : s.x;
            step.y.y = s.y == 0 ? 1 : s.y;
            step.z.z = s.z == 0 ? 1 : s.z;
        } else if (*keyword == Keyword::rotate) {
            step.x = turned({1, 0, 0}, operand);
            step.y = turned({0, 1, 0}, operand);
            step.z = turned({0, 0, 1}, operand);
        } else if (*keyword == Keyword::matrix) {
            const auto row = [&](std::size_t k) {
                return Vec3d{value_at(i + 1 + k).v[0], value_at(i + 2 + k).v[0], value_at(i + 3 + k).v[0]};
            };
            step = {row(0), row(3), row(6), row(9)};
        } else {
            continue;
        }
        all = step * all;
    }
    return inverted && determinant(all) != 0 ? inverse(all) : all;
}

}  // namespace sundog::pov
