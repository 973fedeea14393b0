// SPDX-License-Identifier: Apache-2.0
// Notices when files on disk change.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sundog::viewer {

/// Compares modification time and size of a few files, when asked. A file that is missing for a moment (editors
/// rename) counts as changed when it is back.
class FileWatch {
public:
    /// Watches these files and no others. Those watched already are compared with what was known of them, the rest
    /// with their present state.
    void watch(std::span<const std::string> files);
    /// True once after any file changed and then stayed the same for one call, so that a file half written isn't read.
    /// To be called every 200 ms or so.
    [[nodiscard]] bool changed();

private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    struct Entry {
        std::filesystem::path file;
        std::optional<Stamp> known;  // as of the last report
        std::optional<Stamp> seen;   // as of the last call
    };
    static std::optional<Stamp> stamp_of(const std::filesystem::path& file);

    std::vector<Entry> entries_;
};

}  // namespace sundog::viewer
