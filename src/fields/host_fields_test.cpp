// SPDX-License-Identifier: Apache-2.0
#include "fields/host_fields.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <vector>

#include "fields/fractals.h"
#include "fields/pigment_code.h"
#include "fields/warps.h"
#include "kernel/patterns/density_grid.h"

namespace sundog::fields {
namespace {

using scene::FractalForm;
using scene::Pattern;
using scene::Warp;

double value(const Pattern& pattern, Vec3d p, Vec3d normal = {}, Vec3d direction = {}, Vec3d world = {}) {
    return make_host_field(pattern, {})->at({p, normal, direction, world}).x;
}

void expect_near(Vec3d a, Vec3d b) {
    EXPECT_NEAR(a.x, b.x, 1e-4);
    EXPECT_NEAR(a.y, b.y, 1e-4);
    EXPECT_NEAR(a.z, b.z, 1e-4);
}

// Points asked side by side have the values of each alone, and what is known to stay is what stays. Catches an orbit
// that goes on where its neighbour's has ended, and parts of the set that are taken for too large.
TEST(HostFields, FractalsAreTheSameSideBySide) {
    for (const bool is_magnet : {false, true}) {
        FractalForm form;
        form.formula = is_magnet ? FractalForm::Formula::magnet1 : FractalForm::Formula::power;
        form.iterations = 60;
        FractalForm smallest = form;  // of this the whole orbit is looked at
        smallest.interior_type = 1;
        std::vector<double> x, y;
        for (int i = 0; i < 2000; ++i) x.push_back(-2.2 + 0.0017 * i), y.push_back(1.3 * std::sin(0.7 * i));
        for (const FractalForm& f : {form, smallest}) {
            std::vector<double> values(x.size());
            fractal_values(f, x, y, values);
            for (std::size_t i = 0; i < x.size(); ++i)
                EXPECT_EQ(values[i], fractal_value(f, x[i], y[i])) << x[i] << ' ' << y[i];
        }
        std::vector<double> known(x.size()), followed(x.size());
        fractal_values(form, x, y, known);
        form.interior_type = 4, form.interior_factor = 0;  // looks at all of the orbit, too
        fractal_values(form, x, y, followed);
        for (std::size_t i = 0; i < x.size(); ++i)
            EXPECT_EQ(known[i] == 1, followed[i] == 0 && known[i] != 0) << x[i] << ' ' << y[i];
    }
}

// Values that povray 3.7 prints. Catches iterations counted from one too many, orbits that begin at 0, wrong bailouts.
TEST(HostFields, FractalsAreThoseOfPovray) {
    FractalForm mandel;
    mandel.iterations = 20;
    mandel.interior_type = 1;
    EXPECT_NEAR(fractal_value(mandel, 0.1, 0.2), 0.22361, 1e-5);
    EXPECT_NEAR(fractal_value(mandel, 0.3, 0.6), 0.65, 1e-5);
    EXPECT_NEAR(fractal_value(mandel, 1.2, 0.3), 0, 1e-5);
    mandel.interior_type = 3;
    EXPECT_NEAR(fractal_value(mandel, -0.5, 0.6), 0.58335, 1e-5);
    mandel.interior_type = 2;
    const double x = fractal_value(mandel, -0.5, 0.6);
    mandel.interior_type = 6;
    EXPECT_NEAR(fractal_value(mandel, -0.5, 0.6), x * x + 0.58335 * 0.58335, 1e-5);
    mandel.exterior_type = 6, mandel.exterior_factor = 0.1;
    EXPECT_NEAR(fractal_value(mandel, 0.3, 0.6), 0.34976, 1e-5);
    mandel.exponent = 5, mandel.exterior_type = 1;
    EXPECT_NEAR(fractal_value(mandel, -0.7, 0.3), 0.85, 1e-5);
    FractalForm julia;
    julia.julia = true, julia.c = {0.353, 0.288}, julia.iterations = 30, julia.interior_type = 1;
    EXPECT_NEAR(fractal_value(julia, -0.5, 0.6), 0.16130, 1e-5);
    EXPECT_NEAR(fractal_value(julia, -0.7, 0.3), 0.1, 1e-5);
    FractalForm magnet;
    magnet.formula = FractalForm::Formula::magnet1, magnet.iterations = 30;
    EXPECT_NEAR(fractal_value(magnet, -0.5, 0.6), 0.2, 1e-5);
    magnet.interior_type = 1, magnet.exterior_type = 6, magnet.exterior_factor = 0.01;
    EXPECT_NEAR(fractal_value(magnet, 0.1, 0.2), 0.23288, 1e-4);
    EXPECT_NEAR(fractal_value(magnet, 2.5, 0), 23 * 1.00001 + 0.48841, 1e-4);
    magnet.formula = FractalForm::Formula::magnet2;
    EXPECT_NEAR(fractal_value(magnet, 0.1, 0.2), 0.41686, 1e-5);
}

// Catches mirrored copies that are shifted, offsets applied before the mirror, and holes that pull where they push.
TEST(HostFields, RepeatsAndBlackHolesAreThoseOfPovray) {
    Warp repeat;
    repeat.kind = Warp::Kind::repeat, repeat.repeat = {0.5, 0, 0};
    repeat.flip = {1, 1, 0}, repeat.offset = {0.1, 0.2, 0.3};
    expect_near(warped(repeat, {-0.7, 0.2, 0.9}), {0.1, -0.2, 0.3});
    repeat.flip = {1, 0, 0};
    expect_near(warped(repeat, {0.7, 0.4, 0.5}), {0.4, 0.6, 0.8});
    repeat.repeat = {-0.5, 0, 0}, repeat.flip = {}, repeat.offset = {0, 1, 0};
    expect_near(warped(repeat, {1.3, -0.5, -0.4}), {-0.2, -3.5, -0.4});
    Warp hole;
    hole.kind = Warp::Kind::black_hole, hole.strength = 2;
    expect_near(warped(hole, {0.3, 0.4, 0.5}), {0.3515, 0.4686, 0.5858});
    expect_near(warped(hole, {0.2, 0, 0}), {0.4, 0, 0});
    hole.strength = 1, hole.inverse = true;
    expect_near(warped(hole, {0, 0.6, 0}), {0, 0.504, 0});
    hole.inverse = false, hole.center = {0.5, 0.5, 0.5}, hole.radius = 0.5, hole.repeat = {1, 1, 1};
    expect_near(warped(hole, {1.3, -0.5, -0.4}), {1.2389, -0.5, -0.3694});
}

// Catches swapped angles, seams at the wrong side, and orientations that turn the wrong way.
TEST(HostFields, MappingWarpsAreThoseOfPovray) {
    Warp warp;
    warp.kind = Warp::Kind::spherical;
    expect_near(warped(warp, {1.3, -0.5, -0.4}), {0.9525, 0.3879, 1.4491});
    warp.orientation = {0, 1, 0};
    expect_near(warped(warp, {1.3, -0.5, -0.4}), {0.9525, -1.4491, 0.3879});
    warp.orientation = {1, 0, 0}, warp.distance_exponent = 1, warp.kind = Warp::Kind::cylindrical;
    expect_near(warped(warp, {0.3, 0.4, 0.5}), {0.5831, 0.4, -0.0956});
    warp.orientation = {1, 2, 3}, warp.distance_exponent = 0;
    expect_near(warped(warp, {0.3, 0.4, 0.5}), {0.375, 0.1159, 0.6375});
    warp.orientation = {0, 0, 1}, warp.kind = Warp::Kind::toroidal, warp.major_radius = 0.5;
    expect_near(warped(warp, {-0.7, 0.2, 0.9}), {0.3552, 0.5482, 0.6707});
    warp.kind = Warp::Kind::planar, warp.orientation = {1, 1, 0}, warp.distance = 0.5;
    expect_near(warped(warp, {-0.7, 0.2, 0.9}), {-0.1414, -0.2121, 0.6364});
    warp.kind = Warp::Kind::cubic;
    expect_near(warped(warp, {1.3, -0.5, -0.4}), {0.6635, 0.4359, 1.3});
    expect_near(warped(warp, {0.3, -1, 0.5}), {0.4125, 0.25, 1});
}

// Catches angles that are taken for cosines, ranges that aren't applied, and surfaces seen from the back.
TEST(HostFields, SlopesAreLinearInTheAngle) {
    Pattern slope;
    slope.kind = Pattern::Kind::slope;
    slope.slope.direction = {3, 0, 0};
    EXPECT_NEAR(value(slope, {}, {0, 1, 0}), 0.5, 1e-6);
    EXPECT_NEAR(value(slope, {}, {0.766044443, 0.642787610, 0}), 1 - 40.0 / 180, 1e-6);
    slope.slope.low = 0.25, slope.slope.high = 0.75;
    EXPECT_NEAR(value(slope, {}, {0, 1, 0}), 0.5, 1e-6);
    EXPECT_NEAR(value(slope, {}, {-1, 0, 0}), -0.5, 1e-6);
    slope.slope.altitude = {0, 1, 0}, slope.slope.low_altitude = -1, slope.slope.high_altitude = 3;
    EXPECT_NEAR(value(slope, {5, 1, 5}, {-1, 0, 0}), (3 * -0.5 + 0.5) / 4, 1e-6);
    slope.slope = {};
    slope.slope.toward_point = true, slope.slope.direction = {5, 0, 0};
    EXPECT_NEAR(value(slope, {}, {-1, 0, 0}, {}, {9, 0, 0}), 1, 1e-6);
    Pattern aoi;
    aoi.kind = Pattern::Kind::aoi;
    EXPECT_NEAR(value(aoi, {}, {0, 0, -1}, {0, 0, 1}), 1, 1e-6);
    EXPECT_NEAR(value(aoi, {}, {0, 1, 0}, {0, 0, 1}), 0.5, 1e-6);
}

// Values that povray 3.7 prints of a file with these voxels. Catches axes in another order and grids that are shifted.
TEST(HostFields, DensitiesLieInTheUnitCube) {
    auto grid = std::make_shared<scene::DensityGrid>();
    grid->size = {4, 2, 2};
    for (const int v : {0, 50, 100, 200, 10, 60, 110, 210, 20, 70, 120, 220, 30, 80, 130, 230})
        grid->values.push_back(static_cast<float>(v) / 255);
    Pattern pattern;
    pattern.kind = Pattern::Kind::density_file, pattern.density = grid;
    const auto at = [&](double x, double y, double z) { return value(pattern, {x, y, z}) * 255; };
    EXPECT_NEAR(at(0.3, 0.3, 0.3), 50, 1e-3);
    EXPECT_NEAR(at(0.3, 0.7, 0.3), 60, 1e-3);
    EXPECT_NEAR(at(0.3, 0.3, 0.7), 70, 1e-3);
    EXPECT_EQ(at(1.0, 0.3, 0.3), 0);
    EXPECT_EQ(at(0.3, -0.01, 0.3), 0);
    pattern.interpolation = 1;
    EXPECT_NEAR(at(0.015625, 0.3, 0.3), 21.12, 0.02);
    EXPECT_NEAR(at(0.953125, 0.3, 0.3), 55.5, 0.02);
    pattern.interpolation = 2;
    EXPECT_NEAR(at(0.015625, 0.3, 0.3), 15.70, 0.02);
    EXPECT_NEAR(at(0.3, 0.3, 0.140625), 69.54, 0.02);
}

// Catches voxels in other places of the code than the shaders' function looks for them, in another order or of another
// measure, cubics of other slopes, grids that don't go round, and voxels that are written for each use.
TEST(HostFields, ShadersFindTheSameDensities) {
    auto grid = std::make_shared<scene::DensityGrid>();
    grid->size = {5, 1, 3};
    for (int i = 0; i < 15; ++i) grid->values.push_back(static_cast<float>(i * 7 % 15) / 15);
    std::vector<std::uint32_t> code{0, 0, 0};
    HostFieldTable host({});
    ShaderPrograms programs;
    for (const int interpolation : {0, 1, 2}) {
        scene::Pigment pigment;
        pigment.kind = scene::Pigment::Kind::mapped;
        pigment.pattern.kind = Pattern::Kind::density_file;
        pigment.pattern.density = grid, pigment.pattern.interpolation = interpolation;
        pigment.entries = {{0, {0, 0, 0, 0, 0}, nullptr}, {1, {1, 1, 1, 0, 0}, nullptr}};
        const auto start = static_cast<kernel::uint>(code.size());
        write_pigment_code(pigment, code, host, nullptr, &programs);
        ASSERT_EQ(code[start] & 255U, kernel::OP_DENSITY);
        EXPECT_EQ(code[start + 7], interpolation == 0 ? 8U : 0U) << "words of voxels";
        kernel::SceneView view{};
        view.code = code.data();
        for (int i = 0; i < 500; ++i) {
            const float x = 0.0021F * static_cast<float>(i) - 0.02F, y = 0.37F,
                        z = std::fmod(0.0371F * x * x + 0.013F * static_cast<float>(i), 1.0F);
            const double wanted =
                value(pigment.pattern, {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
            EXPECT_NEAR(kernel::density_at(view, start + 2, kernel::vec3(x, y, z)), wanted, 2e-5) << i;
        }
    }
    EXPECT_TRUE(!host.first_where()) << "only the host can run it";
}

// Values that povray 3.7 prints.
TEST(HostFields, QuiltedCellsAreThoseOfPovray) {
    Pattern quilted;
    quilted.kind = Pattern::Kind::quilted;
    EXPECT_NEAR(value(quilted, {0, 0, 0}), 0.5760, 1e-4);
    EXPECT_NEAR(value(quilted, {0.25, 0, 0}), 0.4736, 1e-4);
    quilted.control0 = 0.3, quilted.control1 = 0.8;
    EXPECT_NEAR(value(quilted, {0.5, 0.4, 0.3}), 0.026056505, 1e-6);
    EXPECT_NEAR(value(quilted, {-0.2, 1.1, 0.3}), 0.201118795, 1e-6);
}

// Catches facets that aren't flat, aren't unit normals, or don't follow their size.
TEST(HostFields, FacetsAreFlat) {
    scene::Pattern pattern;
    pattern.kind = scene::Pattern::Kind::facets;
    const auto facets_of = [&](double size) {
        pattern.facet_size = size;
        const auto facets = make_host_normal(pattern);
        std::set<std::array<long, 3>> normals;
        for (int k = 0; k < 2000; ++k) {
            const double z = 1 - (k + 0.5) / 1000, around = 2.39996323 * k, r = std::sqrt(1 - z * z);
            FieldPoint point;
            point.normal = {r * std::cos(around), r * std::sin(around), z};
            const Vec3d bent = point.normal + facets->at(point);
            EXPECT_NEAR(length(bent), 1, 1e-9);
            EXPECT_GT(dot(bent, point.normal), 0);
            normals.insert({std::lround(bent.x * 1e6), std::lround(bent.y * 1e6), std::lround(bent.z * 1e6)});
        }
        return normals.size();
    };
    const std::size_t large = facets_of(0.5), small = facets_of(0.25);
    EXPECT_GT(large, 10U);
    EXPECT_GT(small, 2 * large);
    EXPECT_LT(small, 500U);
    pattern.facet_size = 0, pattern.facet_coords = 0.5;
    const auto facets = make_host_normal(pattern);
    FieldPoint point;
    point.position = {0.123, 0.456, 0.789};
    const Vec3d offset = facets->at(point);
    EXPECT_GT(length(offset), 0);
    EXPECT_LT(length(offset), 0.42 * 0.5 * std::numbers::sqrt3);
    point.position.x += 1e-4;
    EXPECT_EQ(length(facets->at(point) - offset), 0);
    point.position.x += 0.5;
    EXPECT_GT(length(facets->at(point) - offset), 0);
}

// Catches numbers beyond the last texture that leave a hole or begin again.
TEST(HostFields, MaterialsBeyondTheLastAreTheLast) {
    scene::Texture texture;
    texture.width = 4, texture.height = 1;
    texture.srgb = false;
    for (std::uint32_t number = 0; number < 4; ++number) texture.rgba8.push_back(number | 0xff000000U);
    auto picture = std::make_shared<scene::Pigment>();
    picture->kind = scene::Pigment::Kind::image;
    scene::Pattern pattern;
    pattern.kind = scene::Pattern::Kind::material;
    pattern.pigment = picture;
    pattern.choices = 3;
    const std::array textures{texture};
    const auto materials = make_host_field(pattern, textures);
    constexpr std::array<double, 4> kWanted{0, 1, 2, 2};
    for (std::size_t i = 0; i < 4; ++i) {
        FieldPoint point;
        point.position = {(static_cast<double>(i) + 0.5) / 4, 0.5, 0};
        EXPECT_EQ(materials->at(point).x, kWanted[i]) << i;
    }
}

}  // namespace
}  // namespace sundog::fields
