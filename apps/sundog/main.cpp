// SPDX-License-Identifier: Apache-2.0
// The command line: which subcommand was called, and what its failure means to the shell.
#include <fmt/format.h>

#include <filesystem>
#include <new>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "command.h"
#include "console.h"
#include "exit_status.h"
#include "pov/pov_command.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog view scenes/table/table.scene\n"
    "  sundog render scenes/table/table.scene -o table.png --size 1920x1080\n"
    "  sundog render scenes/table/table.scene -o table.mp4 --frames 0..249\n"
    "  sundog info --devices\n"
    "  sundog pov scene.pov +W800 +H600 +A0.3\n"
    "'sundog help COMMAND' tells more of one. A scene is a .scene, .obj, .gltf or .glb file; without one,\n"
    "raytracer.conf in the working folder names it.";

/// All names that could have been meant where `called` was misspelt.
std::vector<std::string> valid_names(const CLI::App& called, bool options) {
    std::vector<std::string> names;
    if (options) {
        for (const CLI::Option* option : called.get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    } else {
        for (const CLI::App* command : called.get_subcommands([](const CLI::App*) { return true; }))
            names.push_back(command->get_name());
    }
    return names;
}

/// Words that no option or argument took. CLI11's own message offers no nearest name, so we form ours.
void refuse_leftovers(const CLI::App& program) {
    const std::vector<std::string> leftovers = program.remaining(true);
    if (leftovers.empty()) return;
    const auto called = program.get_subcommands();
    const CLI::App& app = called.empty() ? program : *called.front();
    std::string word = leftovers.front();
    for (const std::string& candidate : leftovers)
        if (candidate.starts_with("-")) {
            word = candidate;
            break;
        }
    word = word.substr(0, word.find('='));
    const bool is_option = word.starts_with("-");
    if (!is_option && !called.empty())
        throw UsageError(fmt::format("unexpected argument '{}'", word),
                         fmt::format("'sundog help {}' shows what it takes", app.get_name()));
    const std::vector<std::string> names = valid_names(app, is_option);
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw UsageError(fmt::format("there is no {} '{}'", is_option ? "option" : "command", word), suggest(word, views));
}

/// The words of a povray command line: those behind `sundog pov`, or all of them where the program is called povray.
std::optional<std::vector<std::string>> povray_words(int argc, char** argv) {
    const std::vector<std::string> words(argv, argv + argc);
    const bool is_povray = !words.empty() && std::filesystem::path(words[0]).filename().string().starts_with("povray");
    if (!is_povray && (words.size() < 2 || words[1] != "pov")) return std::nullopt;
    return std::vector<std::string>(words.begin() + (is_povray ? 1 : 2), words.end());
}

int run(int argc, char** argv) {
    // POV-Ray's switches follow no custom that a parser of options knows.
    if (const auto words = povray_words(argc, argv)) return run_pov(*words, SUNDOG_VERSION);
    CLI::App program{"Sundog, a ray tracer: OBJ and orbit scenes to pictures, in a window, as images and animations.",
                     "sundog"};
    program.footer(kExamples);
    program.set_version_flag("--version", "sundog " SUNDOG_VERSION);
    program.allow_extras();
    program.require_subcommand(0, 1);
    Action action;
    add_render(program, action);
    add_view(program, action);
    add_info(program, action);
    add_compare(program, action);
    add_bake(program, action);
    add_bench(program, action);
    program.add_subcommand("pov", "Render a POV-Ray scene, called as povray is");
    add_help(program, action);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& wanted) {  // --help, --version
        return program.exit(wanted);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    refuse_leftovers(program);
    if (action) return action();
    fmt::print("{}", program.help());
    return 0;
}

}  // namespace
}  // namespace sundog::app

int main(int argc, char** argv) {
    using namespace sundog;
    try {
        return app::run(argc, argv);
    } catch (const app::UsageError& error) {
        app::print_error(error.what(), error.hint());
        return app::kBadUsage;
    } catch (const InputError& error) {
        app::print_note(error.what());
        return app::kBadInput;
    } catch (const OutputError& error) {
        app::print_error(error.what());
        return app::kNotWritten;
    } catch (const DeviceError& error) {
        app::print_error(error.what(), "'sundog info --devices' says what can be used here");
        return app::kBadInput;
    } catch (const std::bad_alloc&) {
        app::print_error("there is not enough memory for this");
        return app::kBadInput;
    } catch (const std::exception& error) {
        app::print_error(error.what());
        return app::kBadInput;
    }
}
