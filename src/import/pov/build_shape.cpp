// SPDX-License-Identifier: Apache-2.0
// Shapes that take a few numbers, and groups.
#include "import/pov/build_shape.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sundog::pov {
namespace {

NodeShape left_out(ItemReader& items, const std::string& why) {
    items.warn(why + "; left out");
    return {};
}

NodeShape read_sphere(ItemReader& items) {
    scene::SolidSphere sphere;
    sphere.center = items.vector("the center of the sphere");
    sphere.radius = std::abs(items.number("the radius of the sphere"));
    if (sphere.radius == 0) return left_out(items, "a sphere of no radius");
    return sphere;
}

NodeShape read_box(ItemReader& items) {
    const Vec3d a = items.vector("a corner of the box");
    const Vec3d b = items.vector("the opposite corner of the box");
    scene::SolidBox box;
    for (std::size_t axis = 0; axis < 3; ++axis)
        box.lower[axis] = std::min(a[axis], b[axis]), box.upper[axis] = std::max(a[axis], b[axis]);
    return box;
}

NodeShape read_cone(ItemReader& items) {
    scene::SolidCone cone;
    cone.base = items.vector("the base of the cone");
    cone.base_radius = std::abs(items.number("the radius at the base"));
    cone.cap = items.vector("the cap of the cone");
    cone.cap_radius = std::abs(items.number("the radius at the cap"));
    cone.open = items.take(Keyword::open);
    if (cone.base == cone.cap) return left_out(items, "a cone of no length");
    return cone;
}

NodeShape read_cylinder(ItemReader& items) {
    scene::SolidCone cone;
    cone.base = items.vector("the base of the cylinder");
    cone.cap = items.vector("the cap of the cylinder");
    cone.base_radius = std::abs(items.number("the radius of the cylinder"));
    cone.cap_radius = cone.base_radius;
    cone.open = items.take(Keyword::open);
    if (cone.base == cone.cap) return left_out(items, "a cylinder of no length");
    return cone;
}

NodeShape read_plane(ItemReader& items) {
    const Vec3d normal = items.vector("the normal of the plane");
    const double distance = items.number("the distance of the plane");
    if (length(normal) == 0) return left_out(items, "a plane whose normal has no direction");
    return scene::HalfSpace{normalize(normal), distance};
}

NodeShape read_torus(ItemReader& items) {
    scene::Torus torus;
    torus.major_radius = items.number("the major radius of the torus");
    torus.minor_radius = items.number("the minor radius of the torus");
    if (torus.minor_radius == 0) return left_out(items, "a torus of no minor radius");
    return torus;
}

NodeShape read_superellipsoid(ItemReader& items) {
    const std::array<double, 2> en = items.vector2("the exponents e and n");
    if (!(en[0] > 0 && en[1] > 0)) items.fail("an exponent that is not positive", "expected two positive numbers");
    return scene::Superellipsoid{en[0], en[1]};
}

NodeShape read_disc(ItemReader& items) {
    scene::Disc disc;
    disc.center = items.vector("the center of the disc");
    disc.normal = normalize(items.vector("the normal of the disc"));
    disc.radius = items.number("the radius of the disc");
    disc.hole_radius = items.maybe_number().value_or(0);
    if (length(disc.normal) == 0) return left_out(items, "a disc whose normal has no direction");
    return disc;
}

NodeShape read_group(ObjectReader& objects, ItemReader& items, Keyword keyword) {
    using Kind = scene::SolidGroup::Kind;
    NodeGroup group;
    group.kind = keyword == Keyword::union_ ? Kind::combined : keyword == Keyword::merge ? Kind::merged : Kind::common;
    group.children = read_children(objects, items);
    if (keyword == Keyword::difference) {
        for (std::size_t i = 1; i < group.children.size(); ++i) {
            auto removed = std::make_shared<Node>(*group.children[i]);
            removed->inverted = !removed->inverted;
            group.children[i] = std::move(removed);
        }
    }
    if (group.children.empty()) return left_out(items, std::string(spelling(keyword)) + " { } without objects");
    return group;
}

NodeShape not_drawn(ItemReader& items, const Block& block) {
    const std::string name(spelling(block.keyword));
    items.context().warn_once("shape " + name, block.where, name + " { } isn't drawn yet; left out");
    // Its own parameters can't be told from modifiers: none is checked.
    while (!items.at_end()) items.skip();
    return {};
}

}  // namespace

NodeShape read_shape(ObjectReader& objects, ItemReader& items, const Block& block) {
    switch (block.keyword) {
        case Keyword::sphere:
            return read_sphere(items);
        case Keyword::box:
            return read_box(items);
        case Keyword::cone:
            return read_cone(items);
        case Keyword::cylinder:
            return read_cylinder(items);
        case Keyword::plane:
            return read_plane(items);
        case Keyword::torus:
            return read_torus(items);
        case Keyword::superellipsoid:
            return read_superellipsoid(items);
        case Keyword::disc:
            return read_disc(items);
        case Keyword::quadric:
            return read_quadric(items);
        case Keyword::poly:
        case Keyword::cubic:
        case Keyword::quartic:
            return read_polynomial(items, block.keyword);
        case Keyword::blob:
            return read_blob(objects, items);
        case Keyword::lathe:
            return read_lathe(items);
        case Keyword::sor:
            return read_surface_of_revolution(items);
        case Keyword::prism:
            return read_prism(items);
        case Keyword::sphere_sweep:
            return read_sphere_sweep(items);
        case Keyword::polygon:
            return read_polygon(items);
        case Keyword::isosurface:
            return read_isosurface(items);
        case Keyword::julia_fractal:
            return read_julia_fractal(items);
        case Keyword::ovus:
            return read_ovus(items);
        case Keyword::lemon:
            return read_lemon(items);
        case Keyword::parametric:
            return read_parametric(items);
        case Keyword::height_field:
            return read_height_field(objects, items);
        case Keyword::text:
            return read_text(items);
        case Keyword::bicubic_patch:
            return read_bicubic_patch(items);
        case Keyword::triangle:
        case Keyword::smooth_triangle:
            return read_triangle(objects, items, block.keyword);
        case Keyword::mesh:
            return read_mesh(objects, items);
        case Keyword::mesh2:
            return read_mesh2(objects, items);
        case Keyword::light_source:
            return read_light_source(objects, items);
        case Keyword::light_group:
            return read_group(objects, items, Keyword::union_);
        case Keyword::union_:
        case Keyword::merge:
        case Keyword::intersection:
        case Keyword::difference:
            return read_group(objects, items, block.keyword);
        default:
            return not_drawn(items, block);
    }
}

bool read_shape_item(ItemReader& items, const Block& block, NodeShape& shape) {
    if (auto* isosurface = std::get_if<scene::Isosurface>(&shape))
        if (read_isosurface_item(items, *isosurface)) return true;
    if (auto* parametric = std::get_if<scene::Parametric>(&shape))
        if (read_parametric_item(items, *parametric)) return true;
    if (block.keyword == Keyword::isosurface && std::holds_alternative<std::monostate>(shape)) {
        scene::Isosurface left_out;
        if (read_isosurface_item(items, left_out)) return true;
    }
    if (items.take(Keyword::open)) {
        const bool open = items.flag();
        if (auto* cone = std::get_if<scene::SolidCone>(&shape)) cone->open = open;
        else if (auto* prism = std::get_if<scene::Prism>(&shape)) prism->open = open;
        else if (auto* lemon = std::get_if<scene::Lemon>(&shape)) lemon->open = open;
        else if (auto* sor = std::get_if<scene::SurfaceOfRevolution>(&shape)) sor->open = open;
        return true;
    }
    if (items.take(Keyword::tolerance)) {
        const double tolerance = items.number("a tolerance");
        if (auto* sweep = std::get_if<scene::SphereSweep>(&shape)) sweep->tolerance = tolerance;
        return true;
    }
    if (auto* field = std::get_if<scene::HeightField>(&shape)) {
        if (items.take(Keyword::smooth)) {
            field->smooth = items.flag();
            return true;
        }
        if (items.take(Keyword::water_level)) {
            field->water_level = items.number("a water level from 0 to 1");
            return true;
        }
    }
    if (auto* blob = std::get_if<NodeBlob>(&shape); blob && items.take(Keyword::threshold)) {
        blob->blob.threshold = items.number("a threshold");
        return true;
    }
    return false;
}

}  // namespace sundog::pov
