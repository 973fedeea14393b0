// SPDX-License-Identifier: Apache-2.0
// Ctrl-C.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "program.h"

namespace sundog::tests {
namespace {

enum class Readiness { not_yet, ready, ended };

/// Whether the process handles SIGINT itself by now (the mask of caught signals in /proc/PID/status).
Readiness readiness_of(pid_t pid) {
    std::ifstream in("/proc/" + std::to_string(pid) + "/status");
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("State:") && line.find('Z') != std::string::npos) return Readiness::ended;
        if (line.starts_with("SigCgt:") && ((std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1)) & 1U))
            return Readiness::ready;
    }
    return Readiness::not_yet;
}

/// Sends SIGINT as soon as the program is ready for it; false if it never is.
bool interrupt_when_ready(const Program& program) {
    for (int i = 0; i < 6000; ++i) {
        const Readiness readiness = readiness_of(program.pid());
        if (readiness == Readiness::ended) return false;
        if (readiness == Readiness::ready) {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));  // Let it do something worth writing.
            return kill(program.pid(), SIGINT) == 0;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

// Catches an interrupt that loses the picture, leaves half a file, or takes as long as the whole render.
TEST(Interrupt, WritesWhatIsDone) {
    const TemporaryFolder folder;
    Program program({"render", table_scene(), "-o", (folder / "a.ppm").string(), "--size", "640x480", "--spp", "65536",
                     "--device", "cpu"});
    ASSERT_TRUE(interrupt_when_ready(program));
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted: wrote what was done"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_bytes(folder / "a.ppm").size(), std::string("P6\n640 480\n255\n").size() + 640UL * 480 * 3);
}

// Catches an interrupted animation that keeps a half-rendered frame.
TEST(Interrupt, KeepsOnlyWholeFrames) {
    const TemporaryFolder folder;
    Program program({"render", table_scene(), "-o", (folder / "a.ppm").string(), "--size", "640x480", "--spp", "65536",
                     "--frames", "0..9", "--device", "cpu"});
    ASSERT_TRUE(interrupt_when_ready(program));
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted: wrote 0 of 10 frames"), std::string::npos) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace sundog::tests
