// SPDX-License-Identifier: Apache-2.0
// What every exact shape can do, in its own space. Immutable; any number of threads may ask at once.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/solid.h"
#include "solids/bounds.h"
#include "solids/ray.h"
#include "solids/shape_numbers.h"

namespace sundog::solids {

class Shape {
public:
    Shape() = default;
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;
    virtual ~Shape() = default;

    /// Appends where the ray meets the shape within `range`, by ascending t, and returns whether the ray is inside at
    /// range.lower. The range is finite at its lower end.
    virtual bool crossings(const Ray& ray, Range range, CrossingList& out) const = 0;
    /// The same, but only the first visible crossing and those before it must be told.
    virtual bool first_crossing(const Ray& ray, Range range, CrossingList& out) const {
        return crossings(ray, range, out);
    }
    /// Of convex shapes: the stretch of a ray inside; false where nothing of it lies in `range`, whose lower end is
    /// finite. As crossings() would tell.
    virtual bool stretch(const Ray& ray, Range range, Stretch& out) const;
    /// Whether a point is inside; never for mere surfaces.
    [[nodiscard]] virtual bool inside(Vec3d point) const = 0;
    /// Normal at a crossing, of any length; outward, unless the shape can't tell (then the ray's passage decides).
    [[nodiscard]] virtual Vec3d normal(Vec3d point, const Crossing& crossing) const = 0;
    /// Normal of the surface itself, of any length and either side, where normal() is a smoothed one.
    [[nodiscard]] virtual std::optional<Vec3d> face_normal(Vec3d, const Crossing&) const { return std::nullopt; }
    /// A box around the surface and the inside, carried by `m`.
    [[nodiscard]] virtual Bounds3d bounds(const Affine3d& m) const = 0;
    /// A box around the part of the surface and the inside that lies in `box`, in the space that `m` carries to:
    /// smaller than that for shapes without an end that can tell.
    [[nodiscard]] virtual Bounds3d bounds_within(const Affine3d&, const Bounds3d& box) const { return box; }
    /// Boxes around all that is inside, and around all that is not.
    [[nodiscard]] virtual Bounds3d inside_bounds(const Affine3d& m) const { return bounds(m); }
    [[nodiscard]] virtual Bounds3d outside_bounds(const Affine3d&) const { return everywhere(); }
    /// Whether crossings cost next to nothing: asked first, they may tell that other shapes needn't be, or not all
    /// along.
    [[nodiscard]] virtual bool is_quick() const { return false; }
    /// Whether the shape is a convex solid whose whole surface is visible: a ray is in it once.
    [[nodiscard]] virtual bool is_convex() const { return false; }
    /// Texture coordinates as POV-Ray's uv_mapping has them (reference, section 3.4.6.7.1); 0 where it has none.
    [[nodiscard]] virtual std::array<double, 2> uv(Vec3d, const Crossing&) const { return {0, 0}; }
    /// The material of a part with one of its own (a mesh's triangle), into Scene::materials.
    [[nodiscard]] virtual std::uint32_t material(Vec3d, const Crossing&) const { return scene::Solid::kInherited; }
    /// All that material() may give but kInherited.
    [[nodiscard]] virtual std::vector<std::uint32_t> materials() const { return {}; }
    /// All there is to know of the shape; of kind `none` where that is more than numbers tell.
    [[nodiscard]] virtual ShapeNumbers numbers() const { return {}; }
};

using ShapePointer = std::shared_ptr<const Shape>;

/// The shapes, one file each. Errors: InputError naming `where` for what can't be a shape (too few points, …).
ShapePointer make_shape(const scene::SolidSphere& sphere, const SourceLocation& where);
ShapePointer make_shape(const scene::SolidBox& box, const SourceLocation& where);
ShapePointer make_shape(const scene::SolidCone& cone, const SourceLocation& where);
ShapePointer make_shape(const scene::HalfSpace& half_space, const SourceLocation& where);
ShapePointer make_shape(const scene::Torus& torus, const SourceLocation& where);
ShapePointer make_shape(const scene::Polynomial& polynomial, const SourceLocation& where);
ShapePointer make_shape(const scene::Superellipsoid& superellipsoid, const SourceLocation& where);
ShapePointer make_shape(const scene::Blob& blob, const SourceLocation& where);
/// The field of one component of a blob, at points of the blob's space; 0 beyond its radius.
std::function<double(Vec3d)> component_field(const scene::BlobComponent& component);
ShapePointer make_shape(const scene::Lathe& lathe, const SourceLocation& where);
ShapePointer make_shape(const scene::SurfaceOfRevolution& sor, const SourceLocation& where);
ShapePointer make_shape(const scene::Prism& prism, const SourceLocation& where);
ShapePointer make_shape(const scene::SphereSweep& sweep, const SourceLocation& where);
ShapePointer make_shape(const scene::HeightField& field, const SourceLocation& where);
/// `textures` are what images in the function's pigments are taken from.
ShapePointer make_shape(const scene::Isosurface& isosurface, const SourceLocation& where,
                        std::span<const scene::Texture> textures);
ShapePointer make_shape(const scene::JuliaFractal& fractal, const SourceLocation& where);
ShapePointer make_shape(const scene::Ovus& ovus, const SourceLocation& where);
ShapePointer make_shape(const scene::Lemon& lemon, const SourceLocation& where);
ShapePointer make_shape(const scene::Parametric& parametric, const SourceLocation& where,
                        std::span<const scene::Texture> textures);
ShapePointer make_shape(const scene::Disc& disc, const SourceLocation& where);
ShapePointer make_shape(const scene::FlatPolygon& polygon, const SourceLocation& where);
ShapePointer make_shape(const std::shared_ptr<const scene::SolidMesh>& mesh, const SourceLocation& where);

/// For shapes that can't be: an InputError at `where`.
[[noreturn]] void refuse_shape(const SourceLocation& where, const std::string& message, const std::string& hint = "");

}  // namespace sundog::solids
