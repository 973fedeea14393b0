// SPDX-License-Identifier: Apache-2.0
// Plays the demo on a virtual screen.
#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>

#include "program.h"
#include "viewer/virtual_screen.h"

namespace sundog::viewer {
namespace {

constexpr double kPatience_s = 60;  // for a busy machine; nothing takes a second on an idle one

// Catches a window that stays black, a film that stands still, an Escape key that is slow or ends with an error, and a
// film that can't be seen where there is nothing to hear it with.
TEST(IntroWindow, PlaysUntilTheEscapeKey) {
    if (!VirtualScreen::available()) GTEST_SKIP() << "needs the programs Xvfb (package xvfb) and xdotool";
    const tests::TemporaryFolder folder;
    const VirtualScreen screen(folder.path(), 320, 180);
    Process film({SUNDOG_PROGRAM, "--window", "320x180"},
                 {screen.display_variable(), "SDL_RENDER_DRIVER=software", "SDL_VIDEODRIVER=x11"}, folder.path());
    const auto picture = [&screen] { return screen.look(20, 20, 300, 160); };
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience_s);
    std::optional<Screenshot> first;
    bool moved = false;
    while (!moved && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        if (const auto status = film.wait(0)) {
            if (*status == 1) GTEST_SKIP() << "it says that this processor lacks AVX2";
            FAIL() << "it ended by itself with " << *status;
        }
        const Screenshot now = picture();
        if (!first && colors(now) > 100) first = now;
        moved = first && difference(*first, now, 8) > 0.2;
    }
    EXPECT_TRUE(first.has_value()) << "no picture";
    EXPECT_TRUE(moved) << "the picture stands still";
    screen.act({"key", "Escape"});
    const std::optional<int> status = film.wait(20);
    ASSERT_TRUE(status.has_value()) << "Escape did not end it";
    EXPECT_EQ(*status, 0);
}

}  // namespace
}  // namespace sundog::viewer
