// SPDX-License-Identifier: Apache-2.0
// Different ways of computing one picture, compared pixel by pixel: where both have noise, or one has, differences are
// measured in their own standard deviations (z-test); what is biased by design is held to a share.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

constexpr int kSide = 12;
constexpr int kPixels = kSide * kSide;

/// Means of a picture's pixels, luminance alone, and the variances of these means.
struct Estimate {
    std::vector<double> mean = std::vector<double>(kPixels);
    std::vector<double> variance = std::vector<double>(kPixels);
};

class References : public testing::Test {
protected:
    std::vector<double> pixels(const scene::Scene& s, const FrameOptions& options, std::uint32_t samples) {
        const Film film = render_on(*device_, s, options, samples).film;
        std::vector<double> out;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) out.push_back(luminance(film.mean(x, y)));
        return out;
    }
    /// Of paths, by pictures of several seeds.
    Estimate paths(const scene::Scene& s, std::uint32_t samples, int depth) {
        constexpr int kPictures = 24;
        FrameOptions options = size(kSide, kSide);
        options.integrator = kernel::INTEGRATOR_PATH;
        options.max_depth = depth;
        std::vector<double> squares(kPixels);
        Estimate e;
        for (int i = 0; i < kPictures; ++i) {
            options.seed = ++seed_;
            const std::vector<double> one = pixels(s, options, samples);
            for (int k = 0; k < kPixels; ++k) {
                e.mean[k] += one[k] / kPictures;
                squares[k] += one[k] * one[k] / kPictures;
            }
        }
        for (int k = 0; k < kPixels; ++k)
            e.variance[k] = std::max(squares[k] - e.mean[k] * e.mean[k], 0.0) / (kPictures - 1);
        return e;
    }
    static double luminance(Vec3 c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

    /// With 24 pictures z is nearly normal: one of 144 pixels beyond 5 is a matter of months, and the mean of z is
    /// within 5 / 12.
    static void expect_same(const Estimate& a, const Estimate& b) {
        double sum = 0, squares = 0;
        for (int k = 0; k < kPixels; ++k) {
            const double spread = std::sqrt(a.variance[k] + b.variance[k] + 1e-12);
            const double z = (a.mean[k] - b.mean[k]) / spread;
            EXPECT_LT(std::abs(z), 5) << "pixel " << k << ": " << a.mean[k] << ", " << b.mean[k];
            sum += z;
            squares += z * z;
        }
        EXPECT_LT(std::abs(sum / kPixels), 5.0 / kSide);
        EXPECT_LT(squares / kPixels, 1.6);
    }

private:
    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
    std::uint32_t seed_ = 0;
};

scene::Material shining(float radiance) {
    scene::Material m = matt({0, 0, 0});
    m.mtl->emission = {radiance, radiance, radiance};
    return m;
}

/// A room open to the eye's side, white, red and green, and a block in it.
scene::Scene room() {
    scene::Scene s = empty_scene();
    const scene::Index white = add_material(s, matt({0.7F, 0.7F, 0.7F}));
    const scene::Index red = add_material(s, matt({0.6F, 0.1F, 0.1F}));
    const scene::Index green = add_material(s, matt({0.1F, 0.5F, 0.1F}));
    add_quad(s, {-2, 1, -2}, {2, 1, -2}, {2, 5, -2}, {-2, 5, -2}, white);
    add_quad(s, {-2, 1, 2}, {-2, 5, 2}, {2, 5, 2}, {2, 1, 2}, white);
    add_quad(s, {-2, 5, -2}, {2, 5, -2}, {2, 5, 2}, {-2, 5, 2}, white);
    add_quad(s, {-2, 1, -2}, {-2, 5, -2}, {-2, 5, 2}, {-2, 1, 2}, red);
    add_quad(s, {2, 1, -2}, {2, 1, 2}, {2, 5, 2}, {2, 5, -2}, green);
    add_shape(s, scene::Box{{-1, 3, -2}, {0.2F, 4.2F, 0.1F}}, white);
    return s;
}

// A lamp of triangles is aimed at; a box of the same size is none of the shapes that are, so its light is met. Catches
// weights of the two ways that don't add up to 1, and densities that are wrong by how a surface is seen.
TEST_F(References, LightThatIsAimedAtAndLightThatIsMet) {
    scene::Scene aimed = room();
    const scene::Index lamp = add_material(aimed, shining(6));
    add_quad(aimed, {-0.8F, 2.5F, 1.99F}, {-0.8F, 4, 1.99F}, {0.8F, 4, 1.99F}, {0.8F, 2.5F, 1.99F}, lamp);
    scene::Scene met = room();
    add_shape(met, scene::Box{{-0.8F, 2.5F, 1.99F}, {0.8F, 4, 1.9901F}}, add_material(met, shining(6)));
    expect_same(paths(aimed, 16, 4), paths(met, 256, 4));
}

// An even environment is aimed at, an even sky is met. Catches directions drawn by another density than counted with.
TEST_F(References, SkyThatIsAimedAtAndSkyThatIsMet) {
    scene::Scene aimed = room();
    scene::Environment sky;
    sky.width = 8;
    sky.height = 4;
    sky.radiance.assign(32, {1, 1, 1});
    aimed.environment = sky;
    scene::Scene met = room();
    met.sky = {1, 1, 1};
    expect_same(paths(aimed, 32, 3), paths(met, 64, 3));
}

// Mirrors and glass among walls that shine and reflect nothing: Whitted's integrator follows both branches at each
// surface and has no noise but that of edges; paths draw one. Catches a branch whose probability isn't what it is
// counted with, and roulette that loses light.
TEST_F(References, GlassByBranchesAndByPaths) {
    scene::Scene s = room();
    for (scene::Material& m : s.materials) {
        m.mtl->emission = m.mtl->diffuse;
        m.mtl->diffuse = {0, 0, 0};
    }
    scene::Material glass = glowing_mirror({0, 0, 0}, {1, 1, 1});
    glass.mtl->illum = 7;
    glass.mtl->ior = 1.5F;
    add_shape(s, scene::Sphere{{0.9F, 2.2F, -0.6F}, 0.8F}, add_material(s, glass));
    add_shape(s, scene::Sphere{{-1, 2, 0.8F}, 0.6F}, add_material(s, glowing_mirror({0, 0, 0}, {0.8F, 0.8F, 0.8F})));
    FrameOptions options = size(kSide, kSide);
    options.max_depth = 24;
    Estimate whitted;
    whitted.mean = pixels(s, options, 1024);
    for (double& v : whitted.variance) v = 0.002 * 0.002;
    expect_same(paths(s, 256, 24), whitted);
}

// Irradiance that is cached and interpolated, as POV-Ray's radiosity has it, is biased by design; all in all it brings
// what paths bring, within a tenth. Catches a factor between the two.
TEST_F(References, RadiosityAndPaths) {
    scene::Scene s = room();
    add_light(s, scene::Light::Kind::lamp, {0.5F, 2, 1.2F});
    Estimate traced = paths(s, 32, 8);
    s.radiosity.emplace();
    s.radiosity->count = 400;
    s.radiosity->error_bound = 0.4F;
    s.radiosity->recursion_limit = 5;
    s.radiosity->pretrace_end = 0.02F;
    const std::vector<double> cached = pixels(s, size(kSide, kSide), 16);
    s.radiosity.reset();
    const std::vector<double> direct = pixels(s, size(kSide, kSide), 16);
    double by_paths = 0, by_cache = 0;
    for (int k = 0; k < kPixels; ++k) {
        by_paths += traced.mean[k] - direct[k];
        by_cache += cached[k] - direct[k];
    }
    EXPECT_NEAR(by_cache, by_paths, 0.1 * by_paths);
}

}  // namespace
}  // namespace sundog
