// SPDX-License-Identifier: Apache-2.0
#include "render.h"
#include "scene/deformation.h"

#include <fmt/format.h>

#include "command.h"
#include "console.h"
#include "cost_picture.h"
#include "import/import.h"
#include "loading.h"
#include "noise.h"
#include "picture.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog render table.scene -o table.png --size 1920x1080 --spp 16\n"
    "  sundog render table.scene -o turn.mp4 --frames 0..249 --fps 25\n"
    "  sundog render model.obj -o model.mp4 --camera iso --turntable 100\n"
    "  sundog render table.scene -o turn-%04d.png --frames 0..249\n"
    "  sundog render table.scene -o table.exr --aov depth,normal\n"
    "  sundog render table.scene -o table.png --spp 16 --denoise\n"
    "  sundog render glass.scene -o glass.png --photons 500000 --spp 9\n"
    "  sundog render table.scene -o table.png --tone-map agx --exposure 0.5\n"
    "  sundog render table.scene -o - --size 320x240 | display\n"
    "Ctrl-C writes what is done. Exit status: 0 done, 1 bad input, 2 bad usage, 3 could not write, 130 interrupted.";

constexpr float kLongestTime = 1e6F;

/// The size that the picture will have, when neither option nor scene says: as
/// make_frame decides.
Size size_of(const Frame& frame) {
    return {static_cast<int>(frame.params.width), static_cast<int>(frame.params.height)};
}

/// Only structures of ours count their steps.
void check_shown_cost(const RenderArguments& arguments) {
    if (!arguments.acceleration || *arguments.acceleration == Acceleration::embree)
        throw UsageError("--show cost needs to know which structure's steps are meant; Embree hides its own",
                         "add --accel bvh, kdtree, octree, grid, boxes or none");
    if (arguments.frames || arguments.pixel)
        throw UsageError("--show cost makes one picture: leave --frames and --pixel out",
                         "--time says of which moment");
    if (arguments.sampling.way() != SamplingArguments::Way::fixed)
        throw UsageError("--show cost traces every pixel as often: leave --preview, --adaptive and the like out");
    if (arguments.aovs.planes != 0 || arguments.aovs.samples)
        throw UsageError("--show cost makes no further layers: leave --aov out");
}

void check_shown_rays(const RenderArguments& arguments) {
    if (!arguments.sampling.preview)
        throw UsageError("--show rays paints those pixels white that --preview traces; without it all are traced",
                         "add --preview 0.1");
    if (arguments.pixel) throw UsageError("--show rays makes pictures: leave --pixel out");
}

/// Scan conversion is the CPU's, beside Embree, and for every pixel.
void check_primary(RenderArguments& arguments) {
    if (arguments.primary != PrimaryHits::raster) return;
    if (arguments.acceleration && *arguments.acceleration != Acceleration::embree)
        throw UsageError("--primary raster goes with Embree", "leave --accel out");
    if (arguments.sampling.preview) throw UsageError("--primary raster finds every pixel", "leave --preview out");
    if (arguments.device == "gpu")
        throw UsageError("--primary is for the CPU, which --device gpu doesn't use", "leave one of them out");
    arguments.device = "cpu";
}

void check_denoising(const RenderArguments& arguments) {
    using Way = SamplingArguments::Way;
    constexpr int kFewest = 4;
    const SamplingArguments& sampling = arguments.sampling;
    if (sampling.way() != Way::fixed && sampling.way() != Way::to_error)
        throw UsageError("--denoise needs to know each pixel's noise: leave --preview and --adaptive out",
                         "for example --spp 16, or --target-error 0.05");
    if (sampling.most_samples() < kFewest)
        throw UsageError(fmt::format("--denoise needs {} samples a pixel to tell noise from picture", kFewest),
                         "for example --spp 16");
    if (sampling.pattern.value_or(kernel::SAMPLES_SOBOL) != kernel::SAMPLES_SOBOL)
        throw UsageError("--denoise takes Sobol's sequence in blocks: leave --sampler out");
    if (sampling.pixel_filter == kernel::FILTER_MITCHELL)
        throw UsageError("--filter mitchell has weights below 0, from which --denoise can't tell the noise",
                         "for example --filter gaussian");
    if (arguments.shown != Shown::picture || arguments.pixel)
        throw UsageError("--denoise is for pictures: leave --show and --pixel out");
}

void check_shutter(const RenderArguments& arguments) {
    if (!(arguments.shutter_s > 0) || arguments.blur.velocity) return;
    if (arguments.sampling.way() != SamplingArguments::Way::fixed || arguments.sampling.most_samples() < 2)
        throw UsageError("--shutter spreads a fixed number of samples over time", "for example --spp 64");
    if (arguments.denoise || arguments.pixel || arguments.shown != Shown::picture)
        throw UsageError("--shutter makes pictures: leave --denoise, --pixel and --show out");
}

int render(RenderArguments arguments) {
    using Way = SamplingArguments::Way;
    arguments.sampling.check();
    arguments.environment.check();
    arguments.light.check();
    arguments.indirect.check(arguments.light.integrator, arguments.device);
    if (arguments.sampling.preview && (arguments.aovs.planes & ~kernel::AOV_COST) != 0)
        throw UsageError("--preview has no layers but samples and cost, which is 0 where a pixel is interpolated");
    if (arguments.sampling.way() == Way::recursive && arguments.aovs.planes != 0)
        throw UsageError("--adaptive-method 2 has no layers but samples");
    if (arguments.shown == Shown::cost) check_shown_cost(arguments);
    if (arguments.shown == Shown::rays) check_shown_rays(arguments);
    if (arguments.denoise) check_denoising(arguments);
    check_shutter(arguments);
    arguments.blur.check(arguments);
    check_primary(arguments);
    arguments.device = device_for(arguments.acceleration, arguments.device);  // structures are chosen for the CPU
    arguments.device = arguments.indirect.device_for(arguments.device);
    if (arguments.output.empty() && !arguments.pixel)
        throw UsageError("nothing says where the picture goes", "for example -o picture.png");
    if (arguments.turntable) {
        if (arguments.frames || arguments.pixel || arguments.shown == Shown::cost)
            throw UsageError("--turntable makes frames of its own: leave --frames, --pixel and --show cost out");
        arguments.frames = FrameRange{0, *arguments.turntable - 1};
    }
    // What can be known to fail is found out before the scene is read and
    // rendered.
    if (arguments.frame.width)
        check_picture_memory({*arguments.frame.width, *arguments.frame.height}, arguments.aovs,
                             arguments.denoise.has_value());
    const bool layers = arguments.aovs.planes != 0 || arguments.aovs.samples;
    OutputPlan plan;
    if (!arguments.pixel) plan = plan_output(arguments.output, arguments.format, arguments.frames, layers);
    if (!arguments.pixel)
        arguments.tone.check(plan.target == Target::video ? std::nullopt : std::optional(plan.format));
    arguments.frame.time_s = arguments.time_s;
    arguments.light.apply(arguments.frame);
    arguments.frame.aovs = arguments.aovs.planes | arguments.sampling.planes();
    if (arguments.shown == Shown::rays) arguments.frame.aovs |= kernel::AOV_COST;
    arguments.frame.sampling = arguments.sampling.pixel_sampling();

    // What was asked for and isn't there is better said before the picture than after it.
    std::optional<denoise::Denoiser> denoiser;
    if (arguments.denoise) denoiser.emplace(*arguments.denoise);

    WarningPrinter warnings;
    const WarningSink warn = warnings.sink();
    scene::Scene scene = import::import_scene(scene_file_or_config(arguments.scene), warn, arguments.choices);
    scene::deform(scene, scene.settings.freeze_s.value_or(arguments.time_s));
    arguments.environment.apply(scene);
    arguments.indirect.apply(scene);
    const std::shared_ptr<const RenderScene> compiled =
        compile(scene, warn, arguments.frame.integrator == kernel::INTEGRATOR_PATH);
    check_picture_memory(size_of(make_frame(scene, *compiled, arguments.frame)), arguments.aovs,
                         arguments.denoise.has_value());
    if (arguments.view) {
        const Size size = size_of(make_frame(scene, *compiled, arguments.frame));
        arguments.frame.camera = camera_of(*arguments.view, scene::compass_of(scene), compiled->bounds,
                                           static_cast<float>(size.width) / static_cast<float>(size.height));
    }
    Session session(open_device_for(*compiled, arguments.device, arguments.threads,
                                    arguments.acceleration.value_or(Acceleration::embree), arguments.primary));
    session.load(compiled);

    if (const auto focus = arguments.light.pick_focus(make_frame(scene, *compiled, arguments.frame), session))
        arguments.frame.focus_distance = *focus;

    arguments.blur.check_camera(make_frame(scene, *compiled, arguments.frame));

    const Stage stage{scene, *compiled, session, denoiser ? &*denoiser : nullptr};
    if (arguments.pixel) return print_pixel(arguments, stage);
    if (arguments.shown == Shown::cost) return render_cost(arguments, plan, stage);
    if (arguments.shown == Shown::rays && !session.device().can_refine(make_frame(scene, *compiled, arguments.frame)))
        print_note(
            "--show rays: all is white, for every pixel is traced: grid refinement needs the CPU, and a camera without "
            "focal blur or mesh");
    const bool one_picture = plan.target == Target::image || plan.target == Target::standard_output;
    return one_picture ? render_image(arguments, plan, stage) : render_frames(arguments, plan, stage);
}

}  // namespace

void add_render(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("render", "Render a scene to an image or an animation");
    command->footer(kExamples);
    const auto arguments = std::make_shared<RenderArguments>();
    RenderArguments& a = *arguments;
    using Text = const std::string&;

    command->add_option("scene", a.scene, "A .scene, .obj, .gltf, .glb or .conf file; raytracer.conf if left out");
    add_variant_option(*command, a.choices);
    command->add_option(
        "-o,--output", a.output,
        "Picture (.png .jpg .exr .hdr .ppm .tga .bmp), video (.mp4 .webm .gif), or - for standard output");
    command->add_option("--format", a.format,
                        "Format of standard output: png (default), jpg, exr, hdr, ppm, tga or bmp");
    command
        ->add_option_function<std::string>(
            "--size",
            [&a](Text text) {
                const Size size = parse_size(text);
                a.frame.width = size.width;
                a.frame.height = size.height;
            },
            "Width and height in pixels (else the scene's, else 640x480)")
        ->type_name("WxH");
    command
        ->add_option_function<std::string>(
            "--device", [&a](Text text) { a.device = parse_device(text); },
            "auto (a hardware GPU, else the CPU), cpu or gpu")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--threads", [&a](Text text) { a.threads = parse_int("--threads", text, 0, 1024); },
            "Threads on the CPU; 0 for all")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--accel", [&a](Text text) { a.acceleration = parse_acceleration(text); },
            "What finds hits on the CPU: embree (default), bvh, kdtree, octree, grid, boxes or none")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--primary", [&a](Text text) { a.primary = parse_primary(text); },
            "How the CPU finds what the eye sees: trace, raster (scan conversion, where it can be; the same picture) "
            "or auto (the faster of them)")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--show",
            [&a](Text text) {
                a.shown = parse_choice("--show", text, {"cost", "rays"}) == "cost" ? Shown::cost : Shown::rays;
            },
            "cost: instead of the picture, how many steps through the structure each pixel takes; rays: the pixels "
            "that --preview traces are white")
        ->type_name("NAME");
    add_light_options(*command, a.light);
    add_photon_options(*command, a.indirect);
    add_radiosity_options(*command, a.indirect);
    add_sampling_options(*command, a.sampling);
    command
        ->add_option_function<std::string>(
            "--max-depth", [&a](Text text) { a.frame.max_depth = parse_int("--max-depth", text, 0, 10000); },
            "Most reflections and refractions on a path (else the scene's, else 5; for paths 16)")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--min-weight", [&a](Text text) { a.frame.min_weight = parse_float("--min-weight", text, 0, 1); },
            "Paths of less weight end (else the scene's, else 0.01)")
        ->type_name("W");
    command
        ->add_option_function<std::string>(
            "--shadows", [&a](Text text) { a.frame.shadows = parse_switch("--shadows", text); },
            "on or off (else the scene's, else on)")
        ->type_name("on|off");
    command->add_flag_callback(
        "--no-shadows", [&a] { a.frame.shadows = false; }, "The same as --shadows off");
    command
        ->add_option_function<std::string>(
            "--time", [&a](Text text) { a.time_s = parse_float("--time", text, -kLongestTime, kLongestTime); },
            "Moment in seconds (0); of frame 0 with --frames")
        ->type_name("T");
    command
        ->add_option_function<std::string>(
            "--shutter", [&a](Text text) { a.shutter_s = parse_float("--shutter", text, 0, kLongestTime); },
            "Motion blur: seconds that the shutter is open; each sample sees another moment (0)")
        ->type_name("T");
    command
        ->add_option_function<std::string>(
            "--frames", [&a](Text text) { a.frames = parse_frames(text); },
            "Render frames A to B, to a video or to numbered images")
        ->type_name("A..B");
    command
        ->add_option_function<std::string>(
            "--fps", [&a](Text text) { a.frames_per_second = parse_float("--fps", text, 0.01F, 1000); },
            "Frames a second (25)")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--exposure", [&a](Text text) { a.exposure_ev = parse_float("--exposure", text, -100, 100); },
            "Brighten by this many stops (0)")
        ->type_name("EV");
    add_blur_options(*command, a.blur);
    add_tone_options(*command, a.tone);
    add_environment_options(*command, a.environment);
    command
        ->add_option_function<std::string>(
            "--aov", [&a](Text text) { a.aovs = parse_aovs(text); },
            "Further layers of an .exr: depth,normal,albedo,object,samples,cost or all")
        ->type_name("LIST");
    command
        ->add_option_function<std::string>(
            "--camera",
            [&a](Text text) {
                const auto camera = parse_camera(text);
                if (const View* view = std::get_if<View>(&camera)) a.view = *view;
                else a.frame.camera = std::get<kernel::Camera>(camera);
            },
            "Instead of the scene's camera: front, back, left, right, top, bottom or iso, which find the scene, or "
            "twelve numbers as 'sundog view' writes them")
        ->type_name("NAME|LIST");
    command
        ->add_option_function<std::string>(
            "--turntable", [&a](Text text) { a.turntable = parse_int("--turntable", text, 1, 100000); },
            "Render N frames of the camera going once round the scene, at the moment of --time")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--pixel", [&a](Text text) { a.pixel = parse_pixel(text); },
            "Print what this pixel sees instead of making a picture")
        ->type_name("X,Y");
    command->add_flag_callback(
        "--denoise",
        [&a] {
            if (!a.denoise) a.denoise = denoise::Method::automatic;
        },
        "Remove the noise of --spp 4 or more, or of --target-error");
    command
        ->add_option_function<std::string>(
            "--denoiser", [&a](Text text) { a.denoise = parse_denoiser(text); },
            "What does that: oidn (Intel's Open Image Denoise), filter (of our own) or auto (oidn where it is "
            "installed); implies --denoise")
        ->type_name("NAME");
    command->add_flag("-q,--quiet", a.quiet, "No progress and no summary");
    command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace sundog::app
