// SPDX-License-Identifier: Apache-2.0
// Blurs of finished pictures beside the traced ones that they stand for.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"

namespace sundog::tests {
namespace {

class Blur : public testing::Test {
protected:
    /// The bytes of a picture of so many samples, without shadows and mirrors, which no post-process can follow.
    std::string picture(int samples, const std::vector<std::string>& options) {
        std::vector<std::string> call = {"render", table_scene(), "-o", (folder_ / "a.ppm").string()};
        for (const std::string part :
             {"--size", "320x240", "--device", "cpu", "--no-shadows", "--max-depth", "0", "--spp"})
            call.push_back(part);
        call.push_back(std::to_string(samples));
        call.insert(call.end(), options.begin(), options.end());
        const Outcome outcome = run(call);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        said_ = outcome.err;
        return read_bytes(folder_ / "a.ppm");
    }
    /// Root of the mean squared difference of two pictures' bytes.
    static double difference(const std::string& a, const std::string& b) {
        EXPECT_EQ(a.size(), b.size());
        double sum = 0;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
            const double d = static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i]);
            sum += d * d;
        }
        return std::sqrt(sum / static_cast<double>(a.size()));
    }

    TemporaryFolder folder_;
    std::string said_;
};

// Catches blurs of another radius or another plane of focus than the traced lens's, and spreads that are mixed up.
TEST_F(Blur, TheLenssIsNearTheTracedOne) {
    const std::vector<std::string> lens = {"--aperture", "0.3", "--focus", "7.5"};
    const auto with = [&](int samples, std::initializer_list<std::string> more) {
        std::vector<std::string> options = lens;
        options.insert(options.end(), more);
        return picture(samples, options);
    };
    const std::string sharp = picture(16, {}), traced = with(128, {});
    const std::string disc = with(16, {"--lens-blur", "disc"});
    EXPECT_NE(said_.find(", blurred in "), std::string::npos) << said_;
    const std::string gaussian = with(16, {"--lens-blur", "gaussian"});
    EXPECT_LT(difference(disc, traced), 0.35 * difference(sharp, traced));
    EXPECT_LT(difference(gaussian, traced), 0.35 * difference(sharp, traced));
    EXPECT_TRUE(disc != gaussian);
    EXPECT_TRUE(traced == with(128, {"--lens-blur", "traced"}));
    EXPECT_TRUE(disc == with(16, {"--lens-blur", "disc", "--threads", "1"}));
}

// Catches paths of another length or another moment than the shutter's.
TEST_F(Blur, TheShuttersIsNearTheTracedOne) {
    const std::string opens = picture(16, {}), middle = picture(16, {"--time", "0.4"});
    const std::string traced = picture(128, {"--shutter", "0.8"});
    const std::string blurred = picture(16, {"--shutter", "0.8", "--shutter-blur", "velocity"});
    EXPECT_LT(difference(blurred, traced), 0.7 * difference(middle, traced));
    EXPECT_LT(difference(blurred, traced), 0.5 * difference(opens, traced));
    EXPECT_TRUE(blurred == picture(16, {"--shutter", "0.8", "--shutter-blur", "velocity", "--threads", "1"}));
    EXPECT_TRUE(traced == picture(128, {"--shutter", "0.8", "--shutter-blur", "traced"}));
    // Both together, of one sample, and without noise.
    const std::string both = picture(1, {"--shutter", "0.8", "--shutter-blur", "velocity", "--lens-blur", "disc",
                                         "--aperture", "0.3", "--focus", "7.5"});
    EXPECT_TRUE(both != blurred);
    EXPECT_TRUE(picture(16, {"--shutter", "0.8", "--shutter-blur", "velocity", "--denoise"}) != opens);
}

// Catches cameras whose rays are no pinhole's being blurred as if they were.
TEST_F(Blur, OtherCamerasAreRefused) {
    write_bytes(folder_ / "flat.gltf",
                R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"camera":0}],)"
                R"("cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":10,"znear":0.1}}]})");
    const Outcome outcome = run({"render", (folder_ / "flat.gltf").string(), "-o", (folder_ / "a.ppm").string(),
                                 "--device", "cpu", "--lens-blur", "disc", "--aperture", "1", "--focus", "3"});
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("need a perspective camera"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.ppm"));
}

}  // namespace
}  // namespace sundog::tests
