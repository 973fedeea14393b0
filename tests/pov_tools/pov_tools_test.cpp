// SPDX-License-Identifier: Apache-2.0
// Scenes as other programs write them: each is drawn, and drawn as povray does, where that is installed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "output/compare.h"
#include "output/image.h"
#include "program.h"

namespace sundog::tests {
namespace {

const std::vector<std::string> kSize{"+W160", "+H120", "+A0.1", "-D"};

class PovTools : public testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] std::filesystem::path scene() const {
        return std::filesystem::path(SUNDOG_SOURCE_DIR "/tests/pov_tools/scenes") / (std::string(GetParam()) + ".pov");
    }
    Outcome render(std::vector<std::string> words, const std::string& picture,
                   const std::filesystem::path& program = built_program()) {
        words.insert(words.end(), kSize.begin(), kSize.end());
        words.insert(words.end(), {"+I" + scene().string(), "+O" + (folder_ / picture).string()});
        return run(words, folder_.path(), program);
    }
    TemporaryFolder folder_;
};

// Catches statements of these programs that aren't understood.
TEST_P(PovTools, IsDrawn) {
    const Outcome outcome = render({"pov", "--device", "cpu"}, "ours.png");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const output::Image image = output::read_image(folder_ / "ours.png");
    float brightest = 0, darkest = 1;
    for (const Vec3& pixel : image.pixels) {
        brightest = std::max(brightest, pixel.y);
        darkest = std::min(darkest, pixel.y);
    }
    EXPECT_GT(brightest - darkest, 0.2F) << "there is something to be seen";
}

// Catches colours, shapes, cameras or lights that are others than povray's. The distances are of sRGB values, white
// being 1: a root mean square of 0.03 leaves room for edges that are sampled otherwise, and no more.
using PovToolsPictures = PovTools;
TEST_P(PovToolsPictures, LooksAsPovrayDrawsIt) {
    if (std::string(SUNDOG_POVRAY).empty()) GTEST_SKIP() << "povray isn't installed";
    const Outcome theirs = render({}, "theirs.png", SUNDOG_POVRAY);
    if (theirs.status != 0) GTEST_SKIP() << "povray can't draw it here: " << theirs.err;
    const Outcome ours = render({"pov", "--device", "cpu"}, "ours.png");
    ASSERT_EQ(ours.status, 0) << ours.err;
    const output::Comparison distance =
        output::compare(output::read_image(folder_ / "ours.png"), output::read_image(folder_ / "theirs.png"));
    EXPECT_LE(distance.rmse, 0.03);
    EXPECT_GE(distance.ssim, 0.95);
    RecordProperty("rmse", std::to_string(distance.rmse));
    if (HasFailure()) {
        const auto kept = std::filesystem::temp_directory_path();
        for (const char* name : {"ours.png", "theirs.png"})
            std::filesystem::copy_file(folder_ / name, kept / ("sundog_" + std::string(GetParam()) + "_" + name),
                                       std::filesystem::copy_options::overwrite_existing);
        ADD_FAILURE() << "both pictures are kept in " << kept;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PovTools,
                         testing::Values("ase", "pymol", "vmd", "jmol", "ldview", "vtk", "freecad", "openscad",
                                         "blender"),
                         [](const auto& name) { return std::string(name.param); });

// Not among them yet: ase (thin lines of its cell) and wings3d (uv mapping on meshes).
INSTANTIATE_TEST_SUITE_P(Scenes, PovToolsPictures,
                         testing::Values("pymol", "vmd", "jmol", "ldview", "vtk", "freecad", "openscad", "blender"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace sundog::tests
