// SPDX-License-Identifier: Apache-2.0
// Create_Ini: the settings of a run as an INI file that repeats it.
#pragma once

#include <string>

#include "settings.h"

namespace sundog::app {

/// The text of the INI file: all options that were given, wherever they were, with the values that held in the end.
std::string ini_text(const PovSettings& settings);

}  // namespace sundog::app
