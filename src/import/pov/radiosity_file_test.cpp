// SPDX-License-Identifier: Apache-2.0
#include "import/pov/radiosity_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "import/pov/build_test_scene.h"

namespace sundog::pov {
namespace {

StoredRadiosity some_samples() {
    StoredIrradiance a;
    a.sample.position = {1, 2, 3}, a.sample.normal = {0, 0, 1}, a.sample.light = {0.25F, 0.5F, 4}, a.sample.reach = 7;
    a.sample.by_move[1] = {8, -9, 10}, a.sample.by_turn[2] = {-11, 12, 13};
    StoredIrradiance b = a;
    b.bounce = 3, b.sample.position = {-1e20F, 1e-20F, 0}, b.sample.reach = 0.125F;
    return {a, b};
}

std::string error_of_bytes(const std::string& bytes) {
    try {
        radiosity_of_bytes(bytes);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

// Catches a number that is left out, or read at another's place.
TEST(RadiosityFile, IsReadAsItWasWritten) {
    const StoredRadiosity samples = some_samples();
    const std::string bytes = radiosity_file_bytes(samples);
    const StoredRadiosity again = radiosity_of_bytes(bytes);
    ASSERT_EQ(again.size(), 2U);
    EXPECT_EQ(again[0].sample.by_move[1], samples[0].sample.by_move[1]);
    EXPECT_EQ(again[0].sample.by_turn[2], samples[0].sample.by_turn[2]);
    EXPECT_EQ(again[0].sample.light, samples[0].sample.light);
    EXPECT_EQ(again[1].sample.position, samples[1].sample.position);
    EXPECT_EQ(again[1].sample.reach, 0.125F);
    EXPECT_EQ(again[1].bounce, 3U);
    EXPECT_EQ(radiosity_file_bytes(again), bytes);
    EXPECT_TRUE(radiosity_of_bytes(radiosity_file_bytes({})).empty());
}

// Catches files that are cut short, of another kind, or made to crash whoever reads them.
TEST(RadiosityFile, BadFilesAreErrors) {
    const std::string bytes = radiosity_file_bytes(some_samples());
    EXPECT_EQ(error_of_bytes("sundog photons 1\n0 0\n"), "not a file of radiosity that Sundog has saved");
    EXPECT_EQ(error_of_bytes("sundog radiosity 1\n"), "it doesn't say how many samples it holds");
    EXPECT_EQ(error_of_bytes("sundog radiosity 1\n-2\n"), "it doesn't say how many samples it holds");
    EXPECT_EQ(error_of_bytes("sundog radiosity 1\n4294967295\nx"), "it is not as long as its 4294967295 samples");
    EXPECT_EQ(error_of_bytes(bytes.substr(0, bytes.size() - 1)), "it is not as long as its 2 samples");
    StoredRadiosity samples = some_samples();
    samples[1].sample.light.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(error_of_bytes(radiosity_file_bytes(samples)), "");
    samples = some_samples();
    samples[0].sample.normal = {0, 0, 0};
    EXPECT_NE(error_of_bytes(radiosity_file_bytes(samples)), "");
    samples = some_samples();
    samples[0].bounce = 20;
    EXPECT_NE(error_of_bytes(radiosity_file_bytes(samples)), "");
}

// The file that the command names is used where the scene has radiosity, and nowhere else; one that isn't there yet is
// no error, for each picture of an animation may begin with what the last one has gathered.
TEST(RadiosityFile, TheCommandNamesIt) {
    PovOptions options;
    options.radiosity_file = {"nowhere.rca", true, false};
    EXPECT_TRUE(build("sphere { 0, 1 }", options).warnings.empty());
    const BuiltScene built = build("global_settings { radiosity { } }", options);
    EXPECT_EQ(built.warnings, std::vector<std::string>{"there is no file of radiosity 'nowhere.rca' yet"});
    EXPECT_FALSE(built.scene.radiosity->loaded || built.scene.radiosity->store);
    EXPECT_NE(error_of("global_settings { radiosity { load_file \"nowhere.rca\" } }").find("can't find the file"),
              std::string::npos);
}

}  // namespace
}  // namespace sundog::pov
