// SPDX-License-Identifier: Apache-2.0
#include "viewer/file_watch.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace sundog::viewer {

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const std::filesystem::path& file) {
    std::error_code no_time;
    std::error_code no_size;
    const Stamp stamp{std::filesystem::last_write_time(file, no_time), std::filesystem::file_size(file, no_size)};
    if (no_time || no_size) return std::nullopt;
    return stamp;
}

void FileWatch::watch(std::span<const std::string> files) {
    std::vector<Entry> entries;
    for (const std::string& file : files) {
        const auto old = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.file == file; });
        const auto stamp = stamp_of(file);
        entries.push_back(old != entries_.end() ? *old : Entry{file, stamp, stamp});
    }
    entries_ = std::move(entries);
}

bool FileWatch::changed() {
    bool any_new = false;
    bool all_settled = true;
    for (Entry& entry : entries_) {
        const auto now = stamp_of(entry.file);
        const bool gone = entry.known && !now;
        all_settled = all_settled && !gone && now == entry.seen;
        any_new = any_new || now != entry.known;
        entry.seen = now;
    }
    if (!any_new || !all_settled) return false;
    for (Entry& entry : entries_) entry.known = entry.seen;
    return true;
}

}  // namespace sundog::viewer
