// SPDX-License-Identifier: Apache-2.0
// `sundog pov --format`: normalised language that gives the same picture.
#include <gtest/gtest.h>

#include "output/image.h"
#include "program.h"

namespace sundog::tests {
namespace {

// Catches a formatter that loses or changes something on its way: macros, loops, defaults, functions, transforms and
// textures within textures. scripts/check_pov_format.py does the same with all of povray-examples.
TEST(PovFormatCommand, ItsTextGivesTheSamePicture) {
    const TemporaryFolder folder;
    write_bytes(folder / "a.pov", R"(#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.3 } }
#declare Red = texture { pigment { rgb <1, 0.2, 0.1> } finish { phong 0.5 } }
#declare Place = transform { translate -0.5*y rotate 30*y }
#macro Row(N) #local I = 0; #while (I < N) sphere { <I - 1, 0, 0>, 0.4 texture { Red } transform Place } #local I = I + 1; #end #end
camera { location <0, 1, -4> look_at 0 right x*4/3 }
light_source { <5, 5, -5> rgb 1 area_light x, y, 3, 3 }
union { Row(3) difference { box { -0.3, 0.3 } cylinder { -z, z, 0.2 } pigment { checker rgb 1, rgb 0 scale 0.2 } } }
plane { y, -1 pigment { gradient x color_map { [0 rgb 0.2] [1 rgb 0.9] } } transform Place }
)");
    const std::vector<std::string> common{"pov", "+W40", "+H30", "--device", "cpu", "+WT2"};
    const auto pov = [&](std::vector<std::string> words) {
        words.insert(words.begin(), common.begin(), common.end());
        return run(words, folder.path());
    };
    const Outcome formatted = pov({"a.pov", "--format"});
    ASSERT_EQ(formatted.status, 0) << formatted.err;
    EXPECT_EQ(formatted.out.find("#macro"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png")) << "nothing is to be drawn";
    write_bytes(folder / "b.pov", formatted.out);
    ASSERT_EQ(pov({"a.pov"}).status, 0);
    const Outcome again = pov({"b.pov"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(read_bytes(folder / "a.png"), read_bytes(folder / "b.png"));
}

}  // namespace
}  // namespace sundog::tests
