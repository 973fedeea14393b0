// SPDX-License-Identifier: Apache-2.0
#include "base/file_access.h"

#include <algorithm>
#include <system_error>

namespace sundog {
namespace {

namespace fs = std::filesystem;

/// As many links as Linux follows for one path.
constexpr int kMostLinks = 40;

/// The part of `resolved` below `folder`, both resolved; nothing where it isn't below.
std::optional<fs::path> part_below(const fs::path& resolved, const fs::path& folder) {
    const auto [at_folder, at_file] = std::mismatch(folder.begin(), folder.end(), resolved.begin(), resolved.end());
    if (at_folder != folder.end()) return std::nullopt;
    fs::path below;
    for (auto part = at_file; part != resolved.end(); ++part) below /= *part;
    return below;
}

std::optional<fs::path> resolved_folder(const fs::path& folder) {
    std::error_code error;
    fs::path resolved = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) return std::nullopt;
    return resolved;
}

std::optional<fs::path> part_below_unresolved(const fs::path& resolved, const fs::path& folder) {
    const std::optional<fs::path> root = resolved_folder(folder);
    return root ? part_below(resolved, *root) : std::nullopt;
}

bool has_hidden_part(const fs::path& path) {
    return std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part.native().starts_with("."); });
}

}  // namespace

std::optional<fs::path> resolved_target(const fs::path& file) {
    fs::path current = file;
    for (int followed = 0; followed <= kMostLinks; ++followed) {
        fs::path name = current.filename();
        fs::path parent = current.parent_path();
        if (name.empty() || name == "." || name == "..") {
            // Not the name of something in a folder, so it must be a folder itself.
            parent = current;
            name.clear();
        }
        std::optional<fs::path> folder = resolved_folder(parent);
        if (!folder || name.empty()) return folder;
        current = *folder / name;
        std::error_code error;
        const fs::file_status status = fs::symlink_status(current, error);
        if (status.type() == fs::file_type::not_found) return current;
        if (error) return std::nullopt;
        if (status.type() != fs::file_type::symlink) return current;
        // Followed by hand: canonical() refuses a link to a file that isn't there, but opening it would create that.
        const fs::path target = fs::read_symlink(current, error);
        if (error || target.empty()) return std::nullopt;
        current = target.is_absolute() ? target : *folder / target;
    }
    return std::nullopt;
}

bool lies_within(const fs::path& resolved, const fs::path& folder) {
    return part_below_unresolved(resolved, folder).has_value();
}

void FileAccess::confine_reading(const std::vector<fs::path>& folders) {
    reading_is_confined_ = true;
    readable_.insert(readable_.end(), folders.begin(), folders.end());
}

void FileAccess::allow_writing(const fs::path& folder) { writable_.push_back(folder); }

std::optional<std::string> FileAccess::why_unreadable(const fs::path& file) const {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) return std::nullopt;
    if (error) return error.message();
    if (fs::is_directory(status)) return "it is a folder";
    if (!fs::is_regular_file(status)) return "it is no regular file";
    if (!reading_is_confined_) return std::nullopt;
    const std::optional<fs::path> resolved = resolved_target(file);
    if (resolved && std::any_of(readable_.begin(), readable_.end(),
                                [&](const fs::path& folder) { return lies_within(*resolved, folder); }))
        return std::nullopt;
    return "it lies outside the folders that may be read";
}

std::optional<std::string> FileAccess::why_unwritable(const fs::path& file) const {
    const std::optional<fs::path> resolved = resolved_target(file);
    if (!resolved) return "there is no such folder";
    std::error_code error;
    const fs::file_status status = fs::status(*resolved, error);
    if (fs::is_directory(status)) return "it is a folder";
    if (fs::exists(status) && !fs::is_regular_file(status)) return "it is no regular file";
    bool hidden = false;
    for (const fs::path& folder : writable_) {
        const std::optional<fs::path> below = part_below_unresolved(*resolved, folder);
        if (!below) continue;
        if (!has_hidden_part(*below)) return std::nullopt;
        hidden = true;
    }
    if (hidden) return "hidden files, and files in hidden folders, are not written";
    return "it lies outside the folders that may be written";
}

}  // namespace sundog
