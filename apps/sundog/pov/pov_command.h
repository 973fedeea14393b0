// SPDX-License-Identifier: Apache-2.0
// `sundog pov`, which is also the whole program where it is called povray.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sundog::app {

/// Does what povray would do with these words. Returns povray's exit statuses: 0 done, 1 an error, 2 interrupted; says
/// all else on standard error. `version` is Sundog's. Throws nothing but what a program can't go on with
/// (std::bad_alloc).
int run_pov(const std::vector<std::string>& words, std::string_view version);

/// What `sundog pov --help` prints.
std::string pov_help();

}  // namespace sundog::app
