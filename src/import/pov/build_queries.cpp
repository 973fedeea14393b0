// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_queries.h"

#include <algorithm>

#include "import/pov/build_pigment.h"
#include "import/pov/solid_test.h"

namespace sundog::pov {

std::shared_ptr<const scene::InsideTest> ObjectQueries::inside_test(const std::shared_ptr<const Block>& object) {
    auto solid = compiled(object);
    return solid ? std::make_shared<const SolidTest>(std::move(solid)) : nullptr;
}

std::shared_ptr<const solids::CompiledSolid> ObjectQueries::compiled(const std::shared_ptr<const Block>& object) {
    const auto known = compiled_.find(object);
    if (known != compiled_.end()) return known->second;
    if (!is_object(object->keyword))
        context_.fail(object->where, std::string(spelling(object->keyword)) + " { } is no object",
                      "trace(), inside() and the extents take objects");
    std::shared_ptr<const solids::CompiledSolid> result;
    if (const auto solid = writer_.solid_of(objects_.read(*object)))
        result = solids::compile_solid(*solid, 0, scratch_.textures);
    compiled_.emplace(object, result);
    return result;
}

bool ObjectQueries::trace(const std::shared_ptr<const Block>& object, Vec3d origin, Vec3d direction, Hit& hit) {
    const auto solid = compiled(object);
    if (!solid || length(direction) == 0) return false;
    const solids::Ray ray{origin, normalize(direction)};
    const std::optional<solids::Hit> nearest = solid->nearest(ray, {0, solids::kInfinity});
    if (!nearest) return false;
    hit.point = ray.origin + ray.direction * nearest->t;
    hit.normal = nearest->normal;
    return true;
}

bool ObjectQueries::inside(const std::shared_ptr<const Block>& object, Vec3d point) {
    const auto solid = compiled(object);
    return solid && solid->inside(point);
}

Bounds3d ObjectQueries::extent(const std::shared_ptr<const Block>& object) {
    if (object->keyword == Keyword::pigment) {
        const scene::Pigment pigment = read_pigment(context_, *object, {});
        if (pigment.kind != scene::Pigment::Kind::image) return {{0, 0, 0}, {0, 0, 0}};
        const scene::Texture& texture = scratch_.textures.at(pigment.image.texture);
        return {{0, 0, 0}, {static_cast<double>(texture.width), static_cast<double>(texture.height), 0}};
    }
    // What POV-Ray tells of objects without end, so that scenes can calculate with it.
    constexpr double kHuge = 1e10;
    const auto solid = compiled(object);
    if (!solid || solid->bounds().empty()) return {{0, 0, 0}, {0, 0, 0}};
    Bounds3d bounds = solid->bounds();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bounds.lower[axis] = std::max(bounds.lower[axis], -kHuge);
        bounds.upper[axis] = std::min(bounds.upper[axis], kHuge);
    }
    return bounds;
}

}  // namespace sundog::pov
