// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "command.h"
#include "compile/compile.h"
#include "console.h"
#include "device/choose/choose.h"
#include "import/import.h"
#include "loading.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog info table.scene\n"
    "  sundog info --devices";

constexpr std::size_t kMostObjects = 20;

struct InfoArguments {
    std::string scene;
    bool devices = false;
    bool all = false;
    import::Choices choices;
};

using Clock = std::chrono::steady_clock;
double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// "3.2 MB"
std::string bytes(std::size_t count) {
    const auto n = static_cast<double>(count);
    if (n < 1e3) return fmt::format("{} bytes", count);
    if (n < 1e6) return fmt::format("{:.1f} kB", n / 1e3);
    if (n < 1e9) return fmt::format("{:.1f} MB", n / 1e6);
    return fmt::format("{:.2f} GB", n / 1e9);
}

std::string point(Vec3 p) { return fmt::format("({:g}, {:g}, {:g})", p.x, p.y, p.z); }

std::string kind_of(const scene::Object& object) {
    if (const auto* mesh = std::get_if<Boxed<scene::Mesh>>(&object.shape))
        return fmt::format("mesh of {} triangles", (*mesh)->triangles.size());
    if (std::holds_alternative<std::shared_ptr<const scene::Solid>>(object.shape)) return "solid";
    if (std::holds_alternative<scene::Sphere>(object.shape)) return "sphere";
    return std::holds_alternative<scene::Plane>(object.shape) ? "plane" : "box";
}

int print_devices() {
    for (const DeviceListing& listing : list_devices()) {
        const DeviceInfo& info = listing.info;
        fmt::print("{}  {}{}{}\n", info.kind, info.name, info.software ? " (software)" : "",
                   listing.chosen_by_auto ? "  [auto]" : "");
        if (!info.detail.empty()) fmt::print("     {}\n", info.detail);
        if (!listing.why_unusable.empty()) fmt::print("     can't be used: {}\n", listing.why_unusable);
    }
    return 0;
}

void print_objects(const scene::Scene& scene, bool all) {
    const std::size_t shown = all ? scene.objects.size() : std::min(scene.objects.size(), kMostObjects);
    for (std::size_t i = 0; i < shown; ++i) {
        const scene::Object& object = scene.objects[i];
        fmt::print("  {:<20} {}{}\n", object.name, kind_of(object), scene::moves(object) ? ", moving" : "");
    }
    if (shown < scene.objects.size()) fmt::print("  … and {} more (--all lists them)\n", scene.objects.size() - shown);
}

/// What one kind of device says of the scene, or why there is no such device.
void print_support(const char* kind, const RenderScene& compiled) {
    try {
        const std::unique_ptr<Device> device = open_device(kind, 0);
        const std::vector<std::string> missing = device->unsupported(compiled);
        fmt::print("{:<10} {}: {}\n", kind, device->info().name, missing.empty() ? "draws all of it" : "can't draw it");
        for (const std::string& sentence : missing) fmt::print("           {}\n", sentence);
    } catch (const DeviceError& error) {
        fmt::print("{:<10} {}\n", kind, error.what());
    }
}

int print_scene(const InfoArguments& arguments) {
    const std::filesystem::path file = scene_file_or_config(arguments.scene);
    WarningPrinter warnings;
    Clock::time_point start = Clock::now();
    const scene::Scene scene = import::import_scene(file, warnings.sink(), arguments.choices);
    const double read_ms = milliseconds_since(start);
    start = Clock::now();
    const std::shared_ptr<const RenderScene> compiled = compile(scene, warnings.sink(), false);
    const double compile_ms = milliseconds_since(start);

    std::size_t triangles = 0;
    for (const kernel::Geometry& g : compiled->geometries)
        if (g.kind == kernel::GEOMETRY_TRIANGLES) triangles += g.primitive_count;
    fmt::print("scene      {}\n", scene.name.empty() ? file.string() : scene.name);
    fmt::print("files      {}\n", fmt::join(scene.files, "\n           "));
    fmt::print("time       {:.1f} ms to read, {:.1f} ms to compile\n", read_ms, compile_ms);
    fmt::print("memory     {}\n", bytes(memory_bytes(*compiled)));
    fmt::print("bounds     {}\n", compiled->bounds.empty()
                                      ? "nothing finite"
                                      : point(compiled->bounds.lower) + " to " + point(compiled->bounds.upper));
    fmt::print("materials  {}\n", scene.materials.size());
    if (!scene.variants.empty()) fmt::print("variants   {}\n", fmt::join(scene.variants, "\n           "));
    fmt::print("textures   {}\n", scene.textures.size());
    fmt::print("lights     {}\n", scene.lights.size());
    fmt::print("moves      {}\n", scene::is_animated(scene) ? "yes" : "no");
    fmt::print("triangles  {}\n", triangles);
    print_support("cpu", *compiled);
    print_support("gpu", *compiled);
    fmt::print("objects    {}\n", scene.objects.size());
    print_objects(scene, arguments.all);
    return 0;
}

}  // namespace

void add_info(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("info", "Tell what a scene holds, or which devices there are");
    command->footer(kExamples);
    const auto arguments = std::make_shared<InfoArguments>();
    command->add_option("scene", arguments->scene,
                        "A .scene, .obj, .gltf, .glb or .conf file; raytracer.conf if left out");
    add_variant_option(*command, arguments->choices);
    command->add_flag("--devices", arguments->devices, "List the devices and why one can't be used");
    command->add_flag("--all", arguments->all, "List all objects");
    command->callback([arguments, &action] {
        action = [arguments] { return arguments->devices ? print_devices() : print_scene(*arguments); };
    });
}

}  // namespace sundog::app
