// SPDX-License-Identifier: Apache-2.0
// For tests: files in a folder that goes away.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace sundog {

/// A new empty folder, removed with all its files at the end.
class TestFolder {
public:
    TestFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "sundog-test-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    /// Writes a file (its folder too) and returns its path.
    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        std::filesystem::path file = path_ / name;
        if (file.parent_path() != path_) std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Collects warnings as "line: message".
struct Warnings {
    std::vector<std::string> texts;
    [[nodiscard]] WarningSink sink() {
        return [this](const Diagnostic& d) { texts.push_back(std::to_string(d.where.line) + ": " + d.message); };
    }
};

}  // namespace sundog
