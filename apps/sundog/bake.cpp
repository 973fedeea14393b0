// SPDX-License-Identifier: Apache-2.0
#include "bake/bake.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "arguments.h"
#include "bake/matt.h"
#include "bake/write_glb.h"
#include "command.h"
#include "console.h"
#include "exit_status.h"
#include "import/import.h"
#include "loading.h"
#include "output/progress_line.h"
#include "scene/deformation.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog bake scenes/cornell/cornell.scene -o cornell.glb\n"
    "  sundog bake house.gltf -o house.glb --patch 0.1 --spp 1024\n"
    "  sundog bake house.gltf -o house.glb --method radiosity\n"
    "  sundog view house.glb";

struct BakeArguments {
    std::string scene;
    std::string output;
    bake::BakeOptions options;
    bool quiet = false;
};

bake::Method parse_method(const std::string& text) {
    const auto& names = bake::kMethodNames;
    const std::string name = parse_choice("--method", text, {names.begin(), names.end()});
    return static_cast<bake::Method>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// What is missing where it was stopped.
const char* stopped_early(bake::Method method) {
    return method == bake::Method::paths ? ", stopped early: with more noise"
                                         : ", stopped early: with some light by estimate";
}

int run(const BakeArguments& arguments) {
    if (arguments.output.empty()) throw UsageError("nothing says where the scene goes", "for example -o baked.glb");
    if (!arguments.output.ends_with(".glb"))
        throw UsageError("'" + arguments.output + "' doesn't end in .glb, the one format that light is baked into");
    WarningPrinter warnings;
    const WarningSink warn = warnings.sink();
    scene::Scene scene = import::import_scene(scene_file_or_config(arguments.scene), warn);
    scene::deform(scene, arguments.options.time_s);
    if (arguments.options.method == bake::Method::radiosity) bake::make_matt(scene);
    const std::shared_ptr<const RenderScene> compiled = compile(scene, warn);
    Session session(open_device_for(*compiled, "cpu", arguments.options.threads));
    session.load(compiled);

    const InterruptGuard interrupt;
    output::ProgressLine line(std::cerr, !arguments.quiet && isatty(STDERR_FILENO) == 1);
    try {
        const bake::BakedScene baked =
            bake::bake(scene, *compiled, session, arguments.options, warn, std::ref(line), interrupt.flag());
        line.clear();
        FrameOptions view;
        view.time_s = arguments.options.time_s;
        bake::write_glb(arguments.output, scene, baked, make_frame(scene, *compiled, view));
        if (!arguments.quiet)
            fmt::print(stderr, "{}: {} triangles, {} vertices, {:.3g} s{}\n", arguments.output, baked.triangles,
                       baked.vertices, baked.seconds, baked.stopped ? stopped_early(arguments.options.method) : "");
        return baked.stopped ? kInterrupted : 0;
    } catch (const bake::StoppedEarly& stopped) {
        line.clear();
        print_error(fmt::format("{}; {} was not written", stopped.what(), arguments.output));
        return kInterrupted;
    }
}

}  // namespace

void add_bake(CLI::App& program, Action& action) {
    CLI::App* command =
        program.add_subcommand("bake", "Put the light of a scene into its vertices, for real-time walks");
    command->footer(kExamples);
    const auto arguments = std::make_shared<BakeArguments>();
    BakeArguments& a = *arguments;
    using Text = const std::string&;
    command->add_option("scene", a.scene,
                        "A .scene, .obj, .gltf, .glb, .pov or .conf file; raytracer.conf if left out");
    command->add_option("-o,--output", a.output, "The .glb file (glTF 2.0) that is written");
    command
        ->add_option_function<std::string>(
            "--method", [&a](Text text) { a.options.method = parse_method(text); },
            "How light is found: paths for all scenes, or radiosity, without noise, with all surfaces matt (paths)")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--patch", [&a](Text text) { a.options.longest_edge = parse_float("--patch", text, 1e-6F, 1e9F); },
            "Longest edge of the triangles that light is kept at, in the scene's units (a 64th of its diagonal)")
        ->type_name("LENGTH");
    command
        ->add_option_function<std::string>(
            "--spp",
            [&a](Text text) { a.options.samples = static_cast<std::uint32_t>(parse_int("--spp", text, 1, 1000000)); },
            "Paths for each vertex; with radiosity, rays to what has a size and shines (256)")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--max-depth", [&a](Text text) { a.options.max_depth = parse_int("--max-depth", text, 0, 10000); },
            "Surfaces that light comes by at most (16)")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--time", [&a](Text text) { a.options.time_s = parse_float("--time", text, -1e9F, 1e9F); },
            "The moment at which moving things stand, in seconds (0)")
        ->type_name("S");
    command
        ->add_option_function<std::string>(
            "--seed",
            [&a](Text text) { a.options.seed = static_cast<std::uint32_t>(parse_int("--seed", text, 0, 1000000000)); },
            "Another number gives other noise (0)")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--threads", [&a](Text text) { a.options.threads = parse_int("--threads", text, 0, 1024); },
            "Threads; 0 for all (0)")
        ->type_name("N");
    command->add_flag("-q,--quiet", a.quiet, "No progress, no summary");
    command->callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace sundog::app
