// SPDX-License-Identifier: Apache-2.0
// Path tracing in scenes whose radiance is known in closed form; each derivation stands with its test.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

constexpr float kPiF = std::numbers::pi_v<float>;

FrameOptions paths(int width, int height, int depth) {
    FrameOptions options = size(width, height);
    options.integrator = kernel::INTEGRATOR_PATH;
    options.max_depth = depth;
    return options;
}

class Paths : public testing::Test {
protected:
    Picture render(const scene::Scene& s, const FrameOptions& options, std::uint32_t samples) {
        return render_on(*device_, s, options, samples);
    }
    /// Mean of red over a picture.
    float mean(const scene::Scene& s, const FrameOptions& options, std::uint32_t samples) {
        return mean_of(render(s, options, samples).film);
    }
    static float mean_of(const Film& film) {
        double sum = 0;
        for (int y = film.bounds.y0; y < film.bounds.y1; ++y)
            for (int x = film.bounds.x0; x < film.bounds.x1; ++x) sum += film.mean(x, y).x;
        return static_cast<float>(sum / (film.bounds.width() * film.bounds.height()));
    }

private:
    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

/// The inside of a cube of side 2 around the origin, all of one material.
void add_room(scene::Scene& s, scene::Index m) {
    const auto corner = [](unsigned i) {
        return Vec3{(i & 1U) ? 1.0F : -1.0F, (i & 2U) ? 1.0F : -1.0F, (i & 4U) ? 1.0F : -1.0F};
    };
    for (const auto& [a, b, c, d] :
         {std::array<unsigned, 4>{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})
        add_quad(s, corner(a), corner(b), corner(c), corner(d), m);
}

// A closed room whose walls emit e and reflect the share r: its radiance is the same everywhere, e (1 + r + ... + r^m)
// where m surfaces reflect light before the eye gets it: one more than there are further rays, for at the last surface,
// too, lights are aimed at. Catches light that is aimed at and met counted twice or not at all, a lost pi, and roulette
// that doesn't pay back.
TEST_F(Paths, AFurnaceOfTriangles) {
    for (const int depth : {1, 3, 12}) {
        scene::Scene s = empty_scene();
        add_room(s, add_material(s, shining({0.5F, 0.5F, 0.5F}, {0.6F, 0.6F, 0.6F})));
        const float want = 0.5F * (1 - std::pow(0.6F, static_cast<float>(depth + 2))) / 0.4F;
        EXPECT_NEAR(mean(s, paths(16, 16, depth), 256), want, 0.01F * want) << depth;
    }
}

// The same inside of a shining ball, which is drawn by all directions. Catches densities of spheres that are wrong from
// inside.
TEST_F(Paths, AFurnaceOfASphere) {
    scene::Scene s = empty_scene();
    add_shape(s, scene::Sphere{{0, 0, 0}, 3}, add_material(s, shining({1, 1, 1}, {0.5F, 0.5F, 0.5F})));
    EXPECT_NEAR(mean(s, paths(16, 16, 20), 64), 2, 0.02F);
}

// A ball of radius r that shines with L, its middle h above a matt floor: the irradiance at a distance x from the point
// below is pi L (r/d)^2 cos = pi L r^2 h / d^3 with d^2 = h^2 + x^2 (all of the ball is over the horizon), so radiance
// is Kd L r^2 h / d^3. Catches a cone of directions that is off, and shadow rays that end in the ball.
TEST_F(Paths, ASphereLightOverAPlane) {
    scene::Scene s = empty_scene();
    add_shape(s, scene::Plane{{0, 0, 1}, -4}, add_material(s, matt({0.5F, 0.5F, 0.5F})));
    const float radius = 0.75F, height = 5, light = 40;
    add_shape(s, scene::Sphere{{0, 8, 1}, radius}, add_material(s, shining({light, light, light}, {0, 0, 0})));
    const Film film = render(s, paths(24, 24, 0), 256).film;
    int seen = 0;
    for (int y = 17; y < 24; y += 2)
        for (int x = 0; x < 24; x += 3) {
            // The pixel's middle in the plane: the eye is 4 over it, the window 90 degrees high.
            const float dz = 1 - 2 * (y + 0.5F) / 24, dx = 2 * (x + 0.5F) / 24 - 1;
            const float t = 4 / -dz;
            const float across = t * dx, along = t - 8;
            const float d2 = across * across + along * along + height * height;
            const float want = 0.5F * light * radius * radius * height / (d2 * std::sqrt(d2));
            EXPECT_NEAR(film.mean(x, y).x, want, 0.05F * want + 1e-3F) << x << ' ' << y;
            ++seen;
        }
    EXPECT_GT(seen, 25);
}

/// Share of the hemisphere, by the cosine, that a rectangle takes of the view from below its middle: four times that of
/// a quarter with sides a and b in units of the distance (Howell, A Catalog of Radiation Heat Transfer Configuration
/// Factors, B-3).
float rectangle_share(float a, float b) {
    const float ra = std::sqrt(1 + a * a), rb = std::sqrt(1 + b * b);
    return 4 / (2 * kPiF) * (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb));
}

/// A matt wall, and behind the eye, so that it doesn't hide it, a shining rectangle that faces its middle.
scene::Scene lamp_before_a_wall() {
    scene::Scene s = empty_scene();
    add_quad(s, {-50, 4, -50}, {50, 4, -50}, {50, 4, 50}, {-50, 4, 50}, add_material(s, matt({0.8F, 0.8F, 0.8F})));
    add_quad(s, {-3, -1, -2}, {3, -1, -2}, {3, -1, 2}, {-3, -1, 2}, add_material(s, shining({5, 5, 5}, {0, 0, 0})));
    return s;
}

/// The radiance of the wall's middle.
const float kBeforeALamp = 0.8F * 5 * rectangle_share(3.0F / 5, 2.0F / 5);

// A shining rectangle that faces a matt wall: radiance opposite its middle is Kd L times its share of the view, both
// where light is aimed at and, on a wall of gloss (whose directions are drawn for it), where it is met. Catches
// densities of triangles and weights that don't add up to 1.
TEST_F(Paths, ARectangleLightBeforeAWall) {
    const scene::Scene s = lamp_before_a_wall();
    FrameOptions options = paths(8, 8, 0);
    options.camera = narrow_camera(0.001F);
    const float want = kBeforeALamp;
    EXPECT_NEAR(mean(s, options, 256), want, 0.01F * want);
    // One bounce more finds nothing, but light is now shared between both ways of finding it.
    options.max_depth = 1;
    EXPECT_NEAR(mean(s, options, 256), want, 0.01F * want);
}

// The same through a dark veil that lets three quarters pass. Catches light that is aimed at through it, met through
// it, and counted twice or not at all; and rays that go on behind a veil and end in what shines.
TEST_F(Paths, LightThroughAVeilCountsOnce) {
    scene::Scene s = lamp_before_a_wall();
    scene::Material veil;
    veil.principled->base_color = {0, 0, 0};
    veil.principled->specular = 0;
    veil.principled->alpha = 0.25F;
    veil.principled->alpha_mode = scene::PrincipledSurface::Alpha::blend;
    add_quad(s, {-30, -0.5F, -30}, {30, -0.5F, -30}, {30, -0.5F, 30}, {-30, -0.5F, 30}, add_material(s, veil));
    FrameOptions options = paths(16, 16, 4);
    options.camera = narrow_camera(0.001F);
    const float want = 0.75F * kBeforeALamp;
    // At the first depth light is aimed at alone.
    for (const int depth : {0, 1, 4}) {
        options.max_depth = depth;
        EXPECT_NEAR(mean(s, options, 256), want, 0.01F * want) << depth;
    }
}

// Lights without size give what Whitted's integrator gives, sample by sample. Catches factors of pi between the two,
// and lights that are drawn with another probability than they count with.
TEST_F(Paths, LampsAreThoseOfWhitted) {
    scene::Scene s = empty_scene();
    add_quad(s, {-9, 4, -9}, {9, 4, -9}, {9, 4, 9}, {-9, 4, 9}, add_material(s, matt({0.8F, 0.4F, 0.2F})));
    add_light(s, scene::Light::Kind::sun, {0, -0.5F, std::sqrt(0.75F)});
    const Film one = render(s, paths(8, 8, 0), 1).film;
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(one.mean(i, i).x, 0.4F, 1e-5F);
    add_light(s, scene::Light::Kind::lamp, {1, 0, 1}, {3, 3, 3});
    FrameOptions whitted = size(8, 8);
    EXPECT_NEAR(mean(s, paths(8, 8, 0), 512), mean(s, whitted, 1), 0.01F);
}

// A glass ball in even light is as bright as that light: what it throws back and lets through adds up to 1, on paths of
// any length. Catches lobes drawn with the wrong probability, and paths lost at total reflection.
TEST_F(Paths, GlassIsInvisibleInEvenLight) {
    scene::Scene s = empty_scene();
    s.sky = {1, 1, 1};
    add_shape(s, scene::Sphere{{0, 5, 0}, 2}, add_material(s, clear_glass(1.5F)));
    EXPECT_NEAR(mean(s, paths(32, 32, 64), 64), 1, 0.005F);
}

// White plastic, metal and rough glass of glTF's kind send back all light in a furnace; clear ones with a coat lose
// what bounces between coat and base. Catches reflection models that are handed wrong directions, and light from behind
// that is lost.
TEST_F(Paths, PrincipledSurfacesInEvenLight) {
    struct Kind {
        const char* name;
        float metallic, roughness, transmission, thickness;
        float least;
    };
    for (const Kind& kind : {Kind{"plastic", 0, 0.5F, 0, 0, 0.985F},
                             {"metal", 1, 0.3F, 0, 0, 0.985F},
                             {"rough metal", 1, 0.9F, 0, 0, 0.985F},
                             {"smooth glass", 0, 0.05F, 1, 1, 0.985F},
                             {"rough glass", 0, 0.4F, 1, 1, 0.93F},
                             {"thin wall", 0, 0.2F, 1, 0, 0.97F}}) {
        scene::Scene s = empty_scene();
        s.sky = {1, 1, 1};
        scene::Material m;
        m.principled->metallic = kind.metallic;
        m.principled->roughness = kind.roughness;
        m.principled->transmission = kind.transmission;
        m.principled->thickness = kind.thickness;
        add_shape(s, scene::Sphere{{0, 4, 0}, 2.5F}, add_material(s, m));
        FrameOptions options = paths(16, 16, 64);
        options.camera = narrow_camera(0.4F);
        const float got = mean(s, options, 256);
        EXPECT_GT(got, kind.least) << kind.name;
        EXPECT_LT(got, 1.01F) << kind.name;
    }
}

// What is half there lets half of the light pass straight on, in shadows as before the eye.
TEST_F(Paths, AlphaLetsLightPass) {
    scene::Scene s = empty_scene();
    add_quad(s, {-90, 8, -90}, {90, 8, -90}, {90, 8, 90}, {-90, 8, 90}, add_material(s, matt({1, 1, 1})));
    scene::Material veil;
    veil.principled->base_color = {0, 0, 0};
    veil.principled->specular = 0;
    veil.principled->alpha = 0.25F;
    veil.principled->alpha_mode = scene::PrincipledSurface::Alpha::blend;
    add_quad(s, {-60, 4, -60}, {60, 4, -60}, {60, 4, 60}, {-60, 4, 60}, add_material(s, veil));
    add_light(s, scene::Light::Kind::sun, {0, -1, 0});
    EXPECT_NEAR(mean(s, paths(8, 8, 4), 512), 0.75F * 0.75F, 0.02F);
}

// The same bits for any number of threads. Catches paths that share state.
TEST_F(Paths, ThreadsDontChangeBits) {
    scene::Scene s = empty_scene();
    add_room(s, add_material(s, matt({0.7F, 0.6F, 0.5F})));
    add_shape(s, scene::Sphere{{0.3F, 0.4F, 0.2F}, 0.2F}, add_material(s, shining({9, 8, 7}, {0, 0, 0})));
    const Film two = render(s, paths(40, 40, 5), 8).film;
    const std::unique_ptr<Device> alone = make_cpu_device({.threads = 1});
    const Film one = render_on(*alone, s, paths(40, 40, 5), 8).film;
    EXPECT_EQ(one.radiance, two.radiance);
}

// Another seed is another sample of the same picture.
TEST_F(Paths, SeedsGiveOtherNoiseAndTheSameMean) {
    scene::Scene s = empty_scene();
    add_room(s, add_material(s, matt({0.7F, 0.7F, 0.7F})));
    add_shape(s, scene::Sphere{{0.3F, 0.4F, 0.2F}, 0.2F}, add_material(s, shining({9, 9, 9}, {0, 0, 0})));
    FrameOptions options = paths(24, 24, 5);
    const Film first = render(s, options, 64).film;
    options.seed = 1;
    const Film second = render(s, options, 64).film;
    EXPECT_NE(first.radiance, second.radiance);
    EXPECT_NEAR(mean_of(first), mean_of(second), 0.01F * mean_of(first));
}

// All pixels see the same point, so only their numbers differ. Catches seeds that move the numbers of one picture to
// other pixels of the next: pictures of many seeds would have the noise of a few.
TEST_F(Paths, NoSeedMovesTheNoiseOfAnother) {
    scene::Scene s = empty_scene();
    const scene::Index m = add_material(s, matt({1, 1, 1}));
    add_shape(s, scene::Plane{{0, 0, 1}, -1}, m);
    add_shape(s, scene::Sphere{{0.5F, 0, 0}, 0.4F}, m);
    FrameOptions options = paths(16, 16, 1);
    options.integrator = kernel::INTEGRATOR_OCCLUSION;
    options.occlusion_distance = 3;
    kernel::Camera down{};
    down.center = {0, 0, -1};
    options.camera = down;
    const Film first = render(s, options, 16).film;
    options.seed = 1;
    const Film second = render(s, options, 16).film;
    for (const auto& [dx, dy] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
        int same = 0;
        for (int y = 1; y < 15; ++y)
            for (int x = 1; x < 15; ++x) same += second.mean(x, y).x == first.mean(x + dx, y + dy).x;
        EXPECT_LT(same, 14 * 14 / 4) << dx << ' ' << dy;
    }
}

// A corner of two walls that reach far: half of what either sees nearby is the other. Over a floor alone nothing is in
// the way. Catches occlusion that counts what is beyond its distance, or the surface itself.
TEST_F(Paths, OcclusionEndsAtItsDistance) {
    scene::Scene s = empty_scene();
    const scene::Index m = add_material(s, matt({1, 1, 1}));
    add_shape(s, scene::Plane{{0, 0, 1}, -1}, m);
    FrameOptions options = paths(8, 8, 1);
    options.integrator = kernel::INTEGRATOR_OCCLUSION;
    kernel::Camera down{};
    down.center = {0, 0, -1};
    down.right = {0.01F, 0, 0};
    down.up = {0, 0.01F, 0};
    options.camera = down;
    options.occlusion_distance = 3;
    EXPECT_NEAR(mean(s, options, 64), 1, 1e-6F);
    // A ceiling at the height h: a ray at the angle a to the normal meets it after h / cos a and brings the square of
    // that over the distance d, but no more than 1. Mean by the cosine: integral of min(1, (h / (d cos a))^2) 2 cos a
    // sin a da = 2 q^2 ln(1/q) + q^2 with q = h / d.
    add_shape(s, scene::Plane{{0, 0, 1}, 0.5F}, m);
    const float q = 0.5F;
    EXPECT_NEAR(mean(s, options, 1024), 2 * q * q * std::log(1 / q) + q * q, 0.005F);
}

// A lens whose focus is at a wall shows it as a pinhole does; a shining ball out of focus becomes a disc of radius
// R |d - f| / f in its plane at the distance d, as seen from the lens' middle. Catches lenses that move what is in
// focus, and blur of the wrong size.
TEST_F(Paths, ALensBlursWhatIsOutOfFocus) {
    scene::Scene s = empty_scene();
    const scene::Index m = add_material(s, shining({1, 1, 1}, {0, 0, 0}));
    add_quad(s, {0, 4, -9}, {9, 4, -9}, {9, 4, 9}, {0, 4, 9}, m);  // An edge at x = 0.
    for (const std::uint32_t integrator : {kernel::INTEGRATOR_WHITTED, kernel::INTEGRATOR_PATH}) {
        FrameOptions options = paths(64, 3, 0);
        options.integrator = integrator;
        kernel::Camera narrow{};
        narrow.center = {0, 1, 0};
        narrow.right = {0.5F, 0, 0};
        narrow.up = {0, 0, 0.01F};
        options.camera = narrow;
        options.lens_radius = 0.4F;
        options.focus_distance = 4;
        const Film sharp = render(s, options, 256).film;
        EXPECT_NEAR(sharp.mean(29, 1).x, 0, 1e-6F);
        EXPECT_NEAR(sharp.mean(34, 1).x, 1, 1e-6F);
        // In focus at 2: a point of the lens at distance r from the middle sees the edge moved by r (4 - 2) / 2 = r, so
        // it is blurred over 0.4 to each side: at 4, 64 pixels are 4 wide, so over 6.4 pixels.
        options.focus_distance = 2;
        const Film soft = render(s, options, 1024).film;
        EXPECT_NEAR(soft.mean(24, 1).x, 0, 1e-6F);
        EXPECT_NEAR(soft.mean(39, 1).x, 1, 1e-6F);
        // The share of the disc on one side of a chord at half of its radius is acos(1/2)/pi - sqrt(3)/(4 pi).
        const float pixel = 32 + 3.2F;
        const float left = soft.mean(static_cast<int>(pixel - 0.5F), 1).x,
                    right = soft.mean(static_cast<int>(pixel + 0.5F), 1).x;
        const float want = 1 - (std::acos(0.5F) / kPiF - std::sqrt(3.0F) / (4 * kPiF));
        EXPECT_NEAR((left + right) / 2, want, 0.05F);
    }
}

}  // namespace
}  // namespace sundog
