// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <vector>

#include "base/diagnostics.h"
#include "command.h"
#include "pov/pov_command.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

int help(const CLI::App& program, const std::string& topic) {
    if (topic.empty()) {
        // Not program.help(): that is about the command given, which is this one.
        fmt::print("{}", program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal));
        return 0;
    }
    if (topic == "pov") {
        fmt::print("{}", pov_help());
        return 0;
    }
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == topic) {
            fmt::print("{}", command->help("sundog"));
            return 0;
        }
        names.push_back(command->get_name());
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw UsageError(fmt::format("there is no command '{}'", topic), suggest(topic, views));
}

}  // namespace

void add_help(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("help", "Tell more of one command");
    const auto topic = std::make_shared<std::string>();
    command->add_option("command", *topic, "The command");
    command->callback([topic, &program, &action] { action = [topic, &program] { return help(program, *topic); }; });
}

}  // namespace sundog::app
