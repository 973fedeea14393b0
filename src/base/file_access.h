// SPDX-License-Identifier: Apache-2.0
// Which files an input file that may come from a stranger can read and write.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sundog {

/// Where a path leads once links and `..` are followed. The last part need not exist; all others must. Nothing for a
/// path whose folder doesn't exist, for a chain of links without an end, and for what can't be looked at.
std::optional<std::filesystem::path> resolved_target(const std::filesystem::path& file);

/// True if `resolved` (a result of resolved_target) is `folder` or lies below it. A folder that doesn't exist holds
/// nothing.
bool lies_within(const std::filesystem::path& resolved, const std::filesystem::path& folder);

/// A policy about files, asked before a file is opened. Names are judged by where they lead, not by how they are
/// written: a symbolic link or `..` can't carry a file out of the folders that are allowed.
class FileAccess {
public:
    /// From now on only files below these folders, and those allowed earlier or later, may be read.
    void confine_reading(const std::vector<std::filesystem::path>& folders);
    /// Files below `folder` may be written.
    void allow_writing(const std::filesystem::path& folder);
    [[nodiscard]] bool reading_is_confined() const { return reading_is_confined_; }

    /// Why `file` may not be read: nothing if it may, or if there is no such file (opening it tells). Never more than
    /// regular files: reading a device may never end or change what it stands for.
    [[nodiscard]] std::optional<std::string> why_unreadable(const std::filesystem::path& file) const;
    /// Why `file` may not be written: nothing if it may. Hidden files and what lies in hidden folders below an allowed
    /// one are refused too: a program that starts later may trust them (`.bashrc`, `.git/hooks`).
    [[nodiscard]] std::optional<std::string> why_unwritable(const std::filesystem::path& file) const;

private:
    bool reading_is_confined_ = false;
    std::vector<std::filesystem::path> readable_, writable_;
};

}  // namespace sundog
