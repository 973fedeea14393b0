// SPDX-License-Identifier: Apache-2.0
#include "viewer/save_picture.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "base/diagnostics.h"

namespace sundog::viewer {
namespace {

class SavePictureTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ =
            std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
        image_.at(1, 0) = {1, 1, 1};
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_;
    output::Image image_{3, 2};
};

// Catches a picture that replaces an earlier one, or isn't a picture.
TEST_F(SavePictureTest, TakesTheFirstFreeNumber) {
    std::ofstream(folder_ / "table-0001.png") << "precious";
    EXPECT_EQ(save_numbered_png(folder_, "table", image_), folder_ / "table-0002.png");
    EXPECT_EQ(save_numbered_png(folder_, "table", image_), folder_ / "table-0003.png");
    std::ifstream precious(folder_ / "table-0001.png");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(precious), {}), "precious");
    const output::Image back = output::read_image(folder_ / "table-0003.png");
    ASSERT_EQ(back.width, 3);
    ASSERT_EQ(back.height, 2);
    EXPECT_EQ(back.at(1, 0), (Vec3{1, 1, 1}));
    EXPECT_EQ(back.at(0, 0), (Vec3{0, 0, 0}));
}

// Catches an endless search, or a crash, where nothing can be written.
TEST_F(SavePictureTest, SaysWhatCanNotBeWritten) {
    EXPECT_THROW((void)save_numbered_png(folder_ / "missing", "table", image_), OutputError);
}

}  // namespace
}  // namespace sundog::viewer
