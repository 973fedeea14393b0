// SPDX-License-Identifier: Apache-2.0
// What the caller chooses about reading a POV-Ray scene: its switches and INI settings, library paths, limits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sundog::pov {

/// The moment of an animation that a scene is read for.
struct PovClock {
    double clock = 0;
    double clock_delta = 1;
    bool clock_on = false;  ///< True in an animation.
    int frame_number = 0;
    int initial_frame = 1, final_frame = 1;
    double initial_clock = 0, final_clock = 1;
};

/// A Declare=name=value of the command line or an INI file.
struct PovDeclaration {
    std::string name;
    std::variant<double, std::string> value;
};

/// What a scene may use of the machine. Whoever reaches a limit gets an InputError that names it.
struct PovLimits {
    std::uint64_t steps = 2'000'000'000;  ///< Tokens that the interpreter works through, loops and macros included.
    std::uint32_t depth = 200;            ///< Macros and includes within each other.
    std::uint64_t memory_bytes = 0;       ///< Of what the scene declares and builds; 0: half of the machine's memory.
};

/// What a scene may read and write.
struct PovAccess {
    bool sandbox = false;  ///< Read only under the scene's folder and the library paths.
    /// Folders under which #fopen may write; none: the scene may not write.
    std::vector<std::filesystem::path> writable;
};

/// The streams of #debug, #render (`render`), #statistics, #warning.
enum class PovStream : std::uint8_t { debug, render, statistics, warning };

/// Where a picture's radiosity is kept (Radiosity_File_Name, Radiosity_From_File, Radiosity_To_File).
struct PovRadiosityFile {
    std::string name;
    bool load = false, save = false;
};

struct PovOptions {
    int width = 640, height = 480;  ///< Of the picture: image_width, image_height and the camera's aspect.
    PovClock clock;
    std::vector<std::filesystem::path> library_paths;  ///< Searched after the including file's and the scene's folder.
    std::vector<PovDeclaration> declarations;
    std::filesystem::path include_header;  ///< Read before the scene; empty: none.
    std::uint16_t version = 362;  ///< 100 times the language's version where the scene doesn't say: povray 3.7's own.
    PovLimits limits;
    PovAccess access;
    PovRadiosityFile radiosity_file;
    /// Receives what the scene prints, as it prints it; may be empty.
    std::function<void(PovStream, std::string_view)> print;
};

}  // namespace sundog::pov
