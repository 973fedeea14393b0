// SPDX-License-Identifier: Apache-2.0
// The loading benchmark: a big OBJ from the file to the first picture.
#pragma once

#include <filesystem>
#include <string>

namespace sundog::bench {

/// An OBJ file's text: a bumpy sphere of `rings` rings of 2*rings quads split into triangles: 4*rings*(rings - 1)
/// triangles, the poles closed by fans.
std::string bumpy_sphere_obj(int rings);

/// Where the time went, in seconds.
struct LoadTimes {
    std::size_t triangles = 0;
    double file_mib = 0;
    double import_s = 0;   ///< Reading and understanding the file.
    double compile_s = 0;  ///< To the kernel's arrays.
    double load_s = 0;     ///< The device's acceleration structure.
    double render_s = 0;   ///< The first 640x480 picture.
    [[nodiscard]] double total_s() const { return import_s + compile_s + load_s + render_s; }
};

/// Loads an OBJ or scene file on a device ("cpu", "gpu", "auto") and renders its first picture. Errors: InputError,
/// DeviceError.
LoadTimes time_first_picture(const std::filesystem::path& file, const std::string& device, int threads);

}  // namespace sundog::bench
