// SPDX-License-Identifier: Apache-2.0
// What this folder's tests share.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "output/image.h"

namespace sundog::output {

/// A new empty folder that goes away with this object.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "sundog-test-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] std::size_t entries() const {
        const std::filesystem::directory_iterator first(path_);
        return static_cast<std::size_t>(std::distance(begin(first), end(first)));
    }

private:
    std::filesystem::path path_;
};

inline void put(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

inline std::string get(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Smooth in three different ways, with values from 0 to `brightest`; no two rows or columns are alike.
inline Image ramp_picture(int width, int height, float brightest = 1) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(width);
            const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
            image.at(x, y) = Vec3{u, v, 0.5F + 0.5F * std::sin(3 * u + 2 * v)} * brightest;
        }
    }
    return image;
}

}  // namespace sundog::output
