// SPDX-License-Identifier: Apache-2.0
// Text files in memory and located messages about them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/diagnostics.h"

namespace sundog {

/// A text file in memory. Copies share the text.
struct SourceText {
    std::shared_ptr<const std::string> name;  ///< As messages show it.
    std::shared_ptr<const char[]> bytes;      ///< Keeps `text` alive.
    std::string_view text;                    ///< Two newlines follow its end in memory, for scan.h.
};

/// The machine's memory, where the system tells it; else without bound.
std::size_t physical_memory_bytes();

/// Reads a whole text file. A byte order mark is left out; a file with carriage returns alone gets newlines.
/// Reading (not mapping) keeps a file that someone rewrites meanwhile from taking the program down.
/// Errors: InputError for what is missing, unreadable, no regular file (a folder, a device), binary, UTF-16, or
/// larger than half of the machine's memory.
SourceText read_text_file(const std::filesystem::path& file);

/// The same for text that is already in memory (tests, generated input). Never fails.
SourceText text_in_memory(std::string name, std::string_view text);

/// A message about a file as a whole.
Diagnostic diagnose_file(Severity severity, const std::shared_ptr<const std::string>& name, std::string message,
                         std::string hint = {});

/// Throws an InputError about a file as a whole.
[[noreturn]] void fail_file(const std::shared_ptr<const std::string>& name, std::string message, std::string hint = {});

/// A message about the place `at` in a line. `line` begins at a line's start (it may hold several physical lines where
/// the format has continuations) and is number `line_number` of the file.
Diagnostic diagnose(Severity severity, const SourceText& source, std::string_view line, std::uint32_t line_number,
                    const char* at, std::string message, std::string hint = {});

/// A token as a message quotes it: in quotes, cut after 40 characters, control characters as '?'.
std::string in_quotes(std::string_view token);

/// One line being read token by token. Every read names what it expects, for the message where it isn't there.
class LineCursor {
public:
    /// `line` without its newline; it must lie in `source.text`. Reading starts at `at`, or at the line's start.
    LineCursor(const SourceText& source, std::string_view line, std::uint32_t number, const char* at = nullptr);

    /// Where the next token starts, blanks skipped.
    [[nodiscard]] const char* here();
    [[nodiscard]] bool at_end() { return here() == end_; }
    /// The next token without taking it; empty at the end of the line.
    [[nodiscard]] std::string_view peek();
    /// Takes the next token. Errors: InputError at the end of the line.
    std::string_view token(std::string_view expected);
    /// Takes the next token, or one in double quotes, which may hold blanks.
    std::string_view name(std::string_view expected);
    /// Takes the rest of the line without blanks around it and without double quotes around all of it.
    std::string_view rest(std::string_view expected);
    float number(std::string_view expected);
    int integer(std::string_view expected);
    /// Takes a number if the next token is one; else takes nothing.
    bool maybe_number(float& value);
    /// Errors: InputError if anything but blanks is left.
    void expect_end(std::string_view expected);

    [[nodiscard]] SourceLocation location(const char* at) const;
    [[nodiscard]] Diagnostic warning(const char* at, std::string message, std::string hint = {}) const;
    [[noreturn]] void fail(const char* at, std::string message, std::string hint = {}) const;
    [[nodiscard]] std::uint32_t line_number() const { return number_; }

private:
    const SourceText* source_;
    std::string_view line_;
    const char* at_;
    const char* end_;
    std::uint32_t number_;
};

/// Steps through the lines of a text.
class LineReader {
public:
    explicit LineReader(const SourceText& source) : source_(&source), rest_(source.text) {}
    /// The next line, without its newline. False after the last.
    bool next(std::string_view& line);
    /// Number of the line that next() gave, from 1.
    [[nodiscard]] std::uint32_t number() const { return number_; }
    [[nodiscard]] LineCursor cursor(std::string_view line) const { return {*source_, line, number_}; }

private:
    const SourceText* source_;
    std::string_view rest_;
    std::uint32_t number_ = 0;
};

}  // namespace sundog
