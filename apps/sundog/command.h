// SPDX-License-Identifier: Apache-2.0
// The subcommands. Each add_… declares one to the parser; when it is the one that was called, it sets `action` to what
// is to be done, which returns the exit status.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace sundog::app {

using Action = std::function<int()>;

void add_render(CLI::App& program, Action& action);
void add_view(CLI::App& program, Action& action);
void add_info(CLI::App& program, Action& action);
void add_compare(CLI::App& program, Action& action);
void add_bake(CLI::App& program, Action& action);
void add_bench(CLI::App& program, Action& action);
void add_help(CLI::App& program, Action& action);

}  // namespace sundog::app
