// SPDX-License-Identifier: Apache-2.0
// A solid as what patterns ask whether points are inside.
#pragma once

#include <memory>

#include "scene/pattern.h"
#include "solids/compiled_solid.h"

namespace sundog::pov {

class SolidTest final : public scene::InsideTest {
public:
    explicit SolidTest(std::shared_ptr<const solids::CompiledSolid> solid) : solid_(std::move(solid)) {}
    [[nodiscard]] bool inside(Vec3d point) const override { return solid_->inside(point); }

private:
    std::shared_ptr<const solids::CompiledSolid> solid_;
};

}  // namespace sundog::pov
