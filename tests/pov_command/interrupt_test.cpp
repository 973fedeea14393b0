// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "output/image.h"
#include "program.h"

namespace sundog::tests {
namespace {

// Catches Ctrl-C that loses what was done, or that ends with another status than povray's 2.
TEST(PovInterrupt, KeepsWhatIsDone) {
    const TemporaryFolder folder;
    write_bytes(folder / "slow.pov", R"(#version 3.7;
camera { location -4*z look_at 0 }
light_source { <5, 5, -5> rgb 1 }
#debug "parsed\n"
union { sphere { 0, 1 } sphere { x, 0.5 } pigment { rgb 1 } finish { reflection 0.5 } }
)");
    Program program({"pov", "slow.pov", "+W3000", "+H3000", "+A0.0", "+R9", "+GDparsed.txt"}, folder.path());
    for (int i = 0; i < 600 && read_bytes(folder / "parsed.txt").empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    kill(program.pid(), SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("halted by user"), std::string::npos) << outcome.err;
    EXPECT_EQ(output::read_image(folder / "slow.png").width, 3000);
}

}  // namespace
}  // namespace sundog::tests
