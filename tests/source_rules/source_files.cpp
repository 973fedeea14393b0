// SPDX-License-Identifier: Apache-2.0
#include "source_files.h"

#include <algorithm>
#include <fstream>

namespace sundog::tests {

std::vector<SourceFile> read_sources(const std::vector<std::string>& folders, const std::vector<std::string>& endings) {
    namespace fs = std::filesystem;
    const fs::path root = SUNDOG_SOURCE_DIR;
    std::vector<SourceFile> sources;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string name = entry.path().filename().string();
            const bool wanted = std::any_of(endings.begin(), endings.end(),
                                            [&](const std::string& ending) { return name.ends_with(ending); });
            if (!wanted || !entry.is_regular_file()) continue;
            SourceFile source{entry.path().lexically_relative(root).generic_string(), {}};
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) source.lines.push_back(line);
            sources.push_back(std::move(source));
        }
    std::sort(sources.begin(), sources.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return sources;
}

}  // namespace sundog::tests
