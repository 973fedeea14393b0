// SPDX-License-Identifier: Apache-2.0
#include "output/progress_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sundog::output {
namespace {

// Catches wrong carries between seconds, minutes and hours, and numbers without sense being shown.
TEST(ProgressLine, Durations) {
    EXPECT_EQ(format_duration(0), "0:00");
    EXPECT_EQ(format_duration(7.4), "0:07");
    EXPECT_EQ(format_duration(59.6), "1:00");
    EXPECT_EQ(format_duration(754), "12:34");
    EXPECT_EQ(format_duration(3599.7), "1:00:00");
    EXPECT_EQ(format_duration(3723), "1:02:03");
    for (const double unknown : {-1.0, 1e300, static_cast<double>(INFINITY), static_cast<double>(NAN)})
        EXPECT_EQ(format_duration(unknown), "-:--");
}

// Catches units that change too late ("1000 k") and digits beyond the third.
TEST(ProgressLine, Rates) {
    EXPECT_EQ(format_rate(0, "rays"), "0 rays/s");
    EXPECT_EQ(format_rate(999.4, "rays"), "999 rays/s");
    EXPECT_EQ(format_rate(999.6, "rays"), "1.00 krays/s");
    EXPECT_EQ(format_rate(12'345, "rays"), "12.3 krays/s");
    EXPECT_EQ(format_rate(999'960, "rays"), "1.00 Mrays/s");
    EXPECT_EQ(format_rate(99.96e6, "rays"), "100 Mrays/s");
    EXPECT_EQ(format_rate(1.234e9, "rays"), "1.23 Grays/s");
    EXPECT_EQ(format_rate(NAN, "frames"), "0 frames/s");
}

// Catches a wrong time left (seconds * rest / done) and a bar or share that says done before it is.
TEST(ProgressLine, Text) {
    EXPECT_EQ(progress_text({0.42, 5, 61'500'000}), "[####------]  42%  12.3 Mrays/s  0:07 left");
    EXPECT_EQ(progress_text({0, 0, 0}), "[----------]   0%  0 rays/s  -:-- left");
    EXPECT_EQ(progress_text({0.9999, 10'000, 10'000}), "[#########-]  99%  1 rays/s  0:01 left");
    EXPECT_EQ(progress_text({1, 2, 4000}), "[##########] 100%  2.00 krays/s  0:00 left");
}

// Catches output into files and pipes.
TEST(ProgressLine, IsSilentWhereThereIsNoTerminal) {
    std::ostringstream out;
    {
        ProgressLine line(out, false);
        line({0.5, 1, 1});
        line({1, 2, 1});
    }
    EXPECT_EQ(out.str(), "");
}

// Catches redrawing for every report, and a last report that is swallowed by the limit.
TEST(ProgressLine, DrawsTenTimesASecond) {
    std::ostringstream out;
    ProgressLine line(out, true);
    for (int i = 0; i < 1000; ++i) line({i / 1000.0, i / 1000.0, 1000});
    const std::string drawn = out.str();
    const auto count = std::count(drawn.begin(), drawn.end(), '\r');
    EXPECT_GE(count, 9);
    EXPECT_LE(count, 11);
    line({1, 0.9995, 1000});
    EXPECT_NE(out.str().find("100%"), std::string::npos);
    EXPECT_EQ(out.str().find('\n'), std::string::npos);
}

// Catches the ends of longer lines left on the screen.
TEST(ProgressLine, LeavesNothingBehind) {
    std::ostringstream out;
    ProgressLine line(out, true);
    line({0.001, 3000, 1'000'000'000});
    const std::size_t longest = out.str().size() - 1;
    out.str("");
    line({0.99, 3001, 0});
    EXPECT_EQ(out.str().size() - 1, longest);
    out.str("");
    line.clear();
    EXPECT_EQ(out.str(), std::string("\r").append(longest, ' ').append("\r"));
    out.str("");
    line.clear();
    EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace sundog::output
