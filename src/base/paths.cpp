// SPDX-License-Identifier: Apache-2.0
#include "base/paths.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace sundog {
namespace {

std::string with_slashes(std::string_view name) {
    std::string text(name);
    std::replace(text.begin(), text.end(), '\\', '/');
    return text;
}

}  // namespace

std::filesystem::path resolve_path(const std::filesystem::path& named_in, std::string_view name) {
    return (named_in.parent_path() / with_slashes(name)).lexically_normal();
}

bool is_file(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

std::filesystem::path find_file(const std::filesystem::path& named_in, std::string_view name) {
    std::filesystem::path file = resolve_path(named_in, name);
    if (is_file(file)) return file;
    file = named_in.parent_path() / std::filesystem::path(with_slashes(name)).filename();
    return is_file(file) ? file : std::filesystem::path();
}

}  // namespace sundog
