// SPDX-License-Identifier: Apache-2.0
// Form factors against closed forms (Howell, A Catalog of Radiation Heat Transfer Configuration Factors).
#include "bake/form_factor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "bake/radiosity.h"

namespace sundog::bake {
namespace {

using std::atan;
using std::numbers::pi;

/// A rectangle's corner and sides.
struct Rectangle {
    Vec3 corner, u, v;
};

float exact(Vec3 point, Vec3 normal, const Rectangle& r) {
    const Vec3 a = r.corner, b = r.corner + r.u, c = r.corner + r.u + r.v, d = r.corner + r.v;
    return triangle_form_factor(point, normal, a, b, c) + triangle_form_factor(point, normal, a, c, d);
}

/// B-4 of the catalogue: a rectangle, b wide and a high, that stands upright c away from the point, a corner of its
/// foot straight before the point.
double upright(double a, double b, double c) {
    const double x = a / b, y = c / b, away = std::sqrt(x * x + y * y);
    return (atan(1 / y) - y / away * atan(1 / away)) / (2 * pi);
}

// Catches edges that are lost where a triangle is cut by the horizon, and sides that depend on the order of corners.
TEST(FormFactor, OfAnUprightRectangle) {
    const Vec3 point{0, 0, 0}, normal{0, 0, 1};
    EXPECT_NEAR(exact(point, normal, {{0, 1, 0}, {2, 0, 0}, {0, 0, 1.5F}}), upright(1.5, 2, 1), 1e-6);
    EXPECT_NEAR(exact(point, normal, {{0, 1, 0}, {0, 0, 1.5F}, {2, 0, 0}}), upright(1.5, 2, 1), 1e-6);
    // What of it is below the horizon isn't seen, and all that is seen from the other side.
    EXPECT_NEAR(exact(point, normal, {{0, 1, -3}, {2, 0, 0}, {0, 0, 4.5F}}), upright(1.5, 2, 1), 1e-6);
    EXPECT_NEAR(exact(point, normal * -1, {{0, 1, -3}, {2, 0, 0}, {0, 0, 4.5F}}), upright(3, 2, 1), 1e-6);
    EXPECT_EQ(exact(point, normal, {{0, 1, -3}, {2, 0, 0}, {0, 0, 2.5F}}), 0);
    // In the rectangle's own plane there is nothing to see.
    EXPECT_NEAR(exact(point, normal, {{1, 1, 0}, {2, 0, 0}, {0, 2, 0}}), 0, 1e-6);
}

// Catches a disc's area that counts twice, and cosines that are missing, by the exact factor of a small triangle.
TEST(FormFactor, OfADiscIsThatOfASmallTriangle) {
    const Vec3 point{0.2F, -0.1F, 0}, normal = normalize(Vec3{0.3F, 0.1F, 1});
    const Vec3 a{1, 2, 3}, b{1.1F, 2.05F, 2.9F}, c{0.9F, 2.2F, 3};
    const Vec3 across = cross(b - a, c - a);
    const float disc = disc_form_factor(point, normal, (a + b + c) / 3, normalize(across), length(across) / 2);
    const float triangle = triangle_form_factor(point, normal, a, b, c);
    EXPECT_GT(triangle, 1e-4F);
    EXPECT_NEAR(disc, triangle, 1e-3F * triangle);
    // So is that of a square, as far as its size's square counts; without that it would be 4% less.
    const Vec3 x{0.5F, 0, 0}, y{0, 0.3F, 0.4F}, corner = Vec3{1, 1, 1.5F} - x * 0.5F - y * 0.5F;
    const float square = exact(point, normal, {corner, x, y});
    EXPECT_NEAR(disc_form_factor(point, normal, corner + (x + y) * 0.5F, {0, -0.8F, 0.6F}, 0.25F), square,
                3e-3F * square);
    // On its axis a disc's factor is exact: of radius 2, one unit away, 4 / 5.
    EXPECT_NEAR(disc_form_factor({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, static_cast<float>(4 * pi)), 0.8F, 1e-6F);
    EXPECT_EQ(disc_form_factor({0, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}, 1), 0);
}

/// Surfaces of rectangles, `cells` by `cells` squares of two triangles each.
class Rectangles {
public:
    void add(const Rectangle& r, std::uint32_t cells) {
        const auto first = static_cast<std::uint32_t>(surfaces_.positions.size());
        const Vec3 normal = normalize(cross(r.u, r.v));
        const float step = 1 / static_cast<float>(cells);
        const auto place = [&](float x, float y) { return r.corner + r.u * (x * step) + r.v * (y * step); };
        for (std::uint32_t y = 0; y <= cells; ++y)
            for (std::uint32_t x = 0; x <= cells; ++x) {
                surfaces_.positions.push_back(place(static_cast<float>(x), static_cast<float>(y)));
                surfaces_.normals.push_back(normal);
                // A tenth of a cell off the rim.
                const auto inwards = [&](std::uint32_t k) {
                    return k == 0 ? 0.1F : k == cells ? static_cast<float>(cells) - 0.1F : static_cast<float>(k);
                };
                surfaces_.inside.push_back(place(inwards(x), inwards(y)));
            }
        for (std::uint32_t y = 0; y < cells; ++y)
            for (std::uint32_t x = 0; x < cells; ++x) {
                const std::uint32_t a = first + y * (cells + 1) + x, b = a + 1, c = b + cells + 1, d = a + cells + 1;
                surfaces_.triangles.push_back({a, b, c});
                surfaces_.triangles.push_back({a, c, d});
            }
        first_.push_back(first);
    }

    [[nodiscard]] const Surfaces& surfaces() const { return surfaces_; }
    [[nodiscard]] std::size_t vertices() const { return surfaces_.positions.size(); }
    [[nodiscard]] bool is_of(std::size_t vertex, std::size_t rectangle) const {
        return vertex >= first_[rectangle] && (rectangle + 1 == first_.size() || vertex < first_[rectangle + 1]);
    }

    /// What all vertices' fronts receive where the fronts of rectangle `source` (all of them: none named) send out 1.
    [[nodiscard]] std::vector<Vec3> received_from(std::optional<std::size_t> source) const {
        SurfaceLight light;
        for (std::size_t v = 0; v < vertices(); ++v) {
            const float sent = !source || is_of(v, *source) ? 1.0F : 0.0F;
            light.source.push_back({Vec3{sent, sent, sent}, Vec3{0, 0, 0}});
            light.reflectance.push_back({Vec3{0, 0, 0}, Vec3{0, 0, 0}});
        }
        const cpu::TriangleOccluders occluders(surfaces_.positions, surfaces_.triangles, 1);
        const FormFactors factors(surfaces_, occluders, {});
        const StopFlag stop;
        const Exchanged exchanged = exchange(factors, surfaces_, light, 1, {}, stop);
        std::vector<Vec3> received(vertices());
        const std::vector<std::uint8_t> back(vertices(), 0);
        EXPECT_TRUE(gather(factors, surfaces_, exchanged.nodes, back, received, {}, stop));
        return received;
    }

    /// Form factor from one rectangle to another: the mean of what the first receives of the second.
    [[nodiscard]] double factor(std::size_t from, std::size_t to) const {
        const std::vector<Vec3> received = received_from(to);
        double sum = 0, area = 0;
        for (const TriangleIndices& t : surfaces_.triangles) {
            if (!is_of(t[0], from)) continue;
            const Vec3 a = surfaces_.positions[t[0]], b = surfaces_.positions[t[1]], c = surfaces_.positions[t[2]];
            const double size = length(cross(b - a, c - a));
            sum += size * (received[t[0]].x + received[t[1]].x + received[t[2]].x) / 3;
            area += size;
        }
        return sum / area;
    }

private:
    Surfaces surfaces_;
    std::vector<std::uint32_t> first_;
};

/// C-11: equal squares that face each other, a side's length apart.
double facing_squares() {
    const double r = std::sqrt(2.0);
    return 2 / pi * (std::log(std::sqrt(4.0 / 3)) + 2 * r * atan(1 / r) - 2 * atan(1.0));
}

/// C-14: squares with an edge in common, at right angles.
double joined_squares() {
    const double r = std::sqrt(2.0);
    return (2 * atan(1.0) - r * atan(1 / r) + 0.25 * std::log(4.0 / 3 * 0.75 * 0.75)) / pi;
}

// Catches factors that depend on how far up the tree light is taken from, and near ones that lose their peak.
TEST(FormFactors, BetweenSquares) {
    Rectangles facing;
    facing.add({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 16);
    facing.add({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, 16);
    EXPECT_NEAR(facing_squares(), 0.1998, 1e-4);
    EXPECT_NEAR(facing.factor(0, 1), facing_squares(), 0.005 * facing_squares());
    Rectangles joined;
    joined.add({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 32);
    joined.add({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 32);
    EXPECT_NEAR(joined_squares(), 0.2, 1e-3);
    EXPECT_NEAR(joined.factor(0, 1), joined_squares(), 0.01 * joined_squares());
}

// A_i F_ij = A_j F_ji. Catches areas and cosines that belong to the wrong one of the two.
TEST(FormFactors, AreReciprocal) {
    Rectangles two;
    two.add({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, 24);
    two.add({{0.5F, 2.5F, 0.2F}, {0.1F, -0.5F, 0.3F}, {-0.3F, 0, 0.6F}}, 12);
    const double area_0 = 2, area_1 = length(cross({-0.3F, 0, 0.6F}, {0.1F, -0.5F, 0.3F}));
    const double there = area_0 * two.factor(0, 1), back = area_1 * two.factor(1, 0);
    EXPECT_GT(there, 1e-3);
    EXPECT_NEAR(there, back, 0.01 * there);
}

/// The inside of a box, and the outside of another one in it.
Rectangles room_with_a_block() {
    Rectangles room;
    const auto add_box = [&](Vec3 low, Vec3 high, bool inwards, std::uint32_t cells) {
        const Vec3 size = high - low, x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
        const auto add = [&](Vec3 corner, Vec3 u, Vec3 v) {
            room.add(inwards ? Rectangle{corner, u, v} : Rectangle{corner, v, u}, cells);
        };
        add(low, x, y), add(low, y, z), add(low, z, x);
        add(low + z, y, x), add(low + x, z, y), add(low + y, x, z);
    };
    add_box({-2, -1, 0}, {2, 1, 2}, true, 12);
    add_box({-0.5F, -0.4F, 0.3F}, {0.6F, 0.3F, 1.1F}, false, 6);
    return room;
}

// From each point of a closed room something is seen in every direction: factors add up to 1. Catches gaps and overlaps
// in what is taken of the tree, rays that are stopped by the surfaces they go to, and such as slip through edges.
TEST(FormFactors, AddUpToOneInAClosedRoom) {
    const std::vector<Vec3> received = room_with_a_block().received_from({});
    double mean = 0;
    for (const Vec3& r : received) {
        EXPECT_NEAR(r.x, 1, 0.04F);
        mean += r.x / static_cast<double>(received.size());
    }
    EXPECT_NEAR(mean, 1, 0.003);
}

// Catches light that leaks below walls: a box without a bottom stands across the triangles of a floor that shines
// outside of it, but not inside.
TEST(FormFactors, LeakNothingBelowWalls) {
    Rectangles scene;
    scene.add({{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}, 13);
    const Vec3 low{-0.7F, -0.6F, 0}, x{1.3F, 0.2F, 0}, y{-0.2F, 1.3F, 0}, z{0, 0, 1};
    scene.add({low, x, z}, 6), scene.add({low + x, y, z}, 6), scene.add({low + x + y, x * -1, z}, 6);
    scene.add({low + y, y * -1, z}, 6), scene.add({low + z, x, y}, 6);
    const Surfaces& surfaces = scene.surfaces();
    SurfaceLight light;
    for (const Vec3 p : surfaces.inside) {
        const Vec3 from = p - low;
        const bool inside =
            dot(from, x) > 0 && dot(from, x) < dot(x, x) && dot(from, y) > 0 && dot(from, y) < dot(y, y);
        const float sent = p.z == 0 && light.source.size() < 14 * 14 && !inside ? 1.0F : 0.0F;
        light.source.push_back({Vec3{sent, sent, sent}, Vec3{0, 0, 0}});
        light.reflectance.push_back({Vec3{0.9F, 0.9F, 0.9F}, Vec3{0.9F, 0.9F, 0.9F}});
    }
    const cpu::TriangleOccluders occluders(surfaces.positions, surfaces.triangles, 1);
    const StopFlag stop;
    const Exchanged exchanged = exchange(FormFactors(surfaces, occluders, {}), surfaces, light, 4, {}, stop);
    double inside = 0, outside = 0;
    for (std::size_t v = 0; v < scene.vertices(); ++v) {
        if (scene.is_of(v, 0)) continue;
        outside += exchanged.received[v][0].x;
        inside += exchanged.received[v][1].x;
    }
    EXPECT_GT(outside, 20);
    EXPECT_LT(inside, 0.01 * outside);
}

// Catches rays that no blocker stops, and blockers that stop what passes by.
TEST(FormFactors, KnowWhatIsInBetween) {
    Rectangles scene;
    scene.add({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 16);
    scene.add({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, 16);
    scene.add({{-5, -5, 0.5F}, {5.5F, 0, 0}, {0, 11, 0}}, 1);  // over the half with x < 0.5
    const std::vector<Vec3> received = scene.received_from(1);
    double error = 0;
    for (std::size_t v = 0; v < scene.vertices(); ++v) {
        if (!scene.is_of(v, 0)) continue;
        // A point sees what its lines through the blocker's edge leave: all beyond x = 1 - x of the point.
        const Vec3 p = scene.surfaces().inside[v];
        const float from = std::min(std::max(1 - p.x, 0.0F), 1.0F);
        // Rays go to the middles of columns of squares.
        const float expected = exact(p, {0, 0, 1}, {{from, 0, 1}, {0, 1, 0}, {1 - from, 0, 0}});
        EXPECT_NEAR(received[v].x, expected, 0.02F);
        error += (received[v].x - expected) / (17 * 17);
    }
    EXPECT_NEAR(error, 0, 0.004);
}

}  // namespace
}  // namespace sundog::bake
