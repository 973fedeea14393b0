// SPDX-License-Identifier: Apache-2.0
#include "output/video.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "base/diagnostics.h"
#include "output/test_files.h"

namespace sundog::output {
namespace {

std::string output_of(const std::string& command) {
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 256> buffer{};
    std::string text;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        text.append(buffer.data(), count);
    ::pclose(pipe);
    return text;
}

bool ffmpeg_is_installed() { return !output_of("command -v ffmpeg && command -v ffprobe").empty(); }

/// "width,height,frames" as ffprobe counts them by decoding.
std::string probed(const std::filesystem::path& file) {
    return output_of(
        "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
        "stream=width,height,nb_read_frames -of csv=p=0 '" +
        file.string() + "'");
}

/// A bright bar that moves to the right.
Image frame_at(int time, int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = x / 4 == time ? Vec3{1, 0.9F, 0.1F} : Vec3{0.05F, 0.1F, 0.3F};
    return image;
}

std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const OutputError& error) {
        return error.what();
    }
    return "no error";
}

/// Sets PATH while it lives.
class Path {
public:
    explicit Path(const std::string& value) : before_(old_path()) { ::setenv("PATH", value.c_str(), 1); }
    ~Path() { ::setenv("PATH", before_.c_str(), 1); }
    Path(const Path&) = delete;
    Path& operator=(const Path&) = delete;

private:
    static std::string old_path() {
        const char* path = std::getenv("PATH");
        return path != nullptr ? path : "";
    }
    std::string before_;
};

// Catches lost or doubled frames, wrong sizes (only MP4 pads odd ones), odd file names taken for options, and
// temporary files left behind.
TEST(Video, EveryKindHoldsItsFrames) {
    if (!ffmpeg_is_installed()) GTEST_SKIP() << "ffmpeg is not installed";
    for (const auto& [name, expected] :
         {std::pair{"-a:b c.mp4", "38,22,7\n"}, std::pair{"a.WebM", "37,21,7\n"}, std::pair{"a.gif", "37,21,7\n"}}) {
        const TemporaryFolder folder;
        VideoWriter video(folder / name, 37, 21, 12.5);
        for (int time = 0; time < 7; ++time) video.add(frame_at(time, 37, 21));
        video.finish();
        EXPECT_EQ(probed(folder / name), expected) << name;
        EXPECT_EQ(folder.entries(), 1U) << name;
    }
}

// Catches swapped channels and a wrong colour matrix: the first frame of a GIF comes back.
TEST(Video, GifKeepsColours) {
    if (!ffmpeg_is_installed()) GTEST_SKIP() << "ffmpeg is not installed";
    const TemporaryFolder folder;
    VideoWriter video(folder / "a.gif", 32, 16, 10);
    for (int time = 0; time < 3; ++time) video.add(frame_at(time, 32, 16));
    video.finish();
    const std::vector<std::uint8_t> read = to_srgb8(read_image(folder / "a.gif"));
    const std::vector<std::uint8_t> expected = to_srgb8(frame_at(0, 32, 16));
    ASSERT_EQ(read.size(), expected.size());
    for (std::size_t i = 0; i < read.size(); ++i) ASSERT_NEAR(read[i], expected[i], 6) << i;
}

// Catches a video that replaces the old file before it is whole.
TEST(Video, DroppedWithoutFinishLeavesTheOldFile) {
    if (!ffmpeg_is_installed()) GTEST_SKIP() << "ffmpeg is not installed";
    const TemporaryFolder folder;
    put(folder / "a.mp4", "old");
    {
        VideoWriter video(folder / "a.mp4", 16, 16, 25);
        video.add(frame_at(0, 16, 16));
    }
    EXPECT_EQ(get(folder / "a.mp4"), "old");
    EXPECT_EQ(folder.entries(), 1U);
    EXPECT_NE(error_of([&] { VideoWriter(folder / "a.mp4", 16, 16, 25).finish(); }).find("without frames"),
              std::string::npos);
    EXPECT_EQ(get(folder / "a.mp4"), "old");
}

// Catches a missing program that isn't explained.
TEST(Video, SaysThatFfmpegIsMissing) {
    const TemporaryFolder folder;
    const Path path((folder / "").string());
    const std::string message = error_of([&] { VideoWriter(folder / "a.mp4", 16, 16, 25); });
    EXPECT_NE(message.find("ffmpeg, which is not installed"), std::string::npos) << message;
    EXPECT_EQ(folder.entries(), 0U);
}

// Catches a program that fails early killing us by SIGPIPE, its message being lost, or its leavings kept.
TEST(Video, TellsWhatAFailingFfmpegSaid) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "bin");
    put(folder / "bin/ffmpeg", "#!/bin/sh\necho 'no such codec' >&2\nexit 3\n");
    std::filesystem::permissions(folder / "bin/ffmpeg", std::filesystem::perms::owner_all);
    put(folder / "a.gif", "old");
    const Path path((folder / "bin").string());
    const std::string message = error_of([&] {
        VideoWriter video(folder / "a.gif", 320, 200, 25);
        for (int time = 0; time < 50; ++time) video.add(frame_at(time, 320, 200));
        video.finish();
    });
    EXPECT_NE(message.find("a.gif': ffmpeg failed:\nno such codec"), std::string::npos) << message;
    EXPECT_EQ(get(folder / "a.gif"), "old");
    EXPECT_EQ(folder.entries(), 2U);
}

// Catches names and frames that don't fit being passed on.
TEST(Video, RefusesWhatDoesNotFit) {
    EXPECT_TRUE(is_video("a/b.MP4"));
    EXPECT_FALSE(is_video("a.png"));
    EXPECT_NE(error_of([] { VideoWriter("a.avi", 16, 16, 25); }).find(".mp4 .webm .gif"), std::string::npos);
    EXPECT_THROW(VideoWriter("a.gif", 0, 16, 25), std::invalid_argument);
    EXPECT_THROW(VideoWriter("a.gif", 16, 16, 0), std::invalid_argument);
    EXPECT_NE(error_of([] { VideoWriter("/no-such-folder/a.gif", 16, 16, 25); }).find("no folder '/no-such-folder'"),
              std::string::npos);
    if (!ffmpeg_is_installed()) return;
    const TemporaryFolder folder;
    VideoWriter video(folder / "a.gif", 16, 16, 25);
    EXPECT_THROW(video.add(frame_at(0, 16, 17)), std::invalid_argument);
}

}  // namespace
}  // namespace sundog::output
