// SPDX-License-Identifier: Apache-2.0
// What POV-Ray's switches and INI files ask for (POV-Ray 3.7 reference, section 3.2 "Command-Line and INI-File
// Options"), as plain values.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sundog::app {

/// A file that is to be written. One that an INI file names is less trusted than one on the command line: INI files
/// come with scenes, and scenes from strangers.
struct NamedOutput {
    std::string name;
    bool from_command_line = false;
};

/// Output_File_Type's letters.
enum class PovFileType : std::uint8_t { bmp, targa_rle, exr, hdr, jpeg, png, ppm, targa };

/// Where the text of one of POV-Ray's streams goes.
struct PovTextStream {
    bool console = true;
    std::optional<NamedOutput> file;
};

/// The streams that can be turned off and sent to files; `all` is the five together.
enum class PovText : std::uint8_t { debug, fatal, render, statistic, warning };
inline constexpr std::size_t kPovTexts = 5;

struct PovSettings {
    // Scene parsing
    std::string input_file;  ///< Empty: none was named. "-" is standard input.
    std::string include_header;
    std::vector<std::string> library_paths;  ///< In the order of their naming, each once.
    struct Declaration {
        std::string name;
        double value = 0;
    };
    std::vector<Declaration> declarations;
    std::optional<double> version;

    // The picture
    int width = 640, height = 480;  ///< Pixels.
    /// Start_Column and its kin as they were given: under 1 a fraction, else pixels from 1.
    std::optional<double> start_column, end_column, start_row, end_row;
    bool antialias = false;
    double antialias_threshold = 0.3;
    int antialias_depth = 3;     ///< 1 to 9
    std::string radiosity_file;  ///< Empty: the scene's name with .rca.
    bool radiosity_from_file = false, radiosity_to_file = false;
    int sampling_method = 1;
    bool jitter = true;
    double jitter_amount = 1;
    double antialias_gamma = 2.5;
    int quality = 9;  ///< 0 to 11

    // Output
    bool output_to_file = true;
    PovFileType file_type = PovFileType::png;
    std::optional<NamedOutput> output_file;  ///< Nothing: named after the scene. "-" is standard output.
    int bits_per_color = 8;                  ///< 5 to 16
    bool output_alpha = false;
    bool grayscale = false;
    std::optional<double> file_gamma;  ///< Nothing: sRGB.
    int jpeg_quality = 0;              ///< Compression: 2 to 100; 0 and 1: POV-Ray's default.
    bool continue_trace = false;
    std::optional<NamedOutput> create_ini;

    // Animation
    std::optional<double> clock;
    std::optional<int> initial_frame, final_frame;
    std::optional<double> initial_clock, final_clock;
    std::optional<double> subset_start_frame, subset_end_frame;  ///< Under 1 a fraction, else frame numbers.
    int frame_step = 1;
    bool cyclic_animation = false;
    bool field_render = false, odd_field = false;

    // Text
    std::array<PovTextStream, kPovTexts> text;
    bool append_text_files = false;
    bool verbose = false;
    bool display = false, pause_when_done = false;
    int warning_level = 10;

    int work_threads = 0;  ///< 0: as many as there are processors.
    /// Pre_Scene_Command and its kin: never run, but told of.
    std::vector<std::string> shell_commands;

    // Sundog's own switches
    bool sandbox = false;
    std::vector<std::string> allow_write;        ///< Folders.
    std::optional<std::uint64_t> max_steps;      ///< Of the interpreter.
    std::optional<std::uint64_t> max_memory_mb;  ///< That the scene's declarations may take.
    std::string device = "auto";
    enum class Wanted : std::uint8_t { picture, formatted, help, version } wanted = Wanted::picture;

    /// The folders of the scenes and INI files that the command line itself named.
    std::vector<std::filesystem::path> command_line_folders;
    /// All options that were set, by their INI keyword, as Create_Ini writes them.
    std::map<std::string, std::string> given;
};

}  // namespace sundog::app
