// SPDX-License-Identifier: Apache-2.0
// --photons and --radiosity, for scenes of every format.
#include <gtest/gtest.h>

#include "program.h"

namespace sundog::tests {
namespace {

/// A ball of glass on a floor under a lamp; the eye looks down. POV-Ray's.
constexpr const char* kPov = R"(
#version 3.7;
global_settings { assumed_gamma 1 SETTINGS }
camera { location <0, 5, -0.1> look_at <0, 0, 0> }
light_source { <2, 6, 1> rgb 1 }
plane { y, 0 pigment { rgb 0.7 } finish { ambient 0.2 diffuse 0.8 } }
sphere { <0, 1, 0>, 0.7 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0 } interior { ior 1.5 } OBJECT }
)";

class Indirect : public testing::Test {
protected:
    std::string write_pov(const std::string& name, const std::string& settings, const std::string& object) {
        std::string text = kPov;
        text.replace(text.find("SETTINGS"), 8, settings);
        text.replace(text.find("OBJECT"), 6, object);
        write_bytes(folder_ / name, text);
        return (folder_ / name).string();
    }
    /// The bytes of a small picture.
    std::string picture(const std::string& scene, const std::vector<std::string>& more = {}) {
        const std::string output = (folder_ / "picture.ppm").string();
        std::vector<std::string> call{"render", scene, "-o", output, "--size", "40x30", "--quiet"};
        call.insert(call.end(), more.begin(), more.end());
        const Outcome outcome = run(call);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        said_ = outcome.err;
        return read_bytes(output);
    }

    TemporaryFolder folder_;
    std::string said_;
};

// Catches options that don't reach a format's scenes.
TEST_F(Indirect, EveryFormatHasThem) {
    const std::filesystem::path gallery = std::filesystem::path(table_scene()).parent_path().parent_path();
    const std::vector<std::string> scenes{(gallery / "glass/glass.scene").string(),
                                          (gallery / "glass/glass.obj").string(),
                                          (gallery / "gltf/glass.gltf").string(), write_pov("plain.pov", "", "")};
    for (const std::string& scene : scenes) {
        SCOPED_TRACE(scene);
        const std::string plain = picture(scene);
        const std::string caustics = picture(scene, {"--photons", "20000"});
        EXPECT_EQ(said_, "");
        EXPECT_FALSE(plain == caustics);
        EXPECT_FALSE(plain == picture(scene, {"--radiosity", "20", "--radiosity-bounces", "1"}));
    }
}

// Catches a scene's own settings that are overruled unasked, or that hold although the option says otherwise.
TEST_F(Indirect, ScenesKeepTheirOwnUnlessAsked) {
    const std::string plain = write_pov("plain.pov", "", "");
    const std::string own = write_pov("own.pov", "photons { count 30000 } radiosity { count 20 }",
                                      "photons { target reflection on refraction on }");
    const std::string settled = picture(own);
    EXPECT_FALSE(settled == picture(plain));
    EXPECT_TRUE(settled == picture(own, {"--photons", "30000", "--radiosity", "20"}));
    EXPECT_FALSE(settled == picture(own, {"--photons", "3000"}));
    EXPECT_TRUE(picture(plain) == picture(own, {"--photons", "0", "--radiosity", "0"}));
}

// Catches silence where photons have nothing to be shot at.
TEST_F(Indirect, NothingToShootAtIsSaid) {
    write_bytes(folder_ / "matt.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    picture((folder_ / "matt.obj").string(), {"--photons", "1000"});
    EXPECT_NE(said_.find("nothing in the scene mirrors or refracts light"), std::string::npos) << said_;
}

}  // namespace
}  // namespace sundog::tests
