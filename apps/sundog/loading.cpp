// SPDX-License-Identifier: Apache-2.0
#include "loading.h"

#include "console.h"
#include "device/choose/choose.h"
#include "usage_error.h"

namespace sundog::app {

std::filesystem::path scene_file_or_config(const std::string& named) {
    if (!named.empty()) return named;
    std::filesystem::path config = "raytracer.conf";
    std::error_code ignored;
    if (!std::filesystem::exists(config, ignored))
        throw UsageError("no scene was named, and the working folder holds no raytracer.conf",
                         "name a .scene, .obj, .gltf or .glb file");
    return config;
}

void add_variant_option(CLI::App& command, import::Choices& choices) {
    command
        .add_option("--variant", choices.variant,
                    "Which of a glTF file's sets of materials is shown (KHR_materials_variants); 'info' lists them")
        ->type_name("NAME");
}

std::string device_for(std::optional<Acceleration> acceleration, const std::string& choice) {
    if (!acceleration) return choice;
    if (choice == "gpu")
        throw UsageError("--accel chooses a structure for the CPU, which --device gpu doesn't use",
                         "leave one of them out");
    return "cpu";
}

std::unique_ptr<Device> open_device_for(const RenderScene& scene, const std::string& choice, int threads,
                                        Acceleration acceleration, PrimaryHits primary) {
    std::unique_ptr<Device> device = open_device(choice, threads, acceleration, primary);
    if (choice != "auto" || device->info().kind == "cpu") return device;
    const std::vector<std::string> missing = device->unsupported(scene);
    if (missing.empty()) return device;
    print_note("using the CPU, because " + device->info().name + " can't draw this scene: " + missing.front());
    return open_device("cpu", threads, acceleration, primary);
}

}  // namespace sundog::app
