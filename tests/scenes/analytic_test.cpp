// SPDX-License-Identifier: Apache-2.0
// Scenes whose radiance is known in closed form; each derivation stands with its test.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

class Analytic : public testing::Test {
protected:
    Picture render(const scene::Scene& s, const FrameOptions& options) { return render_on(*device_, s, options); }
    Vec3 middle(const scene::Scene& s, FrameOptions options = size(9, 9)) {
        return render(s, options).film.mean(*options.width / 2, *options.height / 2);
    }
    static void expect_color(Vec3 got, Vec3 want, float tolerance = 1e-5F) {
        EXPECT_NEAR(got.x, want.x, tolerance);
        EXPECT_NEAR(got.y, want.y, tolerance);
        EXPECT_NEAR(got.z, want.z, tolerance);
    }

private:
    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

// A matt wall at y = 4 under a sun from (0, -cos 60°, sin 60°): radiance is Kd * cos 60° = Kd / 2.
// Catches a lost cosine, or a sun whose direction is read the wrong way round.
TEST_F(Analytic, LambertUnderASun) {
    scene::Scene s = empty_scene();
    add_quad(s, {-9, 4, -9}, {9, 4, -9}, {9, 4, 9}, {-9, 4, 9}, add_material(s, matt({0.8F, 0.4F, 0.2F})));
    add_light(s, scene::Light::Kind::sun, {0, -0.5F, std::sqrt(0.75F)});
    expect_color(middle(s), {0.4F, 0.2F, 0.1F});
}

// The same wall under a lamp at the eye: pixel (x, y) sees cos = 1 / sqrt(1 + dx² + dz²) for its ray (dx, 1, dz).
// Catches wrong ray directions, flipped rows, and falloff with distance where there should be none.
TEST_F(Analytic, LampAtTheEyeFallsOffByCosineAlone) {
    scene::Scene s = empty_scene();
    add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, add_material(s, matt({1, 1, 1})));
    add_light(s, scene::Light::Kind::lamp, {0, 0, 0});
    const FrameOptions options = size(16, 8);
    const Film film = render(s, options).film;
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            const float dx = 2.0F * (2 * (x + 0.5F) / 16 - 1);
            const float dz = 1 - 2 * (y + 0.5F) / 8;
            EXPECT_NEAR(film.mean(x, y).x, 1 / std::sqrt(1 + dx * dx + dz * dz), 1e-5F) << x << ' ' << y;
        }
    }
}

// A lamp that lies in a ceiling lights the floor below it. Catches shadow rays that end behind the lamp, in the
// ceiling, because they start a little off the floor.
TEST_F(Analytic, ALampInASurfaceIsNotInItsShadow) {
    scene::Scene s = empty_scene();
    const scene::Index m = add_material(s, matt({1, 1, 1}));
    add_quad(s, {-90, -10, -27}, {90, -10, -27}, {90, 70, -27}, {-90, 70, -27}, m);
    add_quad(s, {-90, -10, 27.9F}, {-90, 70, 27.9F}, {90, 70, 27.9F}, {90, -10, 27.9F}, m);
    add_light(s, scene::Light::Kind::lamp, {3.1F, 20, 27.9F});
    const Picture picture = render(s, size(64, 48));
    for (int y = 40; y < 48; ++y)
        for (int x = 0; x < 64; ++x) EXPECT_GT(picture.film.mean(x, y).x, 0.3F) << x << ", " << y;
}

// Two facing mirrors, own colours a (first, third, …) and b: after n bounces the sum is that of the classic chain,
// c = sum_j c_j R_j prod_{i<j} r_i with R_j = 1 - r_j for j < n and R_n = 1. With r = 1/2 both and depth 3:
// a/2 + b/4 + a/8 + b/8. Catches a chain that darkens at its limit, or counts one bounce more or less.
TEST_F(Analytic, MirrorChainCountsTheLastSurfaceWhole) {
    scene::Scene s = empty_scene();
    const Vec3 half{0.5F, 0.5F, 0.5F};
    const scene::Index a = add_material(s, glowing_mirror({1, 0, 0}, half));
    const scene::Index b = add_material(s, glowing_mirror({0, 1, 0}, half));
    add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, a);
    add_quad(s, {-99, -1, -99}, {-99, -1, 99}, {99, -1, 99}, {99, -1, -99}, b);
    for (const int depth : {0, 1, 2, 3}) {
        Vec3 want{0, 0, 0};
        float weight = 1;
        for (int j = 0; j <= depth; ++j) {
            want += (j % 2 == 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}) * (weight * (j < depth ? 0.5F : 1.0F));
            weight *= 0.5F;
        }
        FrameOptions options = size(9, 9);
        options.max_depth = depth;
        expect_color(middle(s, options), want);
    }
}

// The same two mirrors, ended by weight: a ray of weight under 1/8 isn't traced, so the chain ends as at depth 3.
// Catches a threshold on the wrong quantity. (Weights are 1/2, 1/4, 1/8, 1/16; the last is refused.)
TEST_F(Analytic, MirrorChainEndsByWeight) {
    scene::Scene s = empty_scene();
    const Vec3 half{0.5F, 0.5F, 0.5F};
    const scene::Index a = add_material(s, glowing_mirror({1, 0, 0}, half));
    const scene::Index b = add_material(s, glowing_mirror({0, 1, 0}, half));
    add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, a);
    add_quad(s, {-99, -1, -99}, {-99, -1, 99}, {99, -1, 99}, {99, -1, -99}, b);
    FrameOptions options = size(9, 9);
    options.max_depth = 1000;
    options.min_weight = 0.1F;
    expect_color(middle(s, options), {0.5F + 0.125F, 0.25F + 0.125F, 0});
}

// A sphere between a lamp and a wall: the lamp at (0,0,0) lights the wall at y = 4 but for the disc where the sphere at
// y = 2 of radius r stands in the way: rays whose angle to the axis is under asin(r / 2). Catches shadow rays that
// start inside the surface (acne: dark specks in the lit part) or stop short.
TEST_F(Analytic, SphereCastsACircularHardShadow) {
    scene::Scene s = empty_scene();
    add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, add_material(s, matt({1, 1, 1})));
    add_shape(s, scene::Sphere{{0, -2, 0}, 1}, 0);
    add_light(s, scene::Light::Kind::lamp, {0, -4, 0});
    const Film film = render(s, size(64, 64)).film;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            // The wall's point (X, 4, Z) is seen from the lamp at distance 8 along the axis.
            const float px = 4 * (2 * (x + 0.5F) / 64 - 1);
            const float pz = 4 * (1 - 2 * (y + 0.5F) / 64);
            const float off_axis = std::sqrt(px * px + pz * pz);
            const float sine = off_axis / std::sqrt(off_axis * off_axis + 64);
            if (std::fabs(sine - 0.5F) < 0.002F) continue;  // the shadow's very edge
            if (sine < 0.5F) EXPECT_EQ(film.mean(x, y).x, 0) << x << ' ' << y;
            else EXPECT_GT(film.mean(x, y).x, 0.5F) << x << ' ' << y;
        }
    }
}

// A slab of glass (index 1.5) seen straight on passes what its two faces pass: T = (1 - F)² of the emitting wall behind
// plus what is reflected between the faces, with F = ((n-1)/(n+1))² = 0.04. The sum over all internal bounces is (1 -
// F)/(1 + F) (Born and Wolf, section 1.6.4, incoherent). Catches a Fresnel of the wrong side, a branch lost from the
// stack, or a wrong medium inside.
TEST_F(Analytic, GlassSlabPassesWhatFresnelSays) {
    scene::Scene s = empty_scene();
    scene::Material glass;
    glass.mtl->diffuse = {0, 0, 0};
    glass.mtl->specular = {1, 1, 1};
    glass.mtl->opacity = 0;
    glass.mtl->ior = 1.5F;
    glass.mtl->illum = 7;
    add_shape(s, scene::Box{{-50, 1, -50}, {50, 2, 50}}, add_material(s, glass));
    scene::Material glow = matt({0, 0, 0});
    glow.mtl->emission = {1, 1, 1};
    add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, add_material(s, glow));
    FrameOptions options = size(9, 9);
    options.max_depth = 12;
    expect_color(middle(s, options), Vec3{1, 1, 1} * (0.96F / 1.04F), 1e-4F);
}

// Snell: a ray enters a slab of thickness 1 at angle a and leaves it parallel, shifted by sin(a - b) / cos(b), where
// sin a = 1.5 sin b. A wall behind, white above z0 and black below, shows where the shifted ray arrives. Catches eta
// upside down.
TEST_F(Analytic, SlabShiftsByWhatSnellSays) {
    scene::Scene s = empty_scene();
    scene::Material glass;
    glass.mtl->diffuse = {0, 0, 0};
    glass.mtl->opacity = 0;
    glass.mtl->ior = 1.5F;
    glass.mtl->illum = 6;
    add_shape(s, scene::Box{{-50, 1, -50}, {50, 2, 50}}, add_material(s, glass));
    scene::Material glow = matt({0, 0, 0});
    glow.mtl->emission = {1, 1, 1};
    // The ray of the image's top middle, at 45 degrees: sin b = sin 45° / 1.5; it climbs 1 before, tan b inside, 2
    // behind.
    const float sin_b = std::sqrt(0.5F) / 1.5F;
    const float arrives = 1 + sin_b / std::sqrt(1 - sin_b * sin_b) + 2;
    const auto top_middle = [&](float edge) {
        scene::Scene with_wall = s;
        add_quad(with_wall, {-99, 4, edge}, {99, 4, edge}, {99, 4, 99}, {-99, 4, 99}, add_material(with_wall, glow));
        return render(with_wall, size(5, 1000)).film.mean(2, 0).x;  // half a thousandth below 45 degrees
    };
    EXPECT_GT(top_middle(arrives - 0.02F), 0.9F);
    EXPECT_LT(top_middle(arrives + 0.02F), 0.1F);
}

// A sun through a coloured pane that transmits Tf = (1, 0.5, 0) falls on white: the shadow has the pane's colour.
// Catches shadow rays that take transparent things for opaque, or for nothing.
TEST_F(Analytic, TransparentPaneColoursTheShadow) {
    scene::Scene s = empty_scene();
    scene::Material pane = matt({0, 0, 0});
    pane.mtl->opacity = 0;
    pane.mtl->transmission_filter = {1, 0.5F, 0};
    pane.mtl->illum = 9;
    add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, add_material(s, matt({1, 1, 1})));
    // Behind the eye, so the camera doesn't look through it.
    add_quad(s, {-99, -1, -99}, {99, -1, -99}, {99, -1, 99}, {-99, -1, 99}, add_material(s, pane));
    add_light(s, scene::Light::Kind::sun, {0, -1, 0});
    expect_color(middle(s), {1, 0.5F, 0});
}

// An opaque quad that shows its back: with culling on, the eye sees the wall behind; a transparent one stays.
// Catches culling that eats panes of glass, or that sees the wrong side.
TEST_F(Analytic, CullingRemovesOpaqueBacksOnly) {
    for (const bool transparent : {false, true}) {
        scene::Scene s = empty_scene();
        scene::Material glow = matt({0, 0, 0});
        glow.mtl->emission = {0, 0, 1};
        scene::Material front = matt({0, 0, 0});
        front.mtl->emission = {1, 0, 0};
        if (transparent) front.mtl->opacity = 0.5F;
        add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, add_material(s, glow));
        add_quad(s, {-99, 2, -99}, {-99, 2, 99}, {99, 2, 99}, {99, 2, -99}, add_material(s, front));
        s.settings.cull_backfaces = true;
        const Vec3 seen = middle(s);
        if (transparent) expect_color(seen, {0.5F, 0, 0.5F});
        else expect_color(seen, {0, 0, 1});
    }
}

// Blinn's and Phong's highlights where all vectors coincide are the full specular colour: 1 + diffuse 0.
// At 45 degrees between light and mirrored view Phong gives cos(45°)^n, Blinn cos(22.5°)^n.
// Catches swapped formulas or a wrong exponent.
TEST_F(Analytic, HighlightsByPhongAndBlinn) {
    for (const bool phong : {false, true}) {
        scene::Material m;
        m.mtl->diffuse = {0, 0, 0};
        m.mtl->specular = {1, 1, 1};
        m.mtl->shininess = 20;
        m.mtl->illum = 2;
        m.mtl->phong_highlight = phong;
        scene::Scene s = empty_scene();
        add_quad(s, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, add_material(s, m));
        add_light(s, scene::Light::Kind::sun, {0, -1, 1});
        const float angle = radians(phong ? 45.0F : 22.5F);
        expect_color(middle(s), Vec3{1, 1, 1} * std::pow(std::cos(angle), 20.0F), 1e-5F);
    }
}

// Faces of several objects at one place, seen at all slants: every pixel shows the object that was written first.
// Catches speckle where rounding, or the order in which a tree is walked, decides.
TEST_F(Analytic, OfCoincidentSurfacesTheFirstWrittenIsSeen) {
    const Vec3 first{1, 0, 0};
    const std::array<decltype(scene::Object::shape), 4> shapes{
        scene::Box{{-3.1F, 0.3F, -2}, {2.7F, 7.3F, -1.2F}}, scene::Plane{{0, 0, 1}, -1.2F},
        scene::Box{{-4.9F, 0.1F, -3.3F}, {4.4F, 9.7F, -1.2F}}, [] {
            auto solid = std::make_shared<scene::Solid>();
            solid->shape = scene::SolidBox{{-3.7, 0.2, -2.9}, {3.3, 8.8, -1.2F}};
            return std::shared_ptr<const scene::Solid>(solid);
        }()};
    for (std::size_t turn = 0; turn < shapes.size(); ++turn) {
        scene::Scene s = empty_scene();
        for (std::size_t i = 0; i < shapes.size(); ++i)
            add_shape(s, shapes[(turn + i) % shapes.size()],
                      add_material(s, glowing_mirror(i == 0 ? first : Vec3{0, 1, 0}, {})));
        const Film film = render(s, size(160, 120)).film;
        int counted = 0;
        for (int y = 66; y < 100; ++y) {
            for (int x = 0; x < 160; ++x) {
                const float dx = (x + 0.5F) / 80 * (160.0F / 120) - 160.0F / 120;
                const float dz = 1 - (y + 0.5F) / 60;
                const Vec3 p = Vec3{dx, 1, dz} * (-1.2F / dz);
                if (std::abs(p.x) > 2.6F || p.y < 0.4F || p.y > 7.2F) continue;
                ++counted;
                ASSERT_EQ(film.mean(x, y), first) << turn << ": " << x << ' ' << y;
            }
        }
        EXPECT_GT(counted, 2000);
    }
}

// The same picture, bit for bit, from one thread and from three, and whatever region is asked for.
// Catches results that depend on how work is split.
TEST_F(Analytic, SameBitsForAnySplit) {
    scene::Scene s = empty_scene();
    const scene::Index m = add_material(s, glowing_mirror({0.1F, 0.2F, 0.3F}, {0.5F, 0.6F, 0.7F}));
    for (int i = 0; i < 20; ++i)
        add_shape(s, scene::Sphere{{std::sin(i * 2.4F) * i * 0.2F, 6, std::cos(i * 2.4F) * i * 0.2F}, 0.45F}, m);
    add_shape(s, scene::Plane{{0, 0, 1}, -3}, m);
    add_light(s, scene::Light::Kind::lamp, {2, 0, 5});
    const FrameOptions options = size(101, 67);
    const Picture whole = render(s, options);
    const std::unique_ptr<Device> one = make_cpu_device({.threads = 1});
    one->load(compile(s, {}));
    Film film(whole.film.bounds);
    const StopFlag stop;
    for (const PixelRect part : {PixelRect{0, 0, 37, 67}, PixelRect{37, 0, 101, 11}, PixelRect{37, 11, 101, 67}})
        one->render(whole.frame, {part, 0, 1}, film, stop);
    EXPECT_EQ(film.radiance, whole.film.radiance);

    // Seven samples at once, and as 1 + 2 + 4.
    Film at_once(film.bounds), in_parts(film.bounds);
    one->render(whole.frame, {film.bounds, 0, 7}, at_once, stop);
    for (const RenderWork part : {RenderWork{film.bounds, 0, 1}, {film.bounds, 1, 2}, {film.bounds, 3, 4}})
        one->render(whole.frame, part, in_parts, stop);
    EXPECT_EQ(at_once.radiance, in_parts.radiance);
}

}  // namespace
}  // namespace sundog
