// SPDX-License-Identifier: Apache-2.0
// The INI options by name (POV-Ray 3.7 reference, section 3.2). Switches are turned into them first.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "settings.h"

namespace sundog::app {

/// One option as it was written: `name=value`.
struct OptionText {
    std::string name;  ///< Any case.
    std::string value;
    bool from_command_line = false;
};

/// An option that can't be understood. what() is one sentence without a full stop; whoever knows the place adds it.
class OptionError : public std::runtime_error {
public:
    explicit OptionError(const std::string& message, std::string hint = {})
        : std::runtime_error(message), hint_(std::move(hint)) {}
    [[nodiscard]] const std::string& hint() const { return hint_; }

private:
    std::string hint_;
};

/// Sets what `option` says. A later setting replaces an earlier one; Library_Path and Declare add up.
/// Errors: OptionError for an unknown name or a value out of its range.
void apply_option(PovSettings& settings, const OptionText& option);

/// True for true, yes, on and 1, in any case; all else is false, as the reference says.
bool is_true(std::string_view value);

/// In lower case; options, switches and section labels are compared so.
std::string lower_case(std::string_view text);

/// Without one pair of single or double quotes around all of it.
std::string_view without_quotes(std::string_view text);

/// Without blanks around it.
std::string_view trimmed(std::string_view text);

}  // namespace sundog::app
