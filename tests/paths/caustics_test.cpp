// SPDX-License-Identifier: Apache-2.0
// Caustics by photons against long path tracing. Paths can't meet lights without size, so in their scene each light is
// a small ball that shines: of the radiance that brings a surface the same light. Photons are spread over the area in
// which they are gathered, so parts of pictures are held to a share of the reference, not single pixels.
#include <gtest/gtest.h>

#include <numbers>

#include "base/test_folder.h"
#include "estimate.h"
#include "import/import.h"
#include "scene/indirect_light.h"

namespace sundog {
namespace {

using namespace test;

/// The half angle at which a surface sees what stands for a light, about.
constexpr float kHalfAngle = 0.12F;

/// The scene with a ball in place of each light, which must be suns or lamps that fade by the square of the distance.
scene::Scene with_balls(scene::Scene s, float from_lamp) {
    for (const scene::Light& light : s.lights) {
        const bool is_sun = light.kind == scene::Light::Kind::sun;
        // L pi r^2 / d^2 = pi color, and for a lamp pi color / d^2.
        const float distance = is_sun ? 1000.0F : from_lamp;
        const float radius = distance * kHalfAngle;
        scene::Material m = matt({0, 0, 0});
        m.mtl->emission = light.color * ((is_sun ? distance * distance : 1) / (radius * radius));
        const Vec3 place = is_sun ? normalize(light.place) * distance : light.place;
        add_shape(s, scene::Sphere{place, radius}, add_material(s, m));
    }
    s.lights.clear();
    return s;
}

/// From `eye` to `at`, `half` the window's height one unit away; z is up.
kernel::Camera camera(Vec3 eye, Vec3 at, float half) {
    const Vec3 forward = normalize(at - eye);
    const Vec3 right = normalize(cross(forward, Vec3{0, 0, 1}));
    const Vec3 up = cross(right, forward);
    const auto k = [](Vec3 v) { return kernel::vec3{v.x, v.y, v.z}; };
    return {k(eye), k(forward), k(right * half), k(up * half)};
}

constexpr int kSide = 16;
const std::vector<Region> kRegions{{"all", 0, 16, 0, 16},
                                   {"middle", 5, 11, 5, 11},
                                   {"left", 0, 5, 0, 16},
                                   {"right", 11, 16, 0, 16},
                                   {"below", 0, 16, 11, 16}};

class Caustics : public testing::Test {
protected:
    /// Photons' picture of the scene.
    [[nodiscard]] Film picture(const scene::Scene& s, const FrameOptions& options) const {
        return render_on(*device_, s, options, 64).film;
    }
    /// `options` has the camera.
    void compare(scene::Scene s, FrameOptions options, const std::vector<Region>& regions, std::uint32_t samples,
                 float share, float from_lamp = 1) const {
        options.width = options.height = kSide;
        options.max_depth = 12;
        options.min_weight = 0;
        const PathMeans reference(*device_, with_balls(s, from_lamp), options, samples, regions);
        const Film without = picture(s, options);
        s.photons = scene::photons_for(400'000);
        const Film with = picture(s, options);
        reference.expect_near(with, regions, share);
        reference.expect_off(without, regions, share, "shadow rays alone");
    }

    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

// An orbit scene with a model's materials: a ball of coloured glass before a screen, in the light of a sun, which
// doesn't fade. Catches photons that aren't shot at what is glass by its material alone, that lose the glass's colour
// (Tf), or that are counted by another measure than the light that comes straight.
TEST_F(Caustics, ABallOfMtlGlass) {
    const TestFolder folder;
    folder.write("screen.mtl",
                 "newmtl screen\nKd 0.7 0.7 0.7\nillum 1\n"
                 "newmtl glass\nKd 0 0 0\nKs 1 1 1\nNi 1.5\nd 0.05\nTf 0.98 0.9 0.6\nillum 7\n");
    folder.write("screen.obj",
                 "mtllib screen.mtl\no screen\nusemtl screen\n"
                 "v -6 4 -6\nv 6 4 -6\nv 6 4 6\nv -6 4 6\nf 1 2 3 4\n");
    const std::filesystem::path file = folder.write("ball.scene",
                                                    "focus = 12\nrotX = const 0\nrotZ = const 0\ndistance = 0\norigin "
                                                    "= 0 0 0\nmodel = screen.obj\nsphere = ball glass 0 2.9 0 0.5\n"
                                                    "light = sun const\nlightPos = 0.1 -1 0.05\n");
    FrameOptions options;
    options.camera = camera({-2.5F, 1.5F, 0}, {0, 4, 0}, 0.24F);
    scene::Scene s = import::import_scene(file, {});
    s.ambient = {0, 0, 0};
    compare(std::move(s), options, kRegions, 1800, 0.05F);
}

// The same by a lamp that fades, close by: its rays spread. Catches photons that grow by the way that they go although
// their light fades.
TEST_F(Caustics, ALampThatFades) {
    scene::Scene s = empty_scene();
    const scene::Index screen = add_material(s, matt({0.7F, 0.7F, 0.7F}));
    add_quad(s, {-6, 4, -6}, {6, 4, -6}, {6, 4, 6}, {-6, 4, 6}, screen);
    scene::Material glass = glowing_mirror({0, 0, 0}, {1, 1, 1});
    glass.mtl->illum = 7;
    glass.mtl->ior = 1.4F;
    add_shape(s, scene::Sphere{{0, 3, 0}, 0.5F}, add_material(s, glass));
    add_light(s, scene::Light::Kind::lamp, {0, 1, 0.1F}, {3, 2, 1});
    s.lights[0].fade_power = 2;
    FrameOptions options;
    options.camera = camera({-2.5F, 2, 0}, {0, 4, 0}, 0.24F);
    compare(s, options, kRegions, 1800, 0.05F, 2);
}

/// A cylinder's inside, of quadrilaterals, standing on the floor z = -1 around (0, 3).
scene::Mesh ring(scene::Index material) {
    scene::Mesh mesh;
    constexpr std::uint32_t kSides = 96;
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const float phi = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kSides;
        for (const float z : {-1.0F, -0.6F}) mesh.positions.push_back({std::cos(phi), 3 + std::sin(phi), z});
    }
    constexpr scene::Index n = scene::kNone;
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
        mesh.triangles.push_back({{b, a, a + 1}, {n, n, n}, {n, n, n}, material});
        mesh.triangles.push_back({{b, a + 1, b + 1}, {n, n, n}, {n, n, n}, material});
    }
    return mesh;
}

// A ring of gold on a floor. Catches mirrors that aren't shot at, and colours that they don't give to photons.
TEST_F(Caustics, AMirroringRing) {
    scene::Scene s = empty_scene();
    // So dark that what it sees of itself in the ring doesn't count.
    const scene::Index floor = add_material(s, matt({0.05F, 0.05F, 0.05F}));
    add_quad(s, {-6, -3, -1}, {6, -3, -1}, {6, 9, -1}, {-6, 9, -1}, floor);
    const scene::Index gold = add_material(s, glowing_mirror({0, 0, 0}, {0.9F, 0.7F, 0.3F}));
    add_shape(s, ring(gold), gold);
    add_light(s, scene::Light::Kind::sun, {1, 0.3F, 0.8F});
    FrameOptions options;
    options.camera = camera({0, 2.9F, 6}, {0, 3, -1}, 0.13F);
    // What is left out lies in the dark behind the ring, where some light is gathered from before it.
    compare(s, options, {{"all", 0, 16, 0, 16}, {"caustic", 0, 5, 2, 14}, {"middle", 5, 11, 5, 11}}, 1600, 0.04F);
}

// The gallery's glTF glass: a ball with a volume that colours light, a thin pane and a coated ball, under a sun.
// Catches a principled surface's glass that isn't shot at, and its thin walls if they are. Here, as to the eye, light
// is coloured by the volume's thickness, in paths by the way that it goes: hence a little more tolerance.
TEST_F(Caustics, GltfGlass) {
    scene::Scene s = import::import_scene(std::filesystem::path(SUNDOG_SCENES) / "gltf/glass.gltf", {});
    s.sky = s.ambient = {0, 0, 0};
    // Matt, which all integrators see alike, and so dark that light between surfaces adds little.
    for (scene::Material& m : s.materials) {
        if (m.principled->transmission > 0) continue;
        m.principled->base_color = m.principled->base_color * 0.2F;
        m.principled->specular = m.principled->clearcoat = 0;
        m.principled->roughness = 1;
    }
    FrameOptions options;
    options.camera = camera({-2.2F, 2, 2.2F}, {-1.29F, 0.41F, 0}, 0.27F);
    compare(std::move(s), options, kRegions, 2000, 0.06F);
}

}  // namespace
}  // namespace sundog
