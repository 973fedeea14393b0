// SPDX-License-Identifier: Apache-2.0
#include "environment_options.h"

#include <gtest/gtest.h>

#include "base/diagnostics.h"
#include "base/test_folder.h"
#include "output/image.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

// Catches numbers that land in the wrong place, and skies that no model knows.
TEST(EnvironmentOptions, Skies) {
    EXPECT_EQ(parse_sky("").elevation_deg, 40);
    EXPECT_EQ(parse_sky("10").elevation_deg, 10);
    EXPECT_EQ(parse_sky("10").azimuth_deg, 225);
    EXPECT_EQ(parse_sky("10,-90").azimuth_deg, -90);
    EXPECT_EQ(parse_sky("10,90,5").turbidity, 5);
    for (const char* bad : {"-1", "91", "10,", "10,400", "10,0,1", "10,0,11", "10,0,3,4", "noon", "nan", ","})
        EXPECT_THROW(parse_sky(bad), UsageError) << bad;
}

// Catches a picture whose bright places are cut off at white, and a gain that is lost.
TEST(EnvironmentOptions, KeepsLightBrighterThanWhite) {
    const TestFolder folder;
    output::Image image(2, 1);
    image.pixels = {{1000, 0.25F, 4}, {0, 0, 0}};
    for (const char* name : {"sky.exr", "sky.hdr"}) {
        const std::filesystem::path file = folder.path() / name;
        output::write_image(file, image);
        EnvironmentArguments arguments;
        arguments.file = file.string();
        arguments.gain = 2.0F;
        scene::Scene scene;
        arguments.apply(scene);
        ASSERT_TRUE(scene.environment.has_value());
        EXPECT_EQ(scene.environment->width, 2U);
        EXPECT_EQ(scene.environment->gain, 2);
        EXPECT_NEAR(scene.environment->radiance[0].x, 1000, 4) << name;
        EXPECT_NEAR(scene.environment->radiance[0].z, 4, 4) << name;
        EXPECT_EQ(scene.files, std::vector<std::string>{file.string()}) << "the window looks whether it changes";
    }
}

// Catches a missing picture that is passed over in silence.
TEST(EnvironmentOptions, AMissingPictureIsAnError) {
    EnvironmentArguments arguments;
    arguments.file = "nowhere.exr";
    scene::Scene scene;
    EXPECT_THROW(arguments.apply(scene), InputError);
}

}  // namespace
}  // namespace sundog::app
