// SPDX-License-Identifier: Apache-2.0
#include "import/obj/library_names.h"

#include <algorithm>
#include <cctype>

#include "base/paths.h"
#include "base/scan.h"

namespace sundog::import {
namespace {

bool ends_like_library(std::string_view word) {
    constexpr std::string_view kEnding = ".mtl";
    if (word.size() < kEnding.size()) return false;
    return std::equal(kEnding.begin(), kEnding.end(), word.end() - kEnding.size(),
                      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

}  // namespace

std::vector<std::string> split_library_names(const std::filesystem::path& named_in, std::string_view line) {
    if (line.size() >= 2 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
    if (!find_file(named_in, line).empty()) return {std::string(line)};
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && !is_blank(line[end])) ++end;
        if (end > at) words.push_back(line.substr(at, end - at));
        at = end + 1;
    }
    // More words than any real line has: don't ask the file system about each run of them.
    constexpr std::size_t kMostJoined = 16;
    const auto joined = [&](std::size_t first, std::size_t last) {
        return std::string_view(words[first].data(), static_cast<std::size_t>(words[last].data() + words[last].size() -
                                                                              words[first].data()));
    };
    std::vector<std::string> names;
    for (std::size_t first = 0; first < words.size();) {
        std::size_t last = std::min(words.size(), first + kMostJoined) - 1;
        while (last > first && find_file(named_in, joined(first, last)).empty()) --last;
        if (find_file(named_in, joined(first, last)).empty()) {
            last = first;
            while (last + 1 < words.size() && !ends_like_library(words[last])) ++last;
        }
        names.emplace_back(joined(first, last));
        first = last + 1;
    }
    return names;
}

}  // namespace sundog::import
