// SPDX-License-Identifier: Apache-2.0
#include "option_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/diagnostics.h"
#include "base/text_file.h"

namespace sundog::app {
namespace {

constexpr int kLargestSide = 65535;
constexpr int kMostFrames = 1'000'000;
constexpr int kMostThreads = 512;  // Reference 3.2.8.1

/// What an option's setter sees.
struct Setting {
    PovSettings& settings;
    const OptionText& option;

    [[noreturn]] void fail(const std::string& expected) const {
        throw OptionError(option.name + " can't be " + in_quotes(option.value), expected);
    }
    [[nodiscard]] std::string text() const { return std::string(without_quotes(trimmed(option.value))); }
    [[nodiscard]] bool boolean() const { return is_true(text()); }
    [[nodiscard]] double number() const {
        const std::string value = text();
        const char* first = value.data();
        const char* const last = first + value.size();
        if (first != last && *first == '+') ++first;
        double result = 0;
        const auto [end, error] = std::from_chars(first, last, result);
        if (error != std::errc{} || end != last || !std::isfinite(result)) fail("expected a number");
        return result;
    }
    /// POV-Ray takes the whole part of a fractional number (+W320.7), and so do we.
    [[nodiscard]] int whole(int least, int most) const {
        const double value = std::trunc(number());
        if (value < least || value > most)
            fail("expected a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        return static_cast<int>(value);
    }
    /// The same, but what lies outside is brought to the nearest end, where POV-Ray does so.
    [[nodiscard]] int clamped(int least, int most) const {
        return static_cast<int>(std::clamp(std::trunc(number()), double(least), double(most)));
    }
    [[nodiscard]] double at_least_zero() const {
        const double value = number();
        if (value < 0) fail("expected a number that isn't negative");
        return value;
    }
    [[nodiscard]] std::uint64_t count() const {
        const double value = std::trunc(number());
        if (value < 1 || value > 1e15) fail("expected a whole number from 1 to 1e15");
        return static_cast<std::uint64_t>(value);
    }
    [[nodiscard]] NamedOutput output() const { return {text(), option.from_command_line}; }
};

void set_file_type(Setting s) {
    const std::string type = lower_case(s.text());
    // Only the first letter counts: Output_File_Type=png means PPM, as povray has it.
    switch (type.empty() ? '\0' : type.front()) {
        case 'b':
            s.settings.file_type = PovFileType::bmp;
            return;
        case 'c':
            s.settings.file_type = PovFileType::targa_rle;
            return;
        case 'e':
            s.settings.file_type = PovFileType::exr;
            return;
        case 'h':
            s.settings.file_type = PovFileType::hdr;
            return;
        case 'j':
            s.settings.file_type = PovFileType::jpeg;
            return;
        case 'n':
        case 's':  // The system's own: PNG, says povray's manual page.
            s.settings.file_type = PovFileType::png;
            return;
        case 'p':
            s.settings.file_type = PovFileType::ppm;
            return;
        case 't':
            s.settings.file_type = PovFileType::targa;
            return;
        default:
            s.fail(
                "expected B (BMP), C (compressed Targa), E (OpenEXR), H (Radiance HDR), J (JPEG), N (PNG), P (PPM) or "
                "T (Targa)");
    }
}

void add_library_path(Setting s) {
    const std::string path = s.text();
    if (path.empty()) s.fail("expected a folder");
    auto& paths = s.settings.library_paths;
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
}

void add_declaration(Setting s) {
    const std::string text = s.text();
    const std::size_t equals = text.find('=');
    const std::string name(trimmed(std::string_view(text).substr(0, equals)));
    const auto is_word = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    if (equals == std::string::npos || name.empty() || !std::all_of(name.begin(), name.end(), is_word) ||
        (name.front() >= '0' && name.front() <= '9'))
        s.fail("expected Declare=NAME=NUMBER");
    const OptionText number{"Declare=" + name, text.substr(equals + 1), s.option.from_command_line};
    s.settings.declarations.push_back({name, Setting{s.settings, number}.number()});
}

void set_file_gamma(Setting s) {
    if (lower_case(s.text()) == "srgb") {
        s.settings.file_gamma.reset();
        return;
    }
    const double gamma = s.number();
    if (gamma < 0.1 || gamma > 10) s.fail("expected sRGB or a number from 0.1 to 10");
    s.settings.file_gamma = gamma;
}

template <PovText kText>
void set_console(Setting s) {
    s.settings.text[static_cast<std::size_t>(kText)].console = s.boolean();
}

/// The file of a stream: `true` asks for its customary name, `false` for none.
void set_text_file(Setting s, PovText text, const char* customary_name) {
    auto& file = s.settings.text[static_cast<std::size_t>(text)].file;
    const std::string value = lower_case(s.text());
    file.reset();
    if (is_true(value)) file = NamedOutput{customary_name, s.option.from_command_line};
    else if (value != "false" && value != "no" && value != "off" && value != "0") file = s.output();
}

void set_all_files(Setting s) {
    for (std::size_t i = 0; i < kPovTexts; ++i) set_text_file(s, static_cast<PovText>(i), "ALLTEXT.OUT");
}

void set_create_ini(Setting s) {
    const std::string value = lower_case(s.text());
    s.settings.create_ini.reset();
    if (is_true(value)) s.settings.create_ini = NamedOutput{"", s.option.from_command_line};  // Named after the scene.
    else if (value != "false" && value != "no" && value != "off" && value != "0") s.settings.create_ini = s.output();
}

void note_shell_command(Setting s) {
    if (!s.text().empty()) s.settings.shell_commands.push_back(s.option.name);
}

void ignore(Setting) {}
void ignore_number(Setting s) { (void)s.number(); }

struct Option {
    std::string_view name;  // As the reference spells it.
    void (*apply)(Setting);
};

// Sorted by name.
constexpr Option kOptions[] = {
    {"All_Console",
     [](Setting s) {
         for (auto& stream : s.settings.text) stream.console = s.boolean();
     }},
    {"All_File", set_all_files},
    {"Antialias", [](Setting s) { s.settings.antialias = s.boolean(); }},
    {"Antialias_Depth", [](Setting s) { s.settings.antialias_depth = s.clamped(1, 9); }},
    {"Antialias_Gamma", [](Setting s) { s.settings.antialias_gamma = s.at_least_zero(); }},
    {"Antialias_Threshold", [](Setting s) { s.settings.antialias_threshold = s.at_least_zero(); }},
    {"Append_File", [](Setting s) { s.settings.append_text_files = s.boolean(); }},
    {"BSP_BaseAccessCost", ignore_number},
    {"BSP_ChildAccessCost", ignore_number},
    {"BSP_IsectCost", ignore_number},
    {"BSP_MaxDepth", ignore_number},
    {"BSP_MissChance", ignore_number},
    {"Bits_Per_Color", [](Setting s) { s.settings.bits_per_color = s.clamped(5, 16); }},
    {"Bounding", ignore},
    {"Bounding_Method", ignore_number},
    {"Bounding_Threshold", ignore_number},
    {"Buffer_Output", ignore},
    {"Buffer_Size", ignore_number},
    {"Clock", [](Setting s) { s.settings.clock = s.number(); }},
    {"Compression", [](Setting s) { s.settings.jpeg_quality = s.clamped(0, 100); }},
    {"Continue_Trace", [](Setting s) { s.settings.continue_trace = s.boolean(); }},
    {"Create_Ini", set_create_ini},
    {"Cyclic_Animation", [](Setting s) { s.settings.cyclic_animation = s.boolean(); }},
    {"Debug_Console", set_console<PovText::debug>},
    {"Debug_File", [](Setting s) { set_text_file(s, PovText::debug, "DEBUG.OUT"); }},
    {"Declare", add_declaration},
    {"Display", [](Setting s) { s.settings.display = s.boolean(); }},
    {"Display_Gamma",
     [](Setting s) {
         if (lower_case(s.text()) != "srgb") (void)s.number();
     }},
    {"Dither", ignore},
    {"Dither_Method", ignore},
    {"Draw_Vistas", ignore},
    {"End_Column", [](Setting s) { s.settings.end_column = s.at_least_zero(); }},
    {"End_Row", [](Setting s) { s.settings.end_row = s.at_least_zero(); }},
    {"Fatal_Console", set_console<PovText::fatal>},
    {"Fatal_Error_Command", note_shell_command},
    {"Fatal_Error_Return", ignore},
    {"Fatal_File", [](Setting s) { set_text_file(s, PovText::fatal, "FATAL.OUT"); }},
    {"Field_Render", [](Setting s) { s.settings.field_render = s.boolean(); }},
    {"File_Gamma", set_file_gamma},
    {"Final_Clock", [](Setting s) { s.settings.final_clock = s.number(); }},
    {"Final_Frame", [](Setting s) { s.settings.final_frame = s.whole(-kMostFrames, kMostFrames); }},
    {"Frame_Step", [](Setting s) { s.settings.frame_step = s.whole(1, kMostFrames); }},
    {"Grayscale_Output", [](Setting s) { s.settings.grayscale = s.boolean(); }},
    {"Height", [](Setting s) { s.settings.height = s.whole(1, kLargestSide); }},
    {"High_Reproducibility", ignore},
    {"Include_Header", [](Setting s) { s.settings.include_header = s.text(); }},
    {"Initial_Clock", [](Setting s) { s.settings.initial_clock = s.number(); }},
    {"Initial_Frame", [](Setting s) { s.settings.initial_frame = s.whole(-kMostFrames, kMostFrames); }},
    {"Input_File_Name", [](Setting s) { s.settings.input_file = s.text(); }},
    {"Jitter", [](Setting s) { s.settings.jitter = s.boolean(); }},
    {"Jitter_Amount", [](Setting s) { s.settings.jitter_amount = s.number(); }},
    {"Library_Path", add_library_path},
    {"Light_Buffer", ignore},
    {"Max_Image_Buffer_Memory", ignore_number},
    {"Odd_Field", [](Setting s) { s.settings.odd_field = s.boolean(); }},
    {"Output_Alpha", [](Setting s) { s.settings.output_alpha = s.boolean(); }},
    {"Output_File_Name", [](Setting s) { s.settings.output_file = s.output(); }},
    {"Output_File_Type", set_file_type},
    {"Output_to_File", [](Setting s) { s.settings.output_to_file = s.boolean(); }},
    {"Palette", ignore},
    {"Pause_When_Done", [](Setting s) { s.settings.pause_when_done = s.boolean(); }},
    {"Post_Frame_Command", note_shell_command},
    {"Post_Frame_Return", ignore},
    {"Post_Scene_Command", note_shell_command},
    {"Post_Scene_Return", ignore},
    {"Pre_Frame_Command", note_shell_command},
    {"Pre_Frame_Return", ignore},
    {"Pre_Scene_Command", note_shell_command},
    {"Pre_Scene_Return", ignore},
    {"Preview_End_Size", ignore_number},
    {"Preview_Start_Size", ignore_number},
    {"Quality", [](Setting s) { s.settings.quality = s.clamped(0, 11); }},
    {"Radiosity_File_Name", [](Setting s) { s.settings.radiosity_file = s.text(); }},
    {"Radiosity_From_File", [](Setting s) { s.settings.radiosity_from_file = s.boolean(); }},
    {"Radiosity_To_File", [](Setting s) { s.settings.radiosity_to_file = s.boolean(); }},
    {"Radiosity_Vain_Pretrace", ignore},
    {"Remove_Bounds", ignore},
    {"Render_Block_Size", ignore_number},
    {"Render_Block_Step", ignore_number},
    {"Render_Console", set_console<PovText::render>},
    {"Render_File", [](Setting s) { set_text_file(s, PovText::render, "RENDER.OUT"); }},
    {"Render_Pattern", ignore_number},
    {"Sampling_Method", [](Setting s) { s.settings.sampling_method = s.clamped(1, 2); }},
    {"Split_Unions", ignore},
    {"Start_Column", [](Setting s) { s.settings.start_column = s.at_least_zero(); }},
    {"Start_Row", [](Setting s) { s.settings.start_row = s.at_least_zero(); }},
    {"Statistic_Console", set_console<PovText::statistic>},
    {"Statistic_File", [](Setting s) { set_text_file(s, PovText::statistic, "STATS.OUT"); }},
    {"Subset_End_Frame", [](Setting s) { s.settings.subset_end_frame = s.at_least_zero(); }},
    {"Subset_Start_Frame", [](Setting s) { s.settings.subset_start_frame = s.at_least_zero(); }},
    {"Test_Abort", ignore},
    {"Test_Abort_Count", ignore_number},
    {"User_Abort_Command", note_shell_command},
    {"User_Abort_Return", ignore},
    {"Verbose", [](Setting s) { s.settings.verbose = s.boolean(); }},
    {"Version", [](Setting s) { s.settings.version = s.number(); }},
    {"Video_Mode", ignore},
    {"Vista_Buffer", ignore},
    {"Warning_Console", set_console<PovText::warning>},
    {"Warning_File", [](Setting s) { set_text_file(s, PovText::warning, "WARNING.OUT"); }},
    {"Warning_Level", [](Setting s) { s.settings.warning_level = s.whole(0, 1000); }},
    {"Width", [](Setting s) { s.settings.width = s.whole(1, kLargestSide); }},
    {"Work_Threads", [](Setting s) { s.settings.work_threads = s.clamped(0, kMostThreads); }},
};

}  // namespace

void apply_option(PovSettings& settings, const OptionText& option) {
    const std::string wanted = lower_case(option.name);
    for (const Option& known : kOptions) {
        if (lower_case(known.name) != wanted) continue;
        const OptionText named{std::string(known.name), option.value, option.from_command_line};
        known.apply({settings, named});
        if (known.name != "Library_Path" && known.name != "Declare") settings.given[named.name] = named.value;
        return;
    }
    std::vector<std::string_view> names;
    for (const Option& known : kOptions) names.push_back(known.name);
    const std::vector<std::string> near = nearest_names(option.name, names);
    throw OptionError("there is no option " + in_quotes(option.name), near.empty() ? "" : suggest(option.name, names));
}

bool is_true(std::string_view value) {
    const std::string lower = lower_case(value);
    return lower == "true" || lower == "yes" || lower == "on" || lower == "1";
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::string_view without_quotes(std::string_view text) {
    const bool quoted =
        text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n\f\v";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace sundog::app
