// SPDX-License-Identifier: Apache-2.0
// The gallery's scenes against pictures of them that were looked at and kept beside this file. One that changed on
// purpose is made again by
//     sundog render scenes/NAME/NAME.scene -o tests/images/NAME.png --size 160x120 --time 1 --spp 4 --sampler r2
// and one of a glTF file by
//     sundog render scenes/gltf/NAME.gltf -o tests/images/gltf_NAME.png --size 160x120 --time 1 --spp 4 --sampler r2
#include <gtest/gtest.h>

#include <filesystem>

#include "compile/compile.h"
#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "output/compare.h"
#include "output/image.h"
#include "scene/deformation.h"
#include "session/session.h"

namespace sundog {
namespace {

constexpr int kWidth = 160, kHeight = 120;
constexpr std::uint32_t kSamples = 4;

output::Image render_at_one_second(const std::filesystem::path& file, const import::Choices& choices) {
    scene::Scene scene = import::import_scene(
        file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); }, choices);
    scene::deform(scene, 1);
    const auto compiled = compile(scene, {});
    FrameOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.time_s = 1;
    Session session(make_cpu_device({.threads = 2, .lanes = 0}));
    session.load(compiled);
    const RenderResult result = session.render(make_frame(scene, *compiled, options), kSamples, {}, StopFlag());
    output::Image image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) image.at(x, y) = result.film.mean(x, y);
    return image;
}

class GalleryPicture : public testing::TestWithParam<const char*> {};

/// The bounds leave room for another Embree's rounding at edges: 38 dB is a root mean square of 3.2/255, and a mean
/// FLIP of 0.01 can't be seen.
void expect_picture(const std::filesystem::path& scene, const std::string& picture,
                    const import::Choices& choices = {}) {
    const std::filesystem::path source = SUNDOG_SOURCE_DIR;
    const output::Image found = render_at_one_second(source / "scenes" / scene, choices);
    const output::Image wanted = output::read_image(source / "tests" / "images" / (picture + ".png"));
    const output::Comparison distance = output::compare(found, wanted);
    EXPECT_GE(distance.psnr_db, 38);
    EXPECT_LE(distance.flip, 0.01);
    if (testing::Test::HasFailure()) {
        const auto kept = std::filesystem::temp_directory_path() / ("sundog_gallery_" + picture + ".png");
        output::write_image(kept, found);
        ADD_FAILURE() << "the picture found is " << kept;
    }
}

// Catches whatever changes a picture as a whole: colours, lights, shadows, mirrors, glass, textures, motion, the
// camera, and warnings about the gallery's files.
TEST_P(GalleryPicture, IsAsItWas) {
    const std::string name = GetParam();
    expect_picture(std::filesystem::path(name) / (name + ".scene"), name);
}

class GltfPicture : public testing::TestWithParam<const char*> {};

// Catches the same in glTF files: samplers, alpha, metals, glass, normal maps, units of light, keyframes, skins,
// vertices' colours and tangents, sets of texture coordinates, and backs that aren't drawn.
TEST_P(GltfPicture, IsAsItWas) {
    const std::filesystem::path file = GetParam();
    expect_picture("gltf" / file, "gltf_" + file.stem().string());
}

// Catches a variant that is ignored, and one that reaches only some meshes. Its picture is made with --variant brass.
TEST(GltfVariant, IsAsItWas) { expect_picture("gltf/variants.gltf", "gltf_variant_brass", {.variant = "brass"}); }

INSTANTIATE_TEST_SUITE_P(Gallery, GalleryPicture, testing::Values("table", "cornell", "mirrors", "glass", "textured"),
                         [](const auto& name) { return std::string(name.param); });
INSTANTIATE_TEST_SUITE_P(Gallery, GltfPicture,
                         testing::Values("textured.glb", "spheres.gltf", "alpha.gltf", "normal.gltf", "lights.gltf",
                                         "instances.gltf", "quantized.gltf", "animated.gltf", "bent.gltf", "glass.gltf",
                                         "colors.gltf", "uv_sets.gltf", "tangents.gltf", "variants.gltf",
                                         "one_sided.gltf"),
                         [](const auto& name) { return std::filesystem::path(name.param).stem().string(); });

}  // namespace
}  // namespace sundog
