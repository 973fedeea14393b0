// SPDX-License-Identifier: Apache-2.0
#include "viewer/virtual_screen.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace sundog::viewer {
namespace {

bool installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access(folder.append("/").append(program).c_str(), X_OK) == 0) return true;
    return false;
}

int status_of(int waited) { return WIFEXITED(waited) ? WEXITSTATUS(waited) : 128 + WTERMSIG(waited); }

std::uint32_t big_endian(const std::string& bytes, std::size_t word) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(4 * word + i));
    return value;
}

}  // namespace

Process::Process(std::vector<std::string> arguments, std::vector<std::string> environment,
                 const std::filesystem::path& folder, std::optional<int> pass_fd) {
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("fork failed");
    if (pid_ > 0) return;
    // The child: nothing but what leads to the program.
    for (std::string& variable : environment) putenv(variable.data());
    if (chdir(folder.c_str()) != 0) _exit(127);
    if (pass_fd && dup2(*pass_fd, 3) < 0) _exit(127);
    execvp(argv[0], argv.data());
    _exit(127);
}

Process::~Process() {
    if (wait(0)) return;
    kill(pid_, SIGKILL);
    (void)wait(5);
}

std::optional<int> Process::wait(double limit_s) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
    while (!status_) {
        int waited = 0;
        if (waitpid(pid_, &waited, WNOHANG) == pid_) {
            status_ = status_of(waited);
        } else {
            if (std::chrono::steady_clock::now() >= end) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }
    return status_;
}

double difference(const Screenshot& a, const Screenshot& b, int tolerance) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        int largest = 0;
        for (const int shift : {0, 8, 16}) {
            const int of_a = static_cast<int>(a.pixels[i] >> shift & 0xff);
            const int of_b = static_cast<int>(b.pixels[i] >> shift & 0xff);
            largest = std::max(largest, std::abs(of_a - of_b));
        }
        different += largest > tolerance;
    }
    return static_cast<double>(different) / static_cast<double>(a.pixels.size());
}

std::size_t colors(const Screenshot& shot) { return std::set(shot.pixels.begin(), shot.pixels.end()).size(); }

bool VirtualScreen::available() { return installed("Xvfb") && installed("xdotool"); }

VirtualScreen::VirtualScreen(const std::filesystem::path& folder, int width, int height) : folder_(folder) {
    // Xvfb picks a free display number and writes it to a pipe.
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe failed");
    server_.emplace(
        std::vector<std::string>{"Xvfb", "-displayfd", "3", "-screen", "0", fmt::format("{}x{}x24", width, height),
                                 "-fbdir", folder.string(), "-nolisten", "tcp"},
        std::vector<std::string>{}, folder, ends[1]);
    close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    if (number.empty()) throw std::runtime_error("Xvfb did not start");
    display_ = ":" + number;
}

Screenshot VirtualScreen::look(int x0, int y0, int x1, int y1) const {
    // Xvfb keeps the screen in a file in the format of xwd (X11/XWDFile.h).
    std::ifstream file(folder_ / "Xvfb_screen0", std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    constexpr std::size_t kHeaderSize = 0;
    constexpr std::size_t kBytesPerLine = 12;
    constexpr std::size_t kColors = 19;
    constexpr std::size_t kBytesPerColor = 12;
    const std::size_t first = big_endian(bytes, kHeaderSize) + kBytesPerColor * big_endian(bytes, kColors);
    const std::size_t pitch = big_endian(bytes, kBytesPerLine);
    Screenshot shot{x1 - x0, y1 - y0, {}};
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const std::size_t at = first + pitch * static_cast<std::size_t>(y) + 4 * static_cast<std::size_t>(x);
            const auto channel = [&](std::size_t i) {
                return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i)));
            };
            shot.pixels.push_back(channel(2) << 16 | channel(1) << 8 | channel(0));
        }
    }
    return shot;
}

void VirtualScreen::act(std::vector<std::string> words) const {
    words.insert(words.begin(), "xdotool");
    Process hands(std::move(words), {display_variable()}, folder_);
    if (hands.wait(20) != 0) throw std::runtime_error("xdotool failed");
}

}  // namespace sundog::viewer
