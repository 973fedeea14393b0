// SPDX-License-Identifier: Apache-2.0
// Exact shapes and what constructive solid geometry makes of them, as written.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "base/diagnostics.h"
#include "base/vec3d.h"
#include "scene/function.h"

namespace sundog::scene {

struct SolidSphere {
    Vec3d center;
    double radius = 1;
};
struct SolidBox {
    Vec3d lower, upper;
};
/// A cone's frustum; a cylinder where the radii are equal.
struct SolidCone {
    Vec3d base, cap;
    double base_radius = 1, cap_radius = 0;
    bool open = false;  ///< Without its end discs: a surface, not a solid.
};
/// Inside: dot(normal, p) < distance, unit normal.
struct HalfSpace {
    Vec3d normal{0, 1, 0};
    double distance = 0;
};
/// Around the y axis.
struct Torus {
    double major_radius = 1, minor_radius = 0.25;
};
/// Sum over the coefficients of order 2 to 35, in POV-Ray's order of `poly`: inside where the sum is under 0.
struct Polynomial {
    struct Term {
        std::uint8_t x = 0, y = 0, z = 0;  ///< Exponents.
        double coefficient = 0;
    };
    int order = 2;
    std::vector<Term> terms;  ///< None with a coefficient of 0.
};
struct Superellipsoid {
    double east_west = 1, north_south = 1;  ///< e and n
};
struct BlobComponent {
    bool is_cylinder = false;
    Vec3d center, end;  ///< A cylinder's axis goes from center to end; hemispheres close it.
    double radius = 1, strength = 1;
    Affine3d blob_from_component;  ///< Component's own transforms.
    std::uint32_t material =
        0xffffffffU;  ///< Solid::kInherited: the blob's. Else it shows where this component is strongest.
};
struct Blob {
    double threshold = 1;
    std::vector<BlobComponent> components;
};
/// A spline through 2D points, as lathe, prism and sor take them.
enum class SplineKind : std::uint8_t { linear, quadratic, cubic, bezier };
struct Lathe {
    SplineKind spline = SplineKind::linear;
    std::vector<std::array<double, 2>> points;
};
struct SurfaceOfRevolution {
    std::vector<std::array<double, 2>> points;
    bool open = false;
};
struct Prism {
    SplineKind spline = SplineKind::linear;
    bool conic = false;
    double lower = 0, upper = 1;
    std::vector<std::array<double, 2>> points;
    bool open = false;
};
struct SphereSweep {
    enum class Kind : std::uint8_t { linear, b_spline, cubic } kind = Kind::linear;
    struct Point {
        Vec3d center;
        double radius = 1;
    };
    std::vector<Point> points;
    double tolerance = 1e-6;
};
/// In the unit cube, y up, heights row by row from z = 1 (an image's first row) down to 0.
struct HeightField {
    std::uint32_t width = 0, height = 0;
    std::shared_ptr<const std::vector<float>> heights;  ///< 0..1
    bool smooth = false;
    double water_level = 0;
};
struct Disc {
    Vec3d center, normal{0, 1, 0};
    double radius = 1, hole_radius = 0;
};
/// Flat, in one plane; several closed outlines, filled by the even-odd rule.
struct FlatPolygon {
    std::vector<std::vector<Vec3d>> outlines;
};
/// Triangles shared by all objects that place them.
struct SolidMesh {
    struct Triangle {
        std::array<std::uint32_t, 3> position, normal, uv;  ///< kNoIndex in all three normals or uvs: none.
        std::uint32_t material = kNoIndex;                  ///< Into Scene::materials; kNoIndex: the object's own.
    };
    static constexpr std::uint32_t kNoIndex = 0xffffffffU;
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> uvs;
    std::vector<Triangle> triangles;
    bool has_inside = false;  ///< inside_vector was given.
    Vec3d inside_vector;
};

/// Inside: within the container, where the function of x, y, z is below the threshold.
struct Isosurface {
    std::shared_ptr<const Function> function;  ///< 3 inputs, 1 output.
    double threshold = 0;
    bool in_sphere = false;
    Vec3d center;  ///< Of a sphere.
    double radius = 1;
    Vec3d lower{-1, -1, -1}, upper{1, 1, 1};  ///< Of a box.
    bool open = false;                        ///< Without the container's surface.
};

/// A slice of a Julia set of numbers of four parts (POV-Ray's reference, section 3.4.5.1.7).
struct JuliaFractal {
    enum class Function : std::uint8_t {
        sqr,
        cube,
        exp,
        reciprocal,
        sin,
        asin,
        sinh,
        asinh,
        cos,
        acos,
        cosh,
        acosh,
        tan,
        atan,
        tanh,
        atanh,
        ln,
        pwr,
    };
    std::array<double, 4> parameter{};
    bool hypercomplex = false;  ///< Else quaternions.
    Function function = Function::sqr;
    std::array<double, 2> exponent{};  ///< pwr's, real and imaginary.
    int max_iteration = 20;
    double precision = 20;
    std::array<double, 4> slice{0, 0, 0, 1};
    double distance = 0;
};

/// An egg on the y axis: a sphere around the origin, one around its top, and an arc between.
struct Ovus {
    double bottom_radius = 1, top_radius = 1;
};

/// An arc of radius `inner_radius` turned about the way between two discs (POV-Ray 3.8).
struct Lemon {
    Vec3d base, apex{0, 1, 0};
    double base_radius = 0, apex_radius = 0, inner_radius = 1;
    bool open = false;
};

/// x, y and z as functions of u and v, as far as the container goes. A mere surface.
struct Parametric {
    std::shared_ptr<const Function> function;     ///< 3 inputs (u, v, 0), 3 outputs.
    std::array<double, 2> first{}, last{{1, 1}};  ///< u and v.
    bool in_sphere = false;
    Vec3d center;  ///< Of a sphere.
    double radius = 1;
    Vec3d lower{-1, -1, -1}, upper{1, 1, 1};  ///< Of a box.
};

struct Solid;

/// Children joined: `combined` keeps inner surfaces (union), `merged` loses them, `common` is the intersection. A
/// difference is an intersection whose later children are inverted.
struct SolidGroup {
    enum class Kind : std::uint8_t { combined, merged, common } kind = Kind::combined;
    std::vector<std::shared_ptr<const Solid>> children;
};

/// A shape or a group, placed. Materials are indices into Scene::materials; kInherited means "the parent's".
struct Solid {
    static constexpr std::uint32_t kInherited = 0xffffffffU;
    SourceLocation where;
    std::variant<SolidSphere, SolidBox, SolidCone, HalfSpace, Torus, Polynomial, Superellipsoid, Blob, Lathe,
                 SurfaceOfRevolution, Prism, SphereSweep, HeightField, Disc, FlatPolygon, Isosurface, JuliaFractal,
                 Ovus, Lemon, Parametric, std::shared_ptr<const SolidMesh>, SolidGroup>
        shape;
    Affine3d parent_from_shape;  ///< Groups: applies to all children, after their own.
    bool inverted = false;
    std::uint32_t material = kInherited;
    std::uint32_t interior_material = kInherited;  ///< interior_texture: seen from inside.
    std::vector<std::shared_ptr<const Solid>>
        clipped_by;  ///< Only what lies inside all of them is there. Parent's space.
    /// Of a shape that has no end by itself: rays that pass by these don't meet it (the renderer may take boxes around
    /// them). Parent's space.
    std::vector<std::shared_ptr<const Solid>> bounded_by;
    bool cutaway_textures = false;
};

}  // namespace sundog::scene
