// SPDX-License-Identifier: Apache-2.0
#include "import/pov/format_blocks.h"

#include <gtest/gtest.h>

#include "import/pov/pov_language_test.h"

namespace sundog::pov {
namespace {

namespace fs = std::filesystem;

/// Answers every question the same way, so that scenes that ask can be read to their ends.
class FixedAnswers : public GeometryQueries {
public:
    std::shared_ptr<const scene::Pigment> pigment_of(const std::shared_ptr<const Block>&) override {
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->color = {0.25F, 0.5F, 0.75F, 0, 0};
        return pigment;
    }
    std::shared_ptr<const scene::Pigment> pigment_of_pattern(const std::shared_ptr<const Block>& pattern) override {
        return pigment_of(pattern);
    }
    [[nodiscard]] std::span<const scene::Texture> textures() const override { return {}; }
    bool trace(const std::shared_ptr<const Block>&, Vec3d origin, Vec3d direction, Hit& hit) override {
        hit = {origin + direction, {0, 1, 0}};
        return true;
    }
    bool inside(const std::shared_ptr<const Block>&, Vec3d) override { return true; }
    Bounds3d extent(const std::shared_ptr<const Block>&) override {
        Bounds3d bounds;
        bounds.include({-1, -1, -1});
        bounds.include({1, 1, 1});
        return bounds;
    }
};

// Each kind of item, once as it should be printed; and read again, once more the same.
TEST(PovFormat, WhatIsPrintedReadsBackTheSame) {
    const std::string scene = R"(
        #version 3.7;
        #default { finish { ambient 0.5 } }
        #declare T = texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } }
        #declare F = function(a, b) { a*2 - select(b, 1, -2) }
        #declare P = function { pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } } }
        camera { location <0, 1.5, -3> look_at 0 right -4/3*x }
        object { sphere { <1, 2, 3>, 0.1 } texture { T scale 2 } matrix <1,0,0, 0,1,0, 0,0,1, 5,6,7> open }
        isosurface { function { F(x, y) + P(x, y, z).gray + sum(i, 1, 3, i*z) } contained_by { box { -1, 1 } } }
        mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,-1e-5>, <0,1,0> } face_indices { 1, <0,1,2>, } }
        pigment { image_map { png "a\"b.png" filter all 0.5 transmit 3, 0.25 gamma srgb } }
        julia_fractal { <-0.1, 0.8, 0, 0.5> quaternion sqr slice <0,0,0,1>, 0 }
        quartic { <1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35> }
        background { <1,2> }
        fog { color rgb 0.5 transmit 0.1 distance -10 })";
    const std::string once = formatted(scene);
    EXPECT_EQ(formatted("#version 3.7;\n" + once), once);
    EXPECT_NE(once.find("all 0.5\n    transmit 3, 0.25\n    gamma\n    srgb"), std::string::npos) << once;
    EXPECT_NE(once.find("vertex_vectors { 3, <0, 0, 0>, <1, 0, -1e-05>, <0, 1, 0> }"), std::string::npos) << once;
    EXPECT_NE(once.find("quaternion sqr slice <0, 0, 0, 1>, 0"), std::string::npos) << once;
}

// A rule of the language that real scenes use and no small test has. Needs povray-examples and povray-includes.
TEST(PovFormat, InstalledExamplesAreReadAndReadBack) {
    const fs::path examples = "/usr/share/doc/povray/examples", includes = "/usr/share/povray-3.7/include";
    if (!fs::exists(examples) || !fs::exists(includes))
        GTEST_SKIP() << "povray-examples or povray-includes isn't installed";
    PovOptions options;
    options.library_paths = {includes};
    options.access.writable = {fs::temp_directory_path() / "sundog-pov-examples"};
    fs::create_directories(options.access.writable.front());
    options.limits.steps = 300'000;
    FixedAnswers answers;
    int read = 0;
    for (const auto& entry : fs::recursive_directory_iterator(examples)) {
        // __empty.pov is a form to fill in; the others make millions of triangles, which takes too long for a test.
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".pov" || name == "__empty.pov" || name.starts_with("ess-") ||
            name == "benchmark.pov")
            continue;
        std::string once, twice;
        try {
            SourceFiles sources, again;
            FormattingSink first(once), second(twice);
            interpret(entry.path(), options, sources, first, &answers, {});
            interpret_text("again.pov", once, entry.path().parent_path(), options, again, second, &answers, {});
        } catch (const std::exception& error) {
            // Those that make thousands of objects take too long for a test.
            if (std::string(error.what()).find("steps") == std::string::npos)
                ADD_FAILURE() << entry.path() << ": " << error.what();
            continue;
        }
        EXPECT_TRUE(once == twice) << entry.path() << " doesn't read back as it was printed";
        ++read;
    }
    fs::remove_all(options.access.writable.front());
    EXPECT_GT(read, 250);
}

}  // namespace
}  // namespace sundog::pov
