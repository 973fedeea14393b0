// SPDX-License-Identifier: Apache-2.0
#include "bench/bench.h"
#include "bench/refinement.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "arguments.h"
#include "command.h"
#include "console.h"
#include "exit_status.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog bench\n"
    "  sundog bench --device gpu --no-load\n"
    "Each round measures every contestant once, and medians count. Ctrl-C prints what is done.";

int measure(const bench::BenchOptions& options) {
    const InterruptGuard interrupt;
    const bench::BenchReport report = bench::run_bench(
        options, [](std::string_view line) { print_note(std::string(line)); }, interrupt.flag());
    fmt::print("{}", bench::format_report(report));
    return interrupt.flag().requested() ? kInterrupted : 0;
}

int measure_refinement(const bench::BenchOptions& options, float tolerance) {
    const InterruptGuard interrupt;
    fmt::print("{}", bench::format_refinement(bench::run_refinement(
                         {.gallery = options.gallery, .scenes = {}, .threads = options.threads, .tolerance = tolerance},
                         [](std::string_view line) { print_note(std::string(line)); }, interrupt.flag())));
    return interrupt.flag().requested() ? kInterrupted : 0;
}

}  // namespace

void add_bench(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("bench", "Measure whole frames on this machine, beside others");
    command->footer(kExamples);
    const auto options = std::make_shared<bench::BenchOptions>();
    bench::BenchOptions& o = *options;
    using Text = const std::string&;

    command->add_option("--scenes", o.gallery, "Folder of the gallery (else that of the source tree)");
    command
        ->add_option_function<std::string>(
            "--device",
            [&o](Text text) {
                o.devices = {parse_choice("--device", text, {"cpu", "gpu"})};
            },
            "cpu (default) or gpu")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--threads", [&o](Text text) { o.threads = parse_int("--threads", text, 0, 1024); },
            "Threads on the CPU (2); 0 for all")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--rounds", [&o](Text text) { o.rounds = parse_int("--rounds", text, 1, 1000); }, "Rounds (7)")
        ->type_name("N");
    command->add_flag_callback(
        "--no-tachyon", [&o] { o.tachyon = false; }, "Leave the Tachyon program out");
    command->add_flag_callback(
        "--no-load", [&o] { o.load = false; }, "Leave the loading of a big model out");
    const auto tolerance = std::make_shared<std::optional<float>>();
    command
        ->add_option_function<std::string>(
            "--refine", [tolerance](Text text) { *tolerance = parse_float("--refine", text, 0, 1); },
            "Instead, grid refinement of this tolerance (see 'render --preview') against tracing every pixel")
        ->type_name("T");
    command->callback([options, tolerance, &action] {
        action = [options, tolerance] {
            return *tolerance ? measure_refinement(*options, **tolerance) : measure(*options);
        };
    });
}

}  // namespace sundog::app
