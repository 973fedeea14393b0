// SPDX-License-Identifier: Apache-2.0
// Reading whole files, and replacing files whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sundog::output {

/// Throws an InputError about a file as a whole.
[[noreturn]] void fail_to_read(const std::filesystem::path& file, const std::string& why);
/// Throws an OutputError: can't write 'file': why.
[[noreturn]] void fail_to_write(const std::filesystem::path& file, const std::string& why);

/// The contents of a regular file. Errors: InputError (missing, unreadable, a folder or device, over 4 GiB).
std::vector<unsigned char> read_file(const std::filesystem::path& file);

/// True for things that are written to, not replaced: "-" (standard output), devices, pipes and sockets.
bool is_special_file(const std::filesystem::path& file);

/// A new, empty file beside `target`, which it replaces when committed and which stays as it was otherwise.
class Replacement {
public:
    /// Errors: OutputError naming `target` and the reason (a folder, write-protected, no such folder, ...).
    explicit Replacement(const std::filesystem::path& target);
    ~Replacement();
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    /// The temporary file, for a program that is to write it.
    [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
    /// Appends to the temporary file. Errors: OutputError.
    void write(std::string_view bytes);
    /// Puts the temporary file in the target's place. Errors: OutputError.
    void commit();

private:
    std::filesystem::path named_;   // As the caller called it, for messages.
    std::filesystem::path target_;  // With symbolic links resolved.
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    bool exists_ = false;  // The temporary file does.
};

}  // namespace sundog::output
