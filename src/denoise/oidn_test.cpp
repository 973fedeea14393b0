// SPDX-License-Identifier: Apache-2.0
// Against libraries that look at how they are called (fake_oidn.cpp).
#include "denoise/oidn.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "denoise/denoiser.h"

namespace sundog::denoise {
namespace {

using Names = std::vector<std::string>;

const std::string kVersion2 = FAKE_OIDN_2;
const std::string kVersion1 = FAKE_OIDN_1;

/// Each pixel and channel is another number, so that none can be taken for another.
struct Planes {
    static constexpr int kWidth = 7, kHeight = 5;
    Planes() {
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const auto n = static_cast<float>(i);
            radiance.push_back({n, n + 0.25F, n + 0.5F});
            albedo.push_back({n / 64, 0.5F, 1 - n / 64});
            normal.push_back({-n / 64, 0.25F, n / 64});
        }
        variance.assign(radiance.size(), Vec3{});
        depth.assign(radiance.size(), 1);
    }
    [[nodiscard]] NoisyPicture picture() const { return {kWidth, kHeight, radiance, variance, albedo, normal, depth}; }
    std::vector<Vec3> radiance, variance, albedo, normal;
    std::vector<float> depth;
};

std::string error_of(const Names& names) {
    try {
        const OpenImageDenoise oidn(names);
    } catch (const OidnError& error) {
        return error.what();
    }
    return "none";
}

/// What the fake makes of all planes.
Vec3 all_of(const Planes& planes, std::size_t i) {
    return planes.radiance[i] + planes.albedo[i] * 10 + planes.normal[i] * 100 + Vec3{1000, 1000, 1000};
}

// Catches planes that come in as others, sizes and strides that mix pixels up, HDR colours said to be none, guides
// without noise that aren't said to be that, and a version whose functions have other names.
TEST(Oidn, HandsItsPlanesToBothVersions) {
    const Planes planes;
    for (const std::string& name : {kVersion2, kVersion1}) {
        const OpenImageDenoise oidn(Names{name});
        EXPECT_EQ(oidn.version(), name == kVersion1 ? "1.4.3" : "2.3.1");
        for (int again = 0; again < 2; ++again) {
            const std::vector<Vec3> out = oidn.denoised(planes.picture(), StopFlag{});
            ASSERT_EQ(out.size(), planes.radiance.size());
            for (std::size_t i = 0; i < out.size(); ++i) EXPECT_EQ(out[i], all_of(planes, i)) << i;
        }
    }
}

// Catches guides that aren't there but are handed over, and colours without them said to be guided by clean ones.
TEST(Oidn, DoesWithoutGuides) {
    const Planes planes;
    const OpenImageDenoise oidn(Names{kVersion2});
    NoisyPicture picture = planes.picture();
    picture.albedo = {};
    EXPECT_EQ(oidn.denoised(picture, StopFlag{}), planes.radiance) << "normals go with albedo alone";
    picture.normal = {};
    picture.depth = {};
    EXPECT_EQ(oidn.denoised(picture, StopFlag{}), planes.radiance);
    picture.radiance = picture.radiance.first(3);
    EXPECT_THROW((void)oidn.denoised(picture, StopFlag{}), std::invalid_argument);
}

// Catches numbers that the library's documentation forbids.
TEST(Oidn, KeepsToTheRangesOfPlanes) {
    Planes planes;
    planes.radiance[0] = {-1, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
    planes.albedo[0] = {2, -1, std::numeric_limits<float>::quiet_NaN()};
    planes.normal[0] = {2, -2, std::numeric_limits<float>::quiet_NaN()};
    const OpenImageDenoise oidn(Names{kVersion2});
    EXPECT_EQ(oidn.denoised(planes.picture(), StopFlag{})[0], (Vec3{1000 + 10 + 100, 1000 - 100, 1000}));
}

// Catches a search that ends at the first name, and errors that don't say what was looked for or what is missing.
TEST(Oidn, LooksForAllNamesAndSaysThem) {
    EXPECT_EQ(OpenImageDenoise(Names{"libnone.so.2", FAKE_OIDN_LACKING, kVersion1}).version(), "1.4.3");
    const std::string error = error_of({"libnone.so.2", FAKE_OIDN_LACKING, "libnone.so"});
    EXPECT_NE(error.find("libnone.so.2: "), std::string::npos) << error;
    EXPECT_NE(error.find(FAKE_OIDN_LACKING " lacks oidnExecuteFilter; libnone.so: "), std::string::npos) << error;
    for (const std::string& name : oidn_names()) EXPECT_TRUE(name.starts_with("libOpenImageDenoise.so")) << name;
}

// Catches a device that fails, or isn't made at all, without its own message.
TEST(Oidn, PassesTheDevicesMessageOn) {
    EXPECT_EQ(error_of({FAKE_OIDN_NO_DEVICE}), "Open Image Denoise: no device of this kind");
    EXPECT_EQ(error_of({FAKE_OIDN_BAD_DEVICE}), "Open Image Denoise: the hardware is not supported");
    const Planes planes;
    const OpenImageDenoise oidn(Names{FAKE_OIDN_BAD_EXECUTE});
    try {
        (void)oidn.denoised(planes.picture(), StopFlag{});
        ADD_FAILURE() << "the failure was not noticed";
    } catch (const OidnError& error) {
        EXPECT_STREQ(error.what(), "Open Image Denoise: there is not enough memory");
    }
}

// Catches a picture that can't be stopped, and one before that makes the next fail.
TEST(Oidn, StopsAndGoesOn) {
    const Planes planes;
    const OpenImageDenoise oidn(Names{kVersion2});
    StopFlag stop;
    stop.request();
    EXPECT_TRUE(oidn.denoised(planes.picture(), stop).empty());
    stop.clear();
    EXPECT_FALSE(oidn.denoised(planes.picture(), stop).empty());
}

// Catches the filter where the library is, the library where the filter was asked for, and no error where neither.
TEST(Denoiser, ChoosesByMethodAndWhatIsThere) {
    const Names there{kVersion2}, nowhere{"libnone.so"};
    const Planes planes;
    const auto name_of = [](Method method, const Names& names) { return Denoiser(method, names).name(); };
    EXPECT_EQ(name_of(Method::automatic, there), "Open Image Denoise 2.3.1");
    EXPECT_EQ(name_of(Method::oidn, there), "Open Image Denoise 2.3.1");
    EXPECT_EQ(name_of(Method::filter, there), "Sundog's filter");
    EXPECT_EQ(name_of(Method::automatic, nowhere), "Sundog's filter");
    EXPECT_EQ(name_of(Method::automatic, {FAKE_OIDN_LACKING}), "Sundog's filter");
    EXPECT_EQ(name_of(Method::automatic, {FAKE_OIDN_BAD_DEVICE}), "Sundog's filter");
    EXPECT_THROW(Denoiser(Method::oidn, nowhere), OidnError);
    EXPECT_THROW(Denoiser(Method::oidn, Names{FAKE_OIDN_BAD_DEVICE}), OidnError);
    EXPECT_EQ(Denoiser(Method::oidn, there).denoised(planes.picture(), StopFlag{})[9], all_of(planes, 9));
    EXPECT_EQ(Denoiser(Method::filter, there).denoised(planes.picture(), StopFlag{}),
              denoised(planes.picture(), StopFlag{}));
}

// Catches a picture that is lost with the library, and a failure that nobody is told.
TEST(Denoiser, FiltersWhereTheLibraryFails) {
    const Planes planes;
    Denoiser denoiser(Method::oidn, Names{FAKE_OIDN_BAD_EXECUTE});
    EXPECT_EQ(denoiser.failure(), "");
    EXPECT_EQ(denoiser.denoised(planes.picture(), StopFlag{}), denoised(planes.picture(), StopFlag{}));
    EXPECT_EQ(denoiser.failure(), "Open Image Denoise: there is not enough memory");
    EXPECT_EQ(denoiser.name(), "Sundog's filter");
}

}  // namespace
}  // namespace sundog::denoise
