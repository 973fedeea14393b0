// SPDX-License-Identifier: Apache-2.0
// POV-Ray's switches (+W320, -D, +A0.1 …) in terms of the INI options that they stand for.
#pragma once

#include <string_view>
#include <vector>

#include "option_table.h"

namespace sundog::app {

/// The options that a word beginning with + or - stands for, in the order in which they are to be set. Letters may
/// have any case. Errors: OptionError for an unknown switch, or one that lacks its value.
std::vector<OptionText> options_of_switch(std::string_view word, bool from_command_line);

}  // namespace sundog::app
