// SPDX-License-Identifier: Apache-2.0
#include "viewer/file_watch.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

namespace sundog::viewer {
namespace {

class FileWatchTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ =
            std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
        write("a.scene", "one");
        write("b.mtl", "one");
        watch_.watch(std::array{path("a.scene"), path("b.mtl")});
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }
    void write(const char* name, const char* text) const { std::ofstream(folder_ / name) << text; }

    std::filesystem::path folder_;
    FileWatch watch_;
};

// Catches a reload without any change.
TEST_F(FileWatchTest, QuietWhileNothingChanges) {
    EXPECT_FALSE(watch_.changed());
    EXPECT_FALSE(watch_.changed());
}

// Catches a change that is missed, told twice, or told while the file may still be half written.
TEST_F(FileWatchTest, TellsAChangeOnceItHasSettled) {
    write("b.mtl", "longer");
    EXPECT_FALSE(watch_.changed());  // seen for the first time
    EXPECT_TRUE(watch_.changed());
    EXPECT_FALSE(watch_.changed());
}

// Catches a watch that only compares sizes.
TEST_F(FileWatchTest, SeesAnEditOfTheSameLength) {
    write("a.scene", "two");
    std::filesystem::last_write_time(path("a.scene"),
                                     std::filesystem::last_write_time(path("a.scene")) + std::chrono::seconds(1));
    EXPECT_FALSE(watch_.changed());
    EXPECT_TRUE(watch_.changed());
}

// Catches a reload in the moment in which an editor has moved the old file away.
TEST_F(FileWatchTest, WaitsForAFileThatIsGone) {
    std::filesystem::remove(path("a.scene"));
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(watch_.changed());
    write("a.scene", "three!");
    EXPECT_FALSE(watch_.changed());
    EXPECT_TRUE(watch_.changed());
}

// Catches a watch that waits for ever for a file that never was (a missing mtllib).
TEST_F(FileWatchTest, AFileThatNeverWasDoesNotHoldUpTheRest) {
    watch_.watch(std::array{path("a.scene"), path("missing.mtl")});
    write("a.scene", "four!");
    EXPECT_FALSE(watch_.changed());
    EXPECT_TRUE(watch_.changed());
    write("missing.mtl", "found");
    EXPECT_FALSE(watch_.changed());
    EXPECT_TRUE(watch_.changed());
}

// Catches the loss of a change that came while the scene was being read again.
TEST_F(FileWatchTest, WatchingAgainKeepsWhatWasKnown) {
    write("a.scene", "changed since");
    watch_.watch(std::array{path("a.scene")});
    EXPECT_FALSE(watch_.changed());
    EXPECT_TRUE(watch_.changed());
}

}  // namespace
}  // namespace sundog::viewer
