// SPDX-License-Identifier: Apache-2.0
// Damaged files of the gallery: bytes changed, numbers changed, pieces cut out.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "import/gltf/gltf_test_file.h"
#include "scene/validate.h"

namespace sundog::import::gltf {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t count) { return random() % count; }

/// Replaces a number of the JSON text by another that files may lie about.
void change_number(std::string& text, Random& random) {
    static const std::vector<std::string> kNumbers{"0",          "1",    "-1",   "2",     "3",     "7",
                                                   "255",        "5121", "5123", "5125",  "65536", "4294967295",
                                                   "4294967296", "1e10", "1e38", "1e400", "0.5",   "null"};
    const std::size_t from = below(random, text.size());
    const std::size_t at = text.find_first_of("0123456789", from);
    if (at == std::string::npos) return;
    const std::size_t end = text.find_first_not_of("0123456789.e-", at);
    text.replace(at, end == std::string::npos ? 1 : end - at, kNumbers[below(random, kNumbers.size())]);
}

void damage(std::string& text, Random& random) {
    const std::size_t kind = below(random, 6);
    const std::size_t at = below(random, text.size());
    if (kind == 0) text[at] = static_cast<char>(random());
    else if (kind == 1) text.erase(at, 1 + below(random, 40));
    else if (kind == 2) text.insert(at, text.substr(below(random, text.size()), 1 + below(random, 40)));
    else change_number(text, random);
}

// Catches crashes, endless loops and scenes that don't keep their promises, whatever a file holds.
TEST(GltfNoise, DamagedFilesAreReadOrRefused) {
    const TestFolder folder;
    const fs::path out = folder.path() / "noise.gltf";
    Random random(11);
    std::size_t read = 0;
    std::size_t refused = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(SUNDOG_SOURCE_DIR) / "scenes" / "gltf")) {
        const std::string good = content_of(entry.path());
        for (int i = 0; i < 60; ++i) {
            std::string text = good;
            for (std::size_t changes = 1 + below(random, 3); changes-- > 0;) damage(text, random);
            std::ofstream(out, std::ios::binary) << text;
            try {
                scene::validate(import_gltf(out, {}));
                ++read;
            } catch (const InputError& error) {
                EXPECT_FALSE(error.diagnostic().message.empty());
                ++refused;
            }
        }
    }
    EXPECT_GT(read, 50U);
    EXPECT_GT(refused, 50U);
}

}  // namespace
}  // namespace sundog::import::gltf
