// SPDX-License-Identifier: Apache-2.0
// Drives the real window on a virtual screen and looks at what it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <thread>

#include "output/image.h"
#include "viewer/virtual_screen.h"

namespace sundog::viewer {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr double kPatience_s = 60;  // for a busy machine; nothing takes a second on an idle one
// Shares of pixels that differ: less than the first between a view at reduced
// resolution and the same one refined, more than the second between different
// views.
constexpr double kSame = 0.04;
constexpr double kMoved = 0.10;

// A red and a green wall that meet in an edge, on a blue sky: turning them
// changes the picture everywhere.
constexpr const char* kModel =
    "mtllib walls.mtl\n"
    "v -2 0 -1\nv 0 -2 -1\nv 0 -2 1\nv -2 0 1\nv 2 0 -1\nv 2 0 1\n"
    "o left\nusemtl red\nf 1 2 3 4\no right\nusemtl green\nf 2 5 6 3\n";
constexpr const char* kMaterials = "newmtl red\nKd 0.9 0.1 0.1\nnewmtl green\nKd 0.1 0.9 0.1\n";
constexpr const char* kScene =
    "model = walls.obj\nfocus = 12\nrotX = const -20\ndistance = 5\norigin = 0 "
    "0 0\n"
    "light = sun const\nlightPos = 1 -3 2\nsky = 0.2 0.3 0.6\n";
constexpr const char* kStill = "rotZ = const 10\n";
constexpr const char* kTurning = "rotZ = linear 40\n";

class WindowTest : public testing::Test {
protected:
    void SetUp() override {
        if (!VirtualScreen::available()) GTEST_SKIP() << "needs the programs Xvfb (package xvfb) and xdotool";
        folder_ = std::filesystem::path(testing::TempDir()) /
                  (std::string("sundog_window_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        write("walls.obj", kModel);
        write("walls.mtl", kMaterials);
        screen_.emplace(folder_, kWidth, kHeight);
    }
    void TearDown() override {
        window_.reset();
        screen_.reset();
        std::filesystem::remove_all(folder_);
    }

    void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    // Opens the window and waits for its first picture.
    void open(const std::string& motion, const std::vector<std::string>& what = {"walls.scene"}) {
        write("walls.scene", kScene + motion);
        std::vector<std::string> command{SUNDOG_PROGRAM, "view", "--device", "cpu"};
        command.insert(command.end(), what.begin(), what.end());
        window_.emplace(
            command,
            std::vector<std::string>{screen_->display_variable(), "SDL_RENDER_DRIVER=software", "SDL_VIDEODRIVER=x11"},
            folder_);
        ASSERT_TRUE(becomes([&] { return colors(picture()) > 2; })) << "no picture";
    }
    static bool becomes(const std::function<bool()>& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience_s);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        return true;
    }
    // The middle of the window, which no panel covers.
    [[nodiscard]] Screenshot picture() const { return screen_->look(285, 190, 420, 290); }
    // Where messages stand: below the middle.
    [[nodiscard]] Screenshot messages() const { return screen_->look(40, 340, kWidth - 40, kHeight - 60); }
    // Waits until the picture stands still, for as long as an animation would
    // surely move.
    Screenshot settled() const {
        Screenshot last = picture();
        int same = 0;
        (void)becomes([&] {
            const Screenshot now = picture();
            same = difference(now, last, 8) < 0.002 ? same + 1 : 0;
            last = now;
            return same >= 7;
        });
        EXPECT_GE(same, 7) << "the picture never stands still";
        return last;
    }
    void drag(int button, int dx, int dy) const {
        const std::string which = std::to_string(button);
        screen_->act({"mousemove", "320", "260", "mousedown", which, "mousemove_relative", "--sync", "--",
                      std::to_string(dx / 2), std::to_string(dy / 2), "mousemove_relative", "--sync", "--",
                      std::to_string(dx - dx / 2), std::to_string(dy - dy / 2), "mouseup", which});
    }
    void press(const char* key) const { screen_->act({"key", key}); }

    std::filesystem::path folder_;
    std::optional<VirtualScreen> screen_;
    std::optional<Process> window_;
};

// Catches a window that stays black or shows the wrong colours, and a quit that
// crashes or hangs.
TEST_F(WindowTest, ShowsTheSceneAndQuits) {
    open(kStill);
    const Screenshot shot = settled();
    const std::uint32_t left = shot.at(4, 70);
    const std::uint32_t right = shot.at(125, 70);
    EXPECT_GT(left >> 16, 2 * (left >> 8 & 0xff)) << std::hex << left;     // red
    EXPECT_GT(right >> 8 & 0xff, 2 * (right >> 16)) << std::hex << right;  // green
    press("Escape");
    EXPECT_EQ(window_->wait(kPatience_s), 0);
}

// Catches gestures that don't reach the camera, and a Home key that doesn't
// bring the scene's own view back.
TEST_F(WindowTest, DragsTurnTheViewAndHomeBringsItBack) {
    open(kStill);
    const Screenshot home = settled();
    for (const int button : {1, 2, 3}) {
        drag(button, 90, 50);
        EXPECT_TRUE(becomes([&] { return difference(picture(), home, 30) > kMoved; })) << "button " << button;
        press("Home");
        EXPECT_TRUE(becomes([&] { return difference(picture(), home, 30) < kSame; })) << "button " << button;
    }
    screen_->act({"mousemove", "320", "260", "click", "4", "click", "4", "click", "4"});
    EXPECT_TRUE(becomes([&] { return difference(picture(), home, 30) > kMoved; })) << "wheel";
    press("Home");
    screen_->act({"keydown", "d", "sleep", "0.5", "keyup", "d"});
    EXPECT_TRUE(becomes([&] { return difference(picture(), home, 30) > kMoved; })) << "flying";
}

// Catches an animation that stands still, or doesn't stop.
TEST_F(WindowTest, SpacePausesAndPlays) {
    open(kTurning);
    const Screenshot first = picture();
    EXPECT_TRUE(becomes([&] { return difference(picture(), first, 30) > kMoved; }));
    press("space");
    const Screenshot paused = settled();
    press("space");
    EXPECT_TRUE(becomes([&] { return difference(picture(), paused, 30) > kMoved; }));
}

// Catches an edit that isn't noticed, that moves the camera, or, if broken,
// ends the picture or goes unmentioned.
TEST_F(WindowTest, FollowsEditsAndShowsTheirErrors) {
    open(kStill);
    const Screenshot before = settled();
    const Screenshot no_message = messages();
    write("walls.scene", std::string(kScene) + kStill + "focsu = 3\n");
    EXPECT_TRUE(becomes([&] { return difference(messages(), no_message, 30) > 0.2; })) << "no message";
    EXPECT_LT(difference(picture(), before, 30), kSame);
    write("walls.scene", std::string(kScene) + kStill);
    EXPECT_TRUE(becomes([&] { return difference(messages(), no_message, 30) < 0.01; })) << "the message stays";
    write("walls.mtl", "newmtl red\nKd 0.1 0.1 0.9\nnewmtl green\nKd 0.1 0.9 0.1\n");
    EXPECT_TRUE(becomes([&] {
        const std::uint32_t left = picture().at(4, 70);
        return (left & 0xff) > 2 * (left >> 16);  // blue now, where it was
    })) << "the edit was not shown";
}

// Catches POV-Ray scenes whose own camera can't be left or found again, edits of included files that go unnoticed, and
// broken ones that end the picture.
TEST_F(WindowTest, ShowsPovScenesAndFollowsTheirIncludes) {
    write("paint.inc", "#declare Left = rgb <0.9, 0.1, 0.1>;\n");
    write("walls.pov",
          "#version 3.7;\n#include \"paint.inc\"\nglobal_settings { assumed_gamma 1 }\n"
          "camera { location <0, 1, -5> look_at 0 angle 60 }\nlight_source { <1, 3, -4> rgb 1 }\n"
          "box { <-2, -1, -0.1>, <0, 1, 0> pigment { Left } rotate -y*20 }\n"
          "box { <0, -1, -0.1>, <2, 1, 0> pigment { rgb <0.1, 0.9, 0.1> } rotate y*20 }\n"
          "background { rgb <0.2, 0.3, 0.6> }\n");
    open(kStill, {"walls.pov"});
    const Screenshot home = settled();
    const Screenshot no_message = messages();
    drag(1, 90, 50);
    EXPECT_TRUE(becomes([&] { return difference(picture(), home, 30) > kMoved; })) << "the camera stays";
    press("Home");
    EXPECT_TRUE(becomes([&] { return difference(picture(), home, 30) < kSame; })) << "the camera stays away";
    write("paint.inc", "#declare Left = rgb <0.1, 0.1;\n");
    EXPECT_TRUE(becomes([&] { return difference(messages(), no_message, 30) > 0.2; })) << "no message";
    EXPECT_LT(difference(picture(), home, 30), kSame);
    write("paint.inc", "#declare Left = rgb <0.1, 0.1, 0.9>;\n");
    EXPECT_TRUE(becomes([&] {
        const std::uint32_t left = picture().at(4, 50);
        return (left & 0xff) > 2 * (left >> 16);  // blue now, where it was red
    })) << "the edit was not shown";
}

// Catches settings of raytracer.conf that the window doesn't heed: its size, whether it fills the screen, the moment.
TEST_F(WindowTest, HeedsTheConfiguration) {
    const std::string settings = "defaultScene = walls.scene\nwidth = 320\nheight = 240\nfreeze = 0.25\n";
    // A corner of the screen: the sky where the window fills it, else black.
    const auto corner = [&] { return screen_->look(2, kHeight - 4, 4, kHeight - 2).at(0, 0); };
    write("raytracer.conf", settings);
    open(kTurning, {});
    settled();
    EXPECT_EQ(corner(), 0U);
    press("Escape");
    ASSERT_EQ(window_->wait(kPatience_s), 0);
    write("raytracer.conf", settings + "fullscreen = true\n");
    open(kTurning, {});
    EXPECT_TRUE(becomes([&] { return corner() != 0; })) << "it doesn't fill the screen";
}

// Catches a pick that shows nothing.
TEST_F(WindowTest, PicksAPixel) {
    open(kStill);
    settled();
    const auto corner = [&] { return screen_->look(kWidth - 160, 20, kWidth - 20, 120); };
    const Screenshot before = corner();
    screen_->act({"mousemove", "285", "260", "keydown", "ctrl", "click", "1", "keyup", "ctrl"});
    EXPECT_TRUE(becomes([&] { return difference(corner(), before, 20) > 0.3; }));
}

// Catches a key that doesn't show where rays went, or leaves them there.
TEST_F(WindowTest, PaintsTracedPixelsWhite) {
    open(kStill);
    settled();
    const auto white = [&] {
        const Screenshot shot = picture();
        return std::count_if(shot.pixels.begin(), shot.pixels.end(),
                             [](std::uint32_t pixel) { return (pixel & 0xffffffU) == 0xffffffU; });
    };
    const auto before = white();  // the mouse pointer's
    EXPECT_LT(before, 50);
    press("r");
    EXPECT_TRUE(becomes([&] { return white() > before + 100; }));
    const Screenshot painted = settled();
    EXPECT_GT(white(), before + 100) << "they vanish at rest";
    EXPECT_LT(white(), static_cast<std::ptrdiff_t>(painted.pixels.size()) / 2);
    press("r");
    EXPECT_TRUE(becomes([&] { return white() == before; }));
}

// Catches a save that writes nothing, overwrites, writes another picture than the one shown, or moves the camera.
TEST_F(WindowTest, SavesThePicture) {
    open(kStill);
    const Screenshot shown = settled();
    write("walls-0001.png", "precious");
    press("ctrl+s");
    const auto saved = folder_ / "walls-0002.png";
    ASSERT_TRUE(becomes([&] { return std::filesystem::exists(saved) && std::filesystem::file_size(saved) > 0; }));
    EXPECT_EQ(std::filesystem::file_size(folder_ / "walls-0001.png"), 8U);
    const output::Image image = output::read_image(saved);
    ASSERT_EQ(image.width, kWidth);
    ASSERT_EQ(image.height, kHeight);
    output::Image part(shown.width, shown.height);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) part.at(x, y) = image.at(285 + x, 190 + y);
    const std::vector<std::uint8_t> bytes = output::to_srgb8(part);
    Screenshot from_file{part.width, part.height, {}};
    for (std::size_t i = 0; i < bytes.size(); i += 3)
        from_file.pixels.push_back(static_cast<std::uint32_t>(bytes[i] << 16 | bytes[i + 1] << 8 | bytes[i + 2]));
    EXPECT_LT(difference(from_file, shown, 40), kSame);
    // Who lets go of Ctrl before S has not asked to fly.
    screen_->act({"keydown", "ctrl", "keydown", "s", "keyup", "ctrl", "sleep", "0.5", "keyup", "s"});
    ASSERT_TRUE(becomes([&] { return std::filesystem::exists(folder_ / "walls-0003.png"); }));
    EXPECT_LT(difference(settled(), shown, 30), kSame);
}

}  // namespace
}  // namespace sundog::viewer
