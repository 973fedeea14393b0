// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "command.h"
#include "console.h"
#include "environment_options.h"
#include "indirect_options.h"
#include "loading.h"
#include "viewer/viewer.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog view table.scene\n"
    "  sundog view model.obj --device cpu --size 1280x720\n"
    "  cd scenes/table && sundog view        (reads raytracer.conf)\n"
    "Escape quits; the window lists the other keys.";

struct ViewArguments {
    std::string scene;
    std::optional<Acceleration> acceleration;
    EnvironmentArguments environment;
    IndirectArguments indirect;  ///< Photons alone: radiosity takes longer than a frame may.
    viewer::ViewOptions options;
};

int view(ViewArguments& arguments) {
    arguments.environment.check();
    arguments.indirect.check(kernel::INTEGRATOR_WHITTED, arguments.options.device);
    arguments.options.change = [&arguments](scene::Scene& scene) {
        arguments.environment.apply(scene);
        arguments.indirect.apply(scene);
    };
    arguments.options.scene_file = scene_file_or_config(arguments.scene);
    arguments.options.device =
        arguments.indirect.device_for(device_for(arguments.acceleration, arguments.options.device));
    arguments.options.acceleration = arguments.acceleration.value_or(Acceleration::embree);
    WarningPrinter warnings;
    viewer::run(arguments.options, warnings.sink());
    return 0;
}

}  // namespace

void add_view(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("view", "Show a scene in a window");
    command->footer(kExamples);
    const auto arguments = std::make_shared<ViewArguments>();
    viewer::ViewOptions& o = arguments->options;
    using Text = const std::string&;

    command->add_option("scene", arguments->scene,
                        "A .scene, .obj, .gltf, .glb or .conf file; raytracer.conf if left out");
    add_variant_option(*command, o.choices);
    command
        ->add_option_function<std::string>(
            "--size",
            [&o](Text text) {
                const Size size = parse_size(text);
                o.width = size.width;
                o.height = size.height;
            },
            "Width and height of the window in pixels")
        ->type_name("WxH");
    command
        ->add_option_function<std::string>(
            "--device", [&o](Text text) { o.device = parse_device(text); },
            "auto (a hardware GPU, else the CPU), cpu or gpu")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--threads", [&o](Text text) { o.threads = parse_int("--threads", text, 0, 1024); },
            "Threads on the CPU; 0 for all")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--accel", [arguments](Text text) { arguments->acceleration = parse_acceleration(text); },
            "What finds hits on the CPU: embree (default), bvh, kdtree, octree, grid, boxes or none")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--max-depth", [&o](Text text) { o.max_depth = parse_int("--max-depth", text, 0, 10000); },
            "Most reflections and refractions on a path")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--min-weight", [&o](Text text) { o.min_weight = parse_float("--min-weight", text, 0, 1); },
            "Paths of less weight end")
        ->type_name("W");
    add_photon_options(*command, arguments->indirect);
    add_environment_options(*command, arguments->environment);
    command->add_flag("--fullscreen", o.fullscreen, "Fill the screen");
    command->callback([arguments, &action] { action = [arguments] { return view(*arguments); }; });
}

}  // namespace sundog::app
