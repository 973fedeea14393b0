// SPDX-License-Identifier: Apache-2.0
// The corpus of bad input: each x.expected holds what importing x.scene, x.obj, x.pov or x.conf says (warnings, then
// the error if there is one), in full, with this folder's path left out. With SUNDOG_WRITE_EXPECTED set in the
// environment the files are written anew, to be read before they are committed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "import/import.h"

namespace sundog {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(SUNDOG_SOURCE_DIR) / "tests" / "errors";

/// What is imported by itself; libraries and good models are there for the others.
bool is_case(const fs::path& file) {
    static const std::set<std::string> kEndings = {".scene", ".obj", ".conf", ".pov", ".stl"};
    return kEndings.contains(file.extension().string()) && file.filename() != "triangle.obj";
}

std::string without_folder(std::string text) {
    const std::string folder = kFolder.string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
        text.erase(at, folder.size());
    return text;
}

std::string messages_of(const fs::path& file) {
    std::string text;
    const auto note = [&](const Diagnostic& d) { text += format(d) + '\n'; };
    try {
        import::import_scene(file, note);
    } catch (const InputError& error) {
        text += std::string(error.what()) + '\n';
    }
    return without_folder(text);
}

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Catches a message that changed, moved to another place or vanished, and input that crashes.
TEST(ErrorCorpus, EachFileSaysWhatIsExpected) {
    std::set<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder))
        if (is_case(entry.path())) files.insert(entry.path());
    EXPECT_GT(files.size(), 80U);
    for (const fs::path& file : files) {
        const fs::path expected = fs::path(file).replace_extension(".expected");
        const std::string said = messages_of(file);
        EXPECT_FALSE(said.empty()) << file.filename() << " is read without a word";
        if (std::getenv("SUNDOG_WRITE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << said;
        ASSERT_TRUE(fs::exists(expected)) << expected;
        EXPECT_EQ(said, read(expected)) << file.filename();
    }
}

// Catches an expected message whose input was renamed or removed.
TEST(ErrorCorpus, EachExpectationHasItsInput) {
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
        if (entry.path().extension() != ".expected") continue;
        const bool has_input = std::any_of(fs::directory_iterator(kFolder), {}, [&](const fs::directory_entry& other) {
            return is_case(other.path()) && other.path().stem() == entry.path().stem();
        });
        EXPECT_TRUE(has_input) << entry.path().filename();
    }
}

}  // namespace
}  // namespace sundog
