// SPDX-License-Identifier: Apache-2.0
#include "device/accel/structure.h"

#include <stdexcept>

namespace sundog::accel {

std::unique_ptr<Structure> make_structure(Acceleration which, const Primitives& primitives) {
    if (primitives.size() == 0) return make_no_structure(primitives);
    switch (which) {
        case Acceleration::bvh:
            return make_bvh(primitives);
        case Acceleration::kdtree:
            return make_kd_tree(primitives);
        case Acceleration::octree:
            return make_octree(primitives);
        case Acceleration::grid:
            return make_grid(primitives);
        case Acceleration::boxes:
            return make_object_boxes(primitives);
        case Acceleration::none:
            return make_no_structure(primitives);
        case Acceleration::embree:
            break;
    }
    throw std::invalid_argument("Embree's structure is none of ours");
}

}  // namespace sundog::accel
