// SPDX-License-Identifier: Apache-2.0
// What makes each shape: the items of its block but the object modifiers.
#pragma once

#include <optional>
#include <span>

#include "import/pov/build_items.h"
#include "import/pov/build_node.h"
#include "import/pov/build_object.h"

namespace sundog::pov {

/// Reads what a shape's block begins with. The place of a block that isn't drawn yet is told in a warning, and an
/// empty shape is returned. Errors: InputError.
NodeShape read_shape(ObjectReader& objects, ItemReader& items, const Block& block);

/// Takes a keyword that belongs to the shape and may stand among the object modifiers (open, sturm, threshold, …).
bool read_shape_item(ItemReader& items, const Block& block, NodeShape& shape);

// The readers behind read_shape(), one or a few in each build_*.cpp.
NodeShape read_polynomial(ItemReader& items, Keyword keyword);
NodeShape read_quadric(ItemReader& items);
NodeShape read_blob(ObjectReader& objects, ItemReader& items);
NodeShape read_lathe(ItemReader& items);
NodeShape read_surface_of_revolution(ItemReader& items);
NodeShape read_prism(ItemReader& items);
NodeShape read_sphere_sweep(ItemReader& items);
NodeShape read_polygon(ItemReader& items);
NodeShape read_isosurface(ItemReader& items);
/// Takes one of an isosurface's own items, if one follows.
bool read_isosurface_item(ItemReader& items, scene::Isosurface& isosurface);
NodeShape read_julia_fractal(ItemReader& items);
NodeShape read_ovus(ItemReader& items);
NodeShape read_lemon(ItemReader& items);
NodeShape read_parametric(ItemReader& items);
/// Reads a `contained_by { }`, a box or a sphere, into a shape's in_sphere, center, radius, lower and upper.
void read_container(ItemReader& items, const Block& block, scene::Isosurface& isosurface);
/// Takes one of a parametric surface's own items, if one follows.
bool read_parametric_item(ItemReader& items, scene::Parametric& parametric);
NodeShape read_height_field(ObjectReader& objects, ItemReader& items);
NodeShape read_text(ItemReader& items);
NodeShape read_bicubic_patch(ItemReader& items);
NodeShape read_triangle(ObjectReader& objects, ItemReader& items, Keyword keyword);
NodeShape read_mesh(ObjectReader& objects, ItemReader& items);
NodeShape read_mesh2(ObjectReader& objects, ItemReader& items);
NodeShape read_light_source(ObjectReader& objects, ItemReader& items);

}  // namespace sundog::pov
