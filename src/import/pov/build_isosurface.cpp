// SPDX-License-Identifier: Apache-2.0
// Isosurfaces (POV-Ray reference, section 3.4.5.1.7 "Isosurface").
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "import/pov/build_function.h"
#include "import/pov/build_shape.h"
#include "import/pov/function_lowering.h"

namespace sundog::pov {
void read_container(ItemReader& items, const Block& block, scene::Isosurface& isosurface) {
    ItemReader outer(items.context(), block);
    if (const auto sphere = outer.take_block(Keyword::sphere)) {
        ItemReader inner(items.context(), *sphere);
        isosurface.in_sphere = true;
        isosurface.center = inner.vector("the center of the sphere");
        isosurface.radius = std::abs(inner.number("the radius of the sphere"));
    } else if (const auto box = outer.take_block(Keyword::box)) {
        ItemReader inner(items.context(), *box);
        const Vec3d a = inner.vector("a corner of the box");
        const Vec3d b = inner.vector("the opposite corner of the box");
        isosurface.in_sphere = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            isosurface.lower[axis] = std::min(a[axis], b[axis]);
            isosurface.upper[axis] = std::max(a[axis], b[axis]);
        }
    } else {
        outer.unexpected("a box { } or a sphere { } that contains the isosurface");
    }
}

NodeShape read_isosurface(ItemReader& items) {
    scene::Isosurface isosurface;
    std::shared_ptr<const FunctionExpression> function;
    while (!function) {
        function = items.take_function();
        if (!function && !read_isosurface_item(items, isosurface)) items.unexpected("a function of x, y and z");
    }
    if (const FunctionExpression* unknown = unknown_internal_function(*function)) {
        items.warn("an isosurface of internal(" + std::to_string(unknown->internal_number) +
                   "), a function that Sundog doesn't have; left out");
        return {};
    }
    isosurface.function = read_functions(items.context(), std::array{function}, 3);
    return isosurface;
}

bool read_isosurface_item(ItemReader& items, scene::Isosurface& isosurface) {
    if (const auto container = items.take_block(Keyword::contained_by)) {
        read_container(items, *container, isosurface);
    } else if (items.take(Keyword::threshold)) {
        isosurface.threshold = items.number("a threshold");
    } else if (items.take(Keyword::open)) {
        isosurface.open = items.flag();
    } else if (items.take(Keyword::accuracy) || items.take(Keyword::max_gradient) || items.take(Keyword::max_trace)) {
        // How to search: the surface is found without such hints, all of it.
        items.number("a number");
    } else if (items.take(Keyword::evaluate)) {
        while (items.value_follows()) items.skip();
    } else if (!items.take(Keyword::all_intersections)) {
        return false;
    }
    return true;
}

}  // namespace sundog::pov
