// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "source_files.h"

namespace sundog::tests {
namespace {

bool is_licence_line(const std::string& line) {
    return line.ends_with("SPDX-License-Identifier: Apache-2.0") ||
           line.ends_with("SPDX-License-Identifier: Apache-2.0 -->");
}

// Catches a source file whose licence nobody can tell.
TEST(SourceRules, EveryFileBeginsWithItsLicence) {
    const auto sources =
        read_sources({"src", "apps", "bench", "tests", "cmake", "scripts", "completions"},
                     {".h", ".cpp", ".comp", ".glsl", ".cmake", "CMakeLists.txt", ".py", ".sh", ".bash"});
    ASSERT_GT(sources.size(), 50U) << "the search itself found too little";
    for (const SourceFile& source : sources) {
        const bool script = !source.lines.empty() && source.lines[0].starts_with("#!");
        const std::size_t at = script ? 1 : 0;
        EXPECT_TRUE(source.lines.size() > at && is_licence_line(source.lines[at])) << source.path;
    }
}

}  // namespace
}  // namespace sundog::tests
