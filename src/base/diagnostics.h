// SPDX-License-Identifier: Apache-2.0
// How the library speaks of bad input: located errors (thrown) and warnings (to a sink). It never prints.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sundog {

/// A place in an input file. `line` and `column` count from 1; 0 means "the file as a whole".
/// Cheap to copy: the file's name is shared.
struct SourceLocation {
    std::shared_ptr<const std::string> file;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

/// Severity of a Diagnostic.
enum class Severity { warning, error };

/// One message about input: where, what, the offending line and what would have been right.
struct Diagnostic {
    Severity severity = Severity::error;
    SourceLocation where;
    std::string message;      ///< What is wrong, one sentence without a full stop.
    std::string source_line;  ///< The line's text without its newline; empty where there is none.
    std::string hint;         ///< What was expected, or the nearest valid names; may be empty.
};

/// The form all messages take (columns align under the caret):
///
///     scene.orbit:3:9: error: unknown key 'focsu'
///      3 | focsu = 12
///        | ^
///     hint: did you mean 'focus'?
///
/// Long source lines are cut around the column, control characters are shown as '?'. Ends without a newline.
std::string format(const Diagnostic& diagnostic);

/// The one exception for bad input. what() is format(diagnostic).
class InputError : public std::runtime_error {
public:
    explicit InputError(Diagnostic diagnostic);
    [[nodiscard]] const Diagnostic& diagnostic() const { return diagnostic_; }

private:
    Diagnostic diagnostic_;
};

/// Something could not be written (exit status 3 of the command line).
class OutputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A device can't be used or lacks something (missing driver, out of memory, unsupported feature).
class DeviceError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Receives warnings. Called from one thread at a time; may be empty (warnings are then dropped).
using WarningSink = std::function<void(const Diagnostic&)>;

/// Up to `limit` names nearest to `misspelt` by edit distance (optimal string alignment, case-insensitive),
/// nearest first, none further away than a third of the longer name's length (at least 1).
std::vector<std::string> nearest_names(std::string_view misspelt, std::span<const std::string_view> valid,
                                       std::size_t limit = 3);

/// "did you mean 'a'?" / "did you mean 'a' or 'b'?", or "expected one of: …" where nothing is near.
std::string suggest(std::string_view misspelt, std::span<const std::string_view> valid);

}  // namespace sundog
