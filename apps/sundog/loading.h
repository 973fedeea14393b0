// SPDX-License-Identifier: Apache-2.0
// From the words of the command line to a scene on a device.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "device/acceleration.h"
#include "device/device.h"
#include "device/primary_hits.h"
#include "import/import.h"

namespace sundog::app {

/// The scene file that was named, or raytracer.conf of the working folder where none was. Errors: UsageError.
std::filesystem::path scene_file_or_config(const std::string& named);

/// `--variant NAME`, which chooses among a glTF file's materials.
void add_variant_option(CLI::App& command, import::Choices& choices);

/// The device's choice where a structure for the CPU was asked for: the CPU. Errors: UsageError where it is "gpu".
std::string device_for(std::optional<Acceleration> acceleration, const std::string& choice);

/// The device of that choice. With "auto", a GPU that can't draw the scene gives way to the CPU, which is said on
/// standard error. Errors: DeviceError.
std::unique_ptr<Device> open_device_for(const RenderScene& scene, const std::string& choice, int threads,
                                        Acceleration acceleration = Acceleration::embree,
                                        PrimaryHits primary = PrimaryHits::automatic);

}  // namespace sundog::app
