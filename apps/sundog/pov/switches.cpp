// SPDX-License-Identifier: Apache-2.0
#include "switches.h"

#include <algorithm>
#include <string>

#include "base/text_file.h"

namespace sundog::app {
namespace {

/// What may follow a switch's letters.
enum class Follows : std::uint8_t {
    nothing,   // +UA -UA: on or off
    value,     // +W320 -W320: the same with either sign
    optional,  // +A -A +A0.3 -A0.3: on or off, and the value, if any, is kept for later either way
    stream,    // +GA -GA +GAfile
    display,   // +D -D +D0 +D0T
    file,      // +F -F +FN16
};

struct Switch {
    std::string_view letters;
    Follows follows;
    std::string_view on_off;  // INI option that the sign sets; empty: none.
    std::string_view value;   // INI option that the value sets; empty: none, what follows is read and dropped.
};

// Reference, section 3.2. Where one switch's letters begin another's, the longer one is meant.
constexpr Switch kSwitches[] = {
    {"A", Follows::optional, "Antialias", "Antialias_Threshold"},
    {"AG", Follows::value, "", "Antialias_Gamma"},
    {"AM", Follows::value, "", "Sampling_Method"},
    {"BM", Follows::value, "", "Bounding_Method"},
    {"BS", Follows::value, "", "Render_Block_Size"},
    {"C", Follows::nothing, "Continue_Trace", ""},
    {"D", Follows::display, "Display", ""},
    {"EC", Follows::value, "", "End_Column"},
    {"EF", Follows::value, "", "Subset_End_Frame"},
    {"EP", Follows::value, "", "Preview_End_Size"},
    {"ER", Follows::value, "", "End_Row"},
    {"F", Follows::file, "Output_to_File", "Output_File_Type"},
    {"GA", Follows::stream, "All_Console", "All_File"},
    {"GD", Follows::stream, "Debug_Console", "Debug_File"},
    {"GF", Follows::stream, "Fatal_Console", "Fatal_File"},
    {"GI", Follows::value, "", "Create_Ini"},
    {"GP", Follows::nothing, "Append_File", ""},
    {"GR", Follows::stream, "Render_Console", "Render_File"},
    {"GS", Follows::stream, "Statistic_Console", "Statistic_File"},
    {"GW", Follows::stream, "Warning_Console", "Warning_File"},
    {"H", Follows::value, "", "Height"},
    {"HI", Follows::value, "", "Include_Header"},
    {"HR", Follows::nothing, "High_Reproducibility", ""},
    {"I", Follows::value, "", "Input_File_Name"},
    {"J", Follows::optional, "Jitter", "Jitter_Amount"},
    {"K", Follows::value, "", "Clock"},
    {"KC", Follows::nothing, "Cyclic_Animation", ""},
    {"KF", Follows::value, "", "Final_Clock"},
    {"KFF", Follows::value, "", "Final_Frame"},
    {"KFI", Follows::value, "", "Initial_Frame"},
    {"KI", Follows::value, "", "Initial_Clock"},
    {"L", Follows::value, "", "Library_Path"},
    {"MB", Follows::optional, "Bounding", "Bounding_Threshold"},
    {"MI", Follows::value, "", "Max_Image_Buffer_Memory"},
    {"MV", Follows::value, "", "Version"},
    {"O", Follows::value, "", "Output_File_Name"},
    {"P", Follows::nothing, "Pause_When_Done", ""},
    {"Q", Follows::value, "", "Quality"},
    {"R", Follows::value, "", "Antialias_Depth"},
    {"RF", Follows::value, "", "Radiosity_File_Name"},
    {"RFI", Follows::nothing, "Radiosity_From_File", ""},
    {"RFO", Follows::nothing, "Radiosity_To_File", ""},
    {"RP", Follows::value, "", "Render_Pattern"},
    {"RS", Follows::value, "", "Render_Block_Step"},
    {"RVP", Follows::nothing, "Radiosity_Vain_Pretrace", ""},
    {"SC", Follows::value, "", "Start_Column"},
    {"SF", Follows::value, "", "Subset_Start_Frame"},
    {"SP", Follows::value, "", "Preview_Start_Size"},
    {"SR", Follows::value, "", "Start_Row"},
    {"STP", Follows::value, "", "Frame_Step"},
    {"SU", Follows::nothing, "Split_Unions", ""},
    {"TH", Follows::optional, "Dither", "Dither_Method"},
    {"UA", Follows::nothing, "Output_Alpha", ""},
    {"UD", Follows::nothing, "Draw_Vistas", ""},
    {"UF", Follows::nothing, "Field_Render", ""},
    {"UL", Follows::nothing, "Light_Buffer", ""},
    {"UO", Follows::nothing, "Odd_Field", ""},
    {"UR", Follows::nothing, "Remove_Bounds", ""},
    {"UV", Follows::nothing, "Vista_Buffer", ""},
    {"V", Follows::nothing, "Verbose", ""},
    {"W", Follows::value, "", "Width"},
    {"WL", Follows::value, "", "Warning_Level"},
    {"WT", Follows::value, "", "Work_Threads"},
    {"X", Follows::optional, "Test_Abort", "Test_Abort_Count"},
};

/// The longest one whose letters `word` begins with and that allows what follows them.
const Switch* find_switch(std::string_view word) {
    const std::string lower = lower_case(word);
    const Switch* best = nullptr;
    for (const Switch& known : kSwitches) {
        if (!lower.starts_with(lower_case(known.letters))) continue;
        if (known.follows == Follows::nothing && lower.size() != known.letters.size()) continue;
        if (!best || known.letters.size() > best->letters.size()) best = &known;
    }
    return best;
}

}  // namespace

std::vector<OptionText> options_of_switch(std::string_view word, bool from_command_line) {
    const bool on = word.starts_with('+');
    const std::string_view body = word.substr(1);
    const Switch* const found = find_switch(body);
    if (!found) throw OptionError("there is no switch " + in_quotes(word), "'sundog pov --help' lists them");
    const std::string_view value = body.substr(found->letters.size());
    std::vector<OptionText> options;
    const auto set = [&](std::string_view name, std::string_view text) {
        if (!name.empty()) options.push_back({std::string(name), std::string(text), from_command_line});
    };
    set(found->on_off, on ? "On" : "Off");
    switch (found->follows) {
        case Follows::nothing:
            break;
        case Follows::value:
            if (value.empty())
                throw OptionError("the switch " + in_quotes(word) + " needs a value",
                                  "without a blank between, as in +" + std::string(found->letters) + "…, or " +
                                      std::string(found->value) + "=…");
            set(found->value, value);
            break;
        case Follows::optional:
        case Follows::stream:
            if (!value.empty()) set(found->value, value);
            break;
        case Follows::display:
            // A video mode and a palette, each one character, of displays long gone.
            if (value.size() > 2)
                throw OptionError("there is no switch " + in_quotes(word), "+D or -D turns the display on or off");
            break;
        case Follows::file: {
            if (value.empty()) break;
            set(found->value, value.substr(0, 1));
            std::string_view depth = value.substr(1);
            if (lower_case(depth.substr(0, 1)) == "g") {
                set("Grayscale_Output", "On");
                depth.remove_prefix(1);
            }
            if (!depth.empty()) set("Bits_Per_Color", depth);
            break;
        }
    }
    return options;
}

}  // namespace sundog::app
