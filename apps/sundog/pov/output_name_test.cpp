// SPDX-License-Identifier: Apache-2.0
// The expected names and regions are those that povray 3.7 wrote for the same switches.
#include "output_name.h"

#include <gtest/gtest.h>

#include "../usage_error.h"
#include "command_line.h"

namespace sundog::app {
namespace {

PovSettings settings(const std::vector<std::string>& words) {
    return read_command_line(words, {"/nowhere", {}, {}, {}}, {});
}
std::string name(const std::vector<std::string>& words, int frame = 0) {
    const PovSettings s = settings(words);
    return picture_file(s, animation_of(s), frame).string();
}

// Catches default names in the wrong folder or with the wrong ending.
TEST(OutputName, IsTheScenes) {
    EXPECT_EQ(name({"a.pov"}), "a.png");
    EXPECT_EQ(name({"sub/a.pov"}), "sub/a.png");
    EXPECT_EQ(name({"+Ifoo.bar.txt"}), "foo.bar.png");
    EXPECT_EQ(name({"a.pov", "+FJ"}), "a.jpg");
    EXPECT_EQ(name({"a.pov", "+FT"}), "a.tga");
    EXPECT_EQ(name({"a.pov", "+FC"}), "a.tga");
    EXPECT_EQ(name({"a.pov", "+FP"}), "a.ppm");
    EXPECT_EQ(name({"a.pov", "+FE"}), "a.exr");
    EXPECT_EQ(name({"a.pov", "+FH"}), "a.hdr");
    EXPECT_EQ(name({"a.pov", "+FB"}), "a.bmp");
}

// Catches endings that are doubled, replaced or missing.
TEST(OutputName, IsTheGivenOneWithTheFormatsEnding) {
    EXPECT_EQ(name({"a.pov", "+Ofoo"}), "foo.png");
    EXPECT_EQ(name({"a.pov", "+Ofoo.png"}), "foo.png");
    EXPECT_EQ(name({"a.pov", "+Ofoo.bar"}), "foo.bar.png");
    EXPECT_EQ(name({"a.pov", "+Ofoo.PNG"}), "foo.PNG.png");
    EXPECT_EQ(name({"a.pov", "+Ofoo.jpg"}), "foo.jpg.png");
    EXPECT_EQ(name({"a.pov", "+Ofoo.jpeg", "+FJ"}), "foo.jpeg.jpg");
    EXPECT_EQ(name({"sub/a.pov", "+Ox.png"}), "x.png");
    EXPECT_EQ(name({"scenes/a.pov", "+Osub/"}), "sub/a.png");
    EXPECT_EQ(name({"a.pov", "+O-"}), "-");
    // VMD's command line
    EXPECT_EQ(name({"-Ivmdscene.pov", "-Ovmdscene.pov.tga", "+D", "+X", "+A", "+FT"}), "vmdscene.pov.tga");
}

// Catches frames that overwrite one another or sort wrongly.
TEST(OutputName, FramesAreNumbered) {
    EXPECT_EQ(name({"a.pov", "+KFF3"}, 2), "a2.png");
    EXPECT_EQ(name({"a.pov", "+KFF100"}, 2), "a002.png");
    EXPECT_EQ(name({"a.pov", "+KFF12", "+Ofoo7.png"}, 3), "foo703.png");
    EXPECT_EQ(name({"a.pov", "+KFF9", "+KC", "+Osub/"}, 3), "sub/a03.png");
}

struct Spans {
    int x0, x1, y0, y1;
};
Spans spans(std::vector<std::string> words) {
    words.insert(words.end(), {"+W80", "+H60"});
    const PovRegion region = region_of(settings(words));
    return {region.x0, region.x1, region.y0, region.y1};
}
bool operator==(Spans a, Spans b) { return a.x0 == b.x0 && a.x1 == b.x1 && a.y0 == b.y0 && a.y1 == b.y1; }

// Catches columns and rows that are off by one, or fractions taken for pixels.
TEST(Region, ColumnsAndRows) {
    EXPECT_TRUE((spans({}) == Spans{0, 80, 0, 60}));
    EXPECT_TRUE((spans({"+SC10", "+EC20", "+SR30", "+ER40"}) == Spans{9, 20, 29, 40}));
    EXPECT_TRUE((spans({"+SC0.25", "+EC0.5", "+SR0.25", "+ER0.5"}) == Spans{20, 40, 15, 30}));
    EXPECT_TRUE((spans({"+SC1", "+EC1"}) == Spans{0, 80, 0, 60})) << "1 is the first start and the last end";
    EXPECT_TRUE((spans({"+SC0", "+SR0.0"}) == Spans{0, 80, 0, 60}));
    EXPECT_TRUE((spans({"+EC2.5"}) == Spans{0, 2, 0, 60}));
    EXPECT_TRUE((spans({"+SC0.999"}) == Spans{79, 80, 0, 60}));
}

// Catches regions outside the picture.
TEST(Region, RefusesWhatLiesOutside) {
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"+SC90"}, {"+EC90"}, {"+EC0"}, {"+SC50", "+EC20"}, {"+SR61"}, {"+ER1e300"}, {"+SR1e300"}})
        EXPECT_THROW(spans(words), UsageError) << words[0];
}

}  // namespace
}  // namespace sundog::app
