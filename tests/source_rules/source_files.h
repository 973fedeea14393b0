// SPDX-License-Identifier: Apache-2.0
// The project's own source files, for tests that read them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sundog::tests {

struct SourceFile {
    std::string path;  ///< Relative to the repository, with '/'.
    std::vector<std::string> lines;
};

/// All files below the given folders of the repository that end in one of `endings`, sorted by path.
std::vector<SourceFile> read_sources(const std::vector<std::string>& folders, const std::vector<std::string>& endings);

}  // namespace sundog::tests
