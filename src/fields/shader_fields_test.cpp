// SPDX-License-Identifier: Apache-2.0
// What shaders compute of fields, warps and normals by the words in programs, against what the host says.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "fields/function_builder.h"
#include "fields/function_words.h"
#include "fields/host_fields.h"
#include "fields/internal_functions.h"
#include "fields/pavement.h"
#include "fields/pigment_code.h"
#include "fields/shader_words.h"
#include "kernel/patterns/shader_fields.h"
#include "kernel/patterns/shader_normals.h"
#include "kernel/patterns/shader_warps.h"

namespace sundog::fields {
namespace {

using scene::Pattern;
using scene::Warp;

kernel::vec3 to_single(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
Vec3d to_double(kernel::vec3 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// A point of a sequence that fills the cube from -reach to reach, as single precision has it.
Vec3d place(int k, double reach) {
    const auto part = [&](double step) { return (2 * (step * k - std::floor(step * k)) - 1) * reach; };
    return to_double(to_single({part(0.8191725134), part(0.6710436067), part(0.5497004779)}));
}
/// Unit vectors in all directions.
Vec3d direction(int k) { return to_double(to_single(normalize(place(k, 1) + Vec3d{1e-3, 0, 0}))); }

/// One of a pattern's values by both.
struct Both {
    double host, shader;
};
class BothWays {
public:
    explicit BothWays(const Pattern& pattern) : host_(make_host_field(pattern, {})), shader_(*shader_field(pattern)) {
        view_.code = shader_.words.data();
    }
    [[nodiscard]] Both at(Vec3d p, Vec3d normal = {}, Vec3d towards = {}) const {
        kernel::PatternPoint point{};
        point.position = point.world = to_single(p);
        point.normal = to_single(normal), point.direction = to_single(towards);
        return {
            host_->at({p, normal, towards, p}).x,
            static_cast<double>(kernel::shader_field_value(view_, shader_.kind, 0, point.position, point)),
        };
    }

private:
    std::unique_ptr<HostField> host_;
    ShaderField shader_;
    kernel::SceneView view_{};
};

/// The share of places (in the cube up to `reach`) at which both aren't near to each other: by `tolerance`, and as much
/// of values above 1.
double share_apart(const Pattern& pattern, double reach, double tolerance) {
    const BothWays both(pattern);
    constexpr int kPlaces = 3000;
    int apart = 0;
    for (int k = 0; k < kPlaces; ++k) {
        const Both values = both.at(place(k, reach), direction(k), direction(k + 1));
        if (!(std::abs(values.host - values.shader) <= tolerance * (1 + std::abs(values.host)))) ++apart;
    }
    return static_cast<double>(apart) / kPlaces;
}

// Catches cosines taken for angles, ranges and altitudes that are read from the wrong words or divide by 0, points to
// face that aren't told from directions.
TEST(ShaderFields, SlopesAreTheHosts) {
    Pattern pattern;
    pattern.kind = Pattern::Kind::slope;
    pattern.slope.direction = {0, 2, 1};
    EXPECT_EQ(share_apart(pattern, 4, 1e-5), 0);
    pattern.slope.low = 0.25, pattern.slope.high = 0.7;
    EXPECT_EQ(share_apart(pattern, 4, 1e-5), 0);
    pattern.slope.altitude = {0, 3, 1}, pattern.slope.low_altitude = -1, pattern.slope.high_altitude = 2.5;
    EXPECT_EQ(share_apart(pattern, 4, 1e-5), 0);
    pattern.slope.high = 0.25, pattern.slope.high_altitude = -1;
    EXPECT_EQ(share_apart(pattern, 4, 1e-5), 0);
    pattern.slope.toward_point = true;
    EXPECT_EQ(share_apart(pattern, 4, 1e-5), 0);
    pattern.kind = Pattern::Kind::aoi;
    EXPECT_EQ(share_apart(pattern, 4, 1e-5), 0);
    EXPECT_EQ(BothWays(pattern).at({1, 2, 3}).shader, 0) << "off surfaces";
}

// Catches cells that are shifted and control values in the other order.
TEST(ShaderFields, QuiltsAreTheHosts) {
    Pattern pattern;
    pattern.kind = Pattern::Kind::quilted;
    pattern.control0 = 0.3, pattern.control1 = 0.8;
    EXPECT_EQ(share_apart(pattern, 4, 1e-5), 0);
}

// Catches borders that are packed otherwise than they are read, corners of other cells, and forms that are mixed up:
// for each arrangement and each form of borders. Next to lines where a value jumps, rounding may decide.
TEST(ShaderFields, PavementsAreTheHosts) {
    Pattern pattern;
    pattern.kind = Pattern::Kind::pavement;
    for (const int sides : {3, 4, 6}) {
        for (int tiles = 1; tiles <= 6; ++tiles) {
            for (int number = 1; number <= arrangement_count(sides, tiles); ++number) {
                for (int form = 0; form < 4; ++form) {
                    pattern.pavement = {sides, tiles, number, form % 3, (form + number) % 3, form};
                    EXPECT_LT(share_apart(pattern, 30, 1e-4), 2e-3)
                        << sides << ' ' << tiles << ' ' << number << ' ' << form;
                }
            }
        }
    }
}

// Catches orbits that begin elsewhere, powers and magnets that are mixed up, and types of the inside taken for the
// outside's. Chaos lets points near the border fall either way.
TEST(ShaderFields, FractalsAreTheHosts) {
    using Formula = scene::FractalForm::Formula;
    Pattern pattern;
    pattern.kind = Pattern::Kind::fractal;
    for (const Formula formula : {Formula::power, Formula::magnet1, Formula::magnet2}) {
        for (const bool julia : {false, true}) {
            for (int type = 0; type <= 8; ++type) {
                scene::FractalForm& form = pattern.fractal;
                form.formula = formula, form.julia = julia, form.c = {0.353, 0.288};
                form.iterations = 20, form.exponent = 2 + type % 3;
                form.exterior_type = type, form.interior_type = (type + 2) % 7;
                form.exterior_factor = type >= 7 ? 5 : 0.3, form.interior_factor = 0.7;
                EXPECT_LT(share_apart(pattern, 1.5, 1e-3), 0.02)
                    << static_cast<int>(formula) << ' ' << julia << ' ' << type;
            }
        }
    }
}

/// Whether words of a warp move all points as the host does, but for a few next to where they jump.
void expect_same_warp(const Warp& warp, const std::string& name) {
    const auto host = make_host_warp(warp);
    const ShaderWarp shader = shader_warp(warp);
    kernel::SceneView view{};
    view.code = shader.words.data();
    int apart = 0;
    constexpr int kPlaces = 3000;
    for (int k = 0; k < kPlaces; ++k) {
        const Vec3d p = k == 0 ? Vec3d{} : place(k, 3);
        const Vec3d wanted = host->at({p, {}, {}, p});
        const Vec3d found = to_double(kernel::shader_warped_point(view, shader.op, 0, to_single(p)));
        if (!(length(found - wanted) < 2e-5 * (1 + length(wanted)))) ++apart;
    }
    EXPECT_LE(apart, 3) << name;
}

// Catches copies along the wrong axis, mirrored where they shouldn't be, and widths below 0.
TEST(ShaderFields, RepeatsAreTheHosts) {
    Warp warp;
    warp.kind = Warp::Kind::repeat;
    expect_same_warp(warp, "no width");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double width : {0.7, -0.4}) {
            for (const Vec3d flip : {Vec3d{}, {1, 0, 1}, {0, 1, 1}}) {
                warp.repeat = {}, warp.repeat[axis] = width, warp.flip = flip, warp.offset = {0.1, 0.2, 0.3};
                expect_same_warp(warp, "axis " + std::to_string(axis));
            }
        }
    }
}

// Catches holes that push where they pull, blocks along an axis that doesn't repeat, and other random places.
TEST(ShaderFields, BlackHolesAreTheHosts) {
    Warp warp;
    warp.kind = Warp::Kind::black_hole;
    warp.center = {0.2, 0.1, 0.5}, warp.radius = 1.7, warp.strength = 2, warp.falloff = 1.5;
    expect_same_warp(warp, "one");
    warp.inverse = true;
    expect_same_warp(warp, "inverse");
    warp.radius = 0.5, warp.repeat = {1.5, 0, 1.2};
    expect_same_warp(warp, "repeated");
    warp.inverse = false, warp.turbulence = {0.3, 0.2, 0.4};
    expect_same_warp(warp, "stray");
}

// Catches swapped angles, distances without their exponent, and orientations that turn another way.
TEST(ShaderFields, MappingsAreTheHosts) {
    Warp warp;
    warp.distance = 0.3, warp.major_radius = 0.8;
    for (const Warp::Kind kind : {Warp::Kind::planar, Warp::Kind::cylindrical, Warp::Kind::spherical,
                                  Warp::Kind::toroidal, Warp::Kind::cubic}) {
        for (const Vec3d orientation : {Vec3d{0, 0, 1}, {0, 1, 0}, {1, 2, 3}}) {
            for (const double exponent : {0.0, 1.0, 1.7}) {
                warp.kind = kind, warp.orientation = orientation, warp.distance_exponent = exponent;
                expect_same_warp(warp, "mapping " + std::to_string(static_cast<int>(kind)));
            }
        }
    }
}

// Catches facets of other cells, and sizes taken for coords.
TEST(ShaderFields, NormalsAreTheHosts) {
    Pattern quilted;
    quilted.kind = Pattern::Kind::quilted, quilted.control0 = 0.3, quilted.control1 = 0.8;
    Pattern coords;
    coords.kind = Pattern::Kind::facets, coords.facet_coords = 0.5;
    Pattern sized = coords;
    sized.facet_coords = 0, sized.facet_size = 0.3;
    int apart = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3d p = place(k, 2), n = direction(k);
        const FieldPoint point{p, n, {}, p};
        const auto check = [&](const Pattern& pattern, kernel::vec3 found) {
            if (length(make_host_normal(pattern)->at(point) - to_double(found)) > 1e-5) ++apart;
        };
        check(quilted, kernel::quilted_offset(to_single(p), 0.3F, 0.8F));
        check(coords, kernel::facets_offset(to_single(p), to_single(n), 0.5F, 0));
        check(sized, kernel::facets_offset(to_single(p), to_single(n), 0, 0.3F));
    }
    EXPECT_LE(apart, 3);
}

Pattern function_pattern(const FunctionBuilder& builder, Number output) {
    Pattern pattern;
    pattern.kind = Pattern::Kind::function;
    pattern.function = std::make_shared<const scene::Function>(builder.finish(std::array{output}));
    return pattern;
}

// Catches operations that mean something else in shaders, or take their operands in another order.
TEST(ShaderFields, OperationsOfFunctionsAreTheHosts) {
    using Op = scene::FunctionOp;
    for (const Op op :
         {Op::negate, Op::absolute, Op::square, Op::square_root, Op::exponential, Op::logarithm, Op::sine, Op::cosine,
          Op::tangent, Op::arc_sine, Op::arc_cosine, Op::arc_tangent, Op::hyperbolic_sine, Op::hyperbolic_cosine,
          Op::hyperbolic_tangent, Op::floor, Op::ceiling, Op::truncate, Op::logical_not}) {
        FunctionBuilder builder(3);
        const Pattern pattern = function_pattern(builder, builder.unary(op, builder.input(0)));
        // What a tangent has behind its point is of few digits near its poles.
        EXPECT_LT(share_apart(pattern, 3, 1e-4), op == Op::tangent ? 0.03 : 2e-3)
            << "operation " << static_cast<int>(op);
    }
    for (const Op op :
         {Op::add, Op::subtract, Op::multiply, Op::divide, Op::minimum, Op::maximum, Op::power, Op::arc_tangent2,
          Op::modulo, Op::truncated_quotient, Op::less, Op::less_equal, Op::equal, Op::logical_and, Op::logical_or}) {
        for (const bool whole : {false, true}) {  // exponents, say
            FunctionBuilder builder(3);
            const Number b = whole ? floor(builder.input(1)) : builder.input(1);
            const Pattern pattern = function_pattern(builder, builder.binary(op, builder.input(0), b));
            EXPECT_LT(share_apart(pattern, 3, 1e-4), op == Op::power ? 0.015 : 5e-3)
                << "operation " << static_cast<int>(op);
        }
    }
    FunctionBuilder builder(3);
    const Number x = builder.input(0), y = builder.input(1), z = builder.input(2);
    EXPECT_EQ(share_apart(function_pattern(builder, builder.select_negative(x, y, z)), 3, 1e-6), 0);
    EXPECT_EQ(share_apart(function_pattern(builder, builder.select_zero(floor(x), y, z)), 3, 1e-6), 0);
    for (const std::uint32_t generator : {1U, 2U, 3U})
        EXPECT_EQ(share_apart(function_pattern(builder, builder.noise(x, y, z, generator)), 3, 1e-4), 0);
}

// Catches registers that are used again while their values are needed, constants that are taken for registers, and
// functions beyond the registers or with operations that shaders don't know, which must be the host's alone.
TEST(ShaderFields, LongFunctionsAreTheHosts) {
    FunctionBuilder builder(3);
    const Number x = builder.input(0), y = builder.input(1), z = builder.input(2);
    std::vector<Number> kept;
    for (int i = 0; i < 20; ++i) kept.push_back(sin(x * (0.1 * i + 0.3) + y) * cos(z + 0.7 * i));
    Number sum = x;
    for (const Number& n : kept) sum = sum * 0.3 + n / 7;
    for (const Number& n : kept) sum = sum + n * 0.011;
    const Pattern pattern = function_pattern(builder, sum);
    ASSERT_TRUE(shader_field(pattern).has_value());
    EXPECT_LT(share_apart(pattern, 3, 1e-4), 2e-3);
    EXPECT_EQ(shader_field(pattern)->fields, 1U << kernel::FIELD_FUNCTION | 1U << kernel::FIELD_FUNCTION_ANGLES);
    for (int i = 0; i < 20; ++i) kept.push_back(sin(x * (0.1 * i + 5.3) + y));
    sum = x;
    for (const Number& n : kept) sum = sum * 0.3 + n / 7;
    for (const Number& n : kept) sum = sum + n * 0.011;
    EXPECT_FALSE(shader_field(function_pattern(builder, sum)).has_value());
    const Number counter = builder.begin_loop(x, y);
    const Number looped = builder.end_loop(counter, counter * z, false);
    EXPECT_FALSE(shader_field(function_pattern(builder, looped)).has_value());
    EXPECT_TRUE(shader_field(function_pattern(builder, x)).has_value());
    EXPECT_EQ(share_apart(function_pattern(builder, x), 0.9, 1e-6), 0);
    EXPECT_EQ(share_apart(function_pattern(builder, builder.constant(0.25)), 0.9, 1e-6), 0);
}

// Catches programs that say that only the host can run them, or don't say which code shaders need for them.
TEST(ShaderFields, ProgramsTellWhatShadersNeed) {
    scene::Pigment pigment;
    pigment.kind = scene::Pigment::Kind::mapped;
    pigment.pattern.kind = Pattern::Kind::quilted;
    pigment.entries = {{0, {0, 0, 0, 0, 0}, nullptr}, {1, {1, 1, 1, 0, 0}, nullptr}};
    Warp warp;
    warp.kind = Warp::Kind::toroidal;
    pigment.pattern.bend(warp);
    std::vector<std::uint32_t> code;
    HostFieldTable host({});
    ShaderPrograms programs;
    write_pigment_code(pigment, code, host, nullptr, &programs);
    EXPECT_FALSE(host.first_where().has_value());
    EXPECT_EQ(programs.fields, 1U << kernel::FIELD_QUILTED);
    EXPECT_NE(programs.ops & 1U << kernel::OP_MAPPING, 0U);
    EXPECT_EQ(programs.ops & 1U << kernel::OP_REPEAT, 0U);
    pigment.pattern.kind = Pattern::Kind::object;
    write_pigment_code(pigment, code, host, nullptr, &programs);
    EXPECT_TRUE(host.first_where().has_value()) << "only the host can run it";
}

}  // namespace
}  // namespace sundog::fields
