// SPDX-License-Identifier: Apache-2.0
// For tests: a screen without a monitor (Xvfb), a keyboard and mouse without
// hands (xdotool), and a look at the pixels.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sundog::viewer {

/// A program that was started; killed when this goes, if it still runs.
class Process {
public:
    /// arguments[0] is looked up in PATH. `environment` ("NAME=value") is added
    /// to ours; `pass_fd` stays open as 3.
    Process(std::vector<std::string> arguments, std::vector<std::string> environment,
            const std::filesystem::path& folder, std::optional<int> pass_fd = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    /// Exit status (128 + signal where one ended it), or empty if it still runs
    /// after `limit_s`.
    [[nodiscard]] std::optional<int> wait(double limit_s);

private:
    pid_t pid_ = -1;
    std::optional<int> status_;
};

/// Part of the screen as 0xRRGGBB.
struct Screenshot {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// Share of pixels in which any channel differs by more than `tolerance`, 0
/// to 1.
double difference(const Screenshot& a, const Screenshot& b, int tolerance);
/// How many different colours there are.
std::size_t colors(const Screenshot& shot);

/// An X server of its own, with a screen of the given size.
class VirtualScreen {
public:
    /// True if the programs that it needs are installed.
    static bool available();

    VirtualScreen(const std::filesystem::path& folder, int width, int height);
    /// For Process's environment.
    [[nodiscard]] std::string display_variable() const { return "DISPLAY=" + display_; }
    /// Pixels [x0, x1) x [y0, y1) as they are now.
    [[nodiscard]] Screenshot look(int x0, int y0, int x1, int y1) const;
    /// Runs xdotool with these words.
    void act(std::vector<std::string> words) const;

private:
    std::filesystem::path folder_;
    std::string display_;
    std::optional<Process> server_;
};

}  // namespace sundog::viewer
