// SPDX-License-Identifier: Apache-2.0
#include "bench/bench.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "arguments.h"
#include "bench/accel_bench.h"
#include "bench/gallery.h"
#include "bench/primary.h"
#include "bench/refinement.h"
#include "bench/sampling.h"
#include "bench/shadows.h"
#include "command.h"
#include "console.h"
#include "exit_status.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog bench\n"
    "  sundog bench --device gpu --no-load\n"
    "  sundog bench --accel\n"
    "  sundog bench --primary\n"
    "  sundog bench --shadows\n"
    "Each round measures every contestant once, and medians count. Ctrl-C prints what is done.";

int measure(const bench::BenchOptions& options) {
    const InterruptGuard interrupt;
    const bench::BenchReport report = bench::run_bench(
        options, [](std::string_view line) { print_note(std::string(line)); }, interrupt.flag());
    fmt::print("{}", bench::format_report(report));
    return interrupt.flag().requested() ? kInterrupted : 0;
}

int measure_refinement(const bench::BenchOptions& options, float tolerance, RefinementMethod method,
                       const std::string& scene) {
    if (!scene.empty()) parse_choice("--scene", scene, {bench::kGalleryScenes.begin(), bench::kGalleryScenes.end()});
    const InterruptGuard interrupt;
    fmt::print("{}", bench::refinement_head());
    bench::run_refinement(
        {.gallery = options.gallery,
         .scene = scene,
         .threads = options.threads,
         .tolerance = tolerance,
         .method = method},
        [](const bench::RefinementTiming& timing) {
            fmt::print("{}", bench::refinement_row(timing));
            std::fflush(stdout);
        },
        interrupt.flag());
    return interrupt.flag().requested() ? kInterrupted : 0;
}

int measure_sampling(const bench::BenchOptions& options, const std::string& scene) {
    if (!scene.empty()) parse_choice("--scene", scene, {bench::kGalleryScenes.begin(), bench::kGalleryScenes.end()});
    const InterruptGuard interrupt;
    fmt::print("{}", bench::sampling_head());
    bench::run_sampling(
        {.gallery = options.gallery, .scene = scene, .threads = options.threads},
        [](const bench::SamplingTiming& timing) {
            fmt::print("{}", bench::sampling_row(timing));
            std::fflush(stdout);
        },
        interrupt.flag());
    return interrupt.flag().requested() ? kInterrupted : 0;
}

int measure_primary(const bench::BenchOptions& options, const std::string& scene) {
    const InterruptGuard interrupt;
    fmt::print("{}", bench::primary_head());
    bench::run_primary(
        {.gallery = options.gallery, .scene = scene, .threads = options.threads, .rounds = options.rounds},
        [](const bench::PrimaryTiming& timing) {
            fmt::print("{}", bench::primary_row(timing));
            std::fflush(stdout);
        },
        interrupt.flag());
    return interrupt.flag().requested() ? kInterrupted : 0;
}

int measure_shadows(const bench::BenchOptions& options, const std::string& scene) {
    const InterruptGuard interrupt;
    fmt::print("{}", bench::shadows_head());
    bench::run_shadows(
        {.gallery = options.gallery, .scene = scene, .threads = options.threads, .rounds = options.rounds},
        [](const bench::ShadowTiming& timing) {
            fmt::print("{}", bench::shadows_row(timing));
            std::fflush(stdout);
        },
        interrupt.flag());
    return interrupt.flag().requested() ? kInterrupted : 0;
}

int measure_structures(const bench::BenchOptions& options, const std::string& scene) {
    if (options.devices != std::vector<std::string>{"cpu"})
        throw UsageError("--accel compares structures for the CPU, which --device gpu doesn't use");
    const InterruptGuard interrupt;
    const bench::AccelReport report = bench::run_accel_bench(
        {options.gallery, options.threads, options.rounds, scene},
        [](std::string_view line) { print_note(std::string(line)); }, interrupt.flag());
    fmt::print("{}", bench::format_report(report));
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
            "Compare grid refinement of this tolerance (see 'render --preview') with tracing every pixel instead")
        ->type_name("T");
    const auto method = std::make_shared<std::optional<RefinementMethod>>();
    command
        ->add_option_function<std::string>(
            "--preview-method", [method](Text text) { *method = parse_refinement_method(text); },
            "With --refine: grid (default), scanline or scanline-assumed (see 'render --preview-method')")
        ->type_name("NAME");
    const auto scene = std::make_shared<std::string>();
    const auto structures = std::make_shared<bool>(false);
    command->add_flag("--accel", *structures,
                      "Compare acceleration structures instead: time to build, memory, steps and rays a second");
    const auto sampling = std::make_shared<bool>(false);
    command->add_flag("--sampling", *sampling,
                      "Compare the ways to choose a pixel's samples instead: error against time");
    const auto primary = std::make_shared<bool>(false);
    command->add_flag("--primary", *primary,
                      "Compare eye rays by scan conversion (see 'render --primary') with traced ones instead");
    const auto shadows = std::make_shared<bool>(false);
    command->add_flag("--shadows", *shadows, "Compare light buffers with tracing all shadow rays instead");
    command
        ->add_option_function<std::string>(
            "--scene",
            [scene](Text text) {
                std::vector<std::string> names = bench::accel_scene_names();
                names.emplace_back("knot");
                *scene = parse_choice("--scene", text, {names.begin(), names.end()});
            },
            "With one of these: one scene of those measured")
        ->type_name("NAME");
    command->callback([options, tolerance, method, scene, structures, sampling, primary, shadows, &action] {
        action = [options, tolerance, method, scene, structures, sampling, primary, shadows] {
            if (int{*structures} + int{tolerance->has_value()} + int{*sampling} + int{*primary} + int{*shadows} > 1)
                throw UsageError(
                    "--accel, --refine, --sampling, --primary and --shadows are measurements of their own");
            if (*method && !*tolerance) throw UsageError("--preview-method belongs to --refine");
            if (*shadows) return measure_shadows(*options, *scene);
            if (*primary) return measure_primary(*options, *scene);
            if (*structures) return measure_structures(*options, *scene);
            if (*tolerance)
                return measure_refinement(*options, **tolerance, method->value_or(RefinementMethod::grid), *scene);
            if (*sampling) return measure_sampling(*options, *scene);
            if (!scene->empty())
                throw UsageError("--scene belongs to --accel, --refine, --sampling, --primary or --shadows");
            return measure(*options);
        };
    });
}

}  // namespace sundog::app
