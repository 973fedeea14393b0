// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <gtest/gtest.h>

#include "../usage_error.h"
#include "base/test_folder.h"

namespace sundog::app {
namespace {

using Words = std::vector<std::string>;

/// A working folder, a home and a system INI file of their own.
class CommandLine : public testing::Test {
protected:
    PovSettings read(const Words& words) {
        warnings_.clear();
        return read_command_line(words, surroundings_, [this](const Diagnostic& d) { warnings_.push_back(d.message); });
    }
    /// The message and hint with which `words` are refused.
    std::string refusal(const Words& words) {
        try {
            read(words);
        } catch (const UsageError& error) {
            return std::string(error.what()) + " | " + error.hint();
        } catch (const InputError& error) {
            return error.what();
        }
        return "not refused";
    }
    TestFolder folder_;
    PovSurroundings surroundings_{folder_.path(), {}, folder_.path() / "home", {folder_.path() / "etc/povray.ini"}};
    std::vector<std::string> warnings_;
};

// Catches a switch that is taken for another, dropped, or sets another value than its INI option.
TEST_F(CommandLine, EachSwitchIsItsIniOption) {
    const std::vector<std::pair<std::string, std::map<std::string, std::string>>> switches{
        {"+A", {{"Antialias", "On"}}},
        {"-A0.2", {{"Antialias", "Off"}, {"Antialias_Threshold", "0.2"}}},
        {"+a0.1", {{"Antialias", "On"}, {"Antialias_Threshold", "0.1"}}},
        {"+AM2", {{"Sampling_Method", "2"}}},
        {"+AG1.0", {{"Antialias_Gamma", "1.0"}}},
        {"+BM2", {{"Bounding_Method", "2"}}},
        {"+BS16", {{"Render_Block_Size", "16"}}},
        {"+C", {{"Continue_Trace", "On"}}},
        {"-D", {{"Display", "Off"}}},
        {"+D0T", {{"Display", "On"}}},
        {"+EC0.5", {{"End_Column", "0.5"}}},
        {"+EF3", {{"Subset_End_Frame", "3"}}},
        {"+EP8", {{"Preview_End_Size", "8"}}},
        {"+ER20", {{"End_Row", "20"}}},
        {"+F", {{"Output_to_File", "On"}}},
        {"-F", {{"Output_to_File", "Off"}}},
        {"+FN16", {{"Output_to_File", "On"}, {"Output_File_Type", "N"}, {"Bits_Per_Color", "16"}}},
        {"+fng", {{"Output_to_File", "On"}, {"Output_File_Type", "n"}, {"Grayscale_Output", "On"}}},
        {"-GA", {{"All_Console", "Off"}}},
        {"+GDa.txt", {{"Debug_Console", "On"}, {"Debug_File", "a.txt"}}},
        {"-GF", {{"Fatal_Console", "Off"}}},
        {"+GIa.ini", {{"Create_Ini", "a.ini"}}},
        {"+GP", {{"Append_File", "On"}}},
        {"-GR", {{"Render_Console", "Off"}}},
        {"-GSb", {{"Statistic_Console", "Off"}, {"Statistic_File", "b"}}},
        {"+GW", {{"Warning_Console", "On"}}},
        {"+H480", {{"Height", "480"}}},
        {"+HIa.inc", {{"Include_Header", "a.inc"}}},
        {"+HR", {{"High_Reproducibility", "On"}}},
        {"+Ia.pov", {{"Input_File_Name", "a.pov"}}},
        {"+J0.5", {{"Jitter", "On"}, {"Jitter_Amount", "0.5"}}},
        {"-J", {{"Jitter", "Off"}}},
        {"+K2.5", {{"Clock", "2.5"}}},
        {"-KC", {{"Cyclic_Animation", "Off"}}},
        {"+KF2.0", {{"Final_Clock", "2.0"}}},
        {"+KFF10", {{"Final_Frame", "10"}}},
        {"+KFI3", {{"Initial_Frame", "3"}}},
        {"+KI-1", {{"Initial_Clock", "-1"}}},
        {"-MB", {{"Bounding", "Off"}}},
        {"+MI200", {{"Max_Image_Buffer_Memory", "200"}}},
        {"+MV3.6", {{"Version", "3.6"}}},
        {"+Oa.png", {{"Output_File_Name", "a.png"}}},
        {"+O-", {{"Output_File_Name", "-"}}},
        {"-P", {{"Pause_When_Done", "Off"}}},
        {"+Q5", {{"Quality", "5"}}},
        {"+R4", {{"Antialias_Depth", "4"}}},
        {"+RFfoo", {{"Radiosity_File_Name", "foo"}}},
        {"+RFI", {{"Radiosity_From_File", "On"}}},
        {"+RFO", {{"Radiosity_To_File", "On"}}},
        {"+RP2", {{"Render_Pattern", "2"}}},
        {"+RS3", {{"Render_Block_Step", "3"}}},
        {"-RVP", {{"Radiosity_Vain_Pretrace", "Off"}}},
        {"+SC10", {{"Start_Column", "10"}}},
        {"+SF0.25", {{"Subset_Start_Frame", "0.25"}}},
        {"+SP16", {{"Preview_Start_Size", "16"}}},
        {"+SR0.75", {{"Start_Row", "0.75"}}},
        {"+STP5", {{"Frame_Step", "5"}}},
        {"-SU", {{"Split_Unions", "Off"}}},
        {"+THfs", {{"Dither", "On"}, {"Dither_Method", "fs"}}},
        {"+UA", {{"Output_Alpha", "On"}}},
        {"+UD", {{"Draw_Vistas", "On"}}},
        {"+UF", {{"Field_Render", "On"}}},
        {"-UL", {{"Light_Buffer", "Off"}}},
        {"+UO", {{"Odd_Field", "On"}}},
        {"-UR", {{"Remove_Bounds", "Off"}}},
        {"+UV", {{"Vista_Buffer", "On"}}},
        {"-V", {{"Verbose", "Off"}}},
        {"-W320", {{"Width", "320"}}},
        {"+WL5", {{"Warning_Level", "5"}}},
        {"+WT4", {{"Work_Threads", "4"}}},
        {"+X", {{"Test_Abort", "On"}}},
        {"+X10", {{"Test_Abort", "On"}, {"Test_Abort_Count", "10"}}},
    };
    for (const auto& [word, options] : switches) EXPECT_EQ(read({word}).given, options) << word;
}

// Catches values that reach the wrong field, or none.
TEST_F(CommandLine, ValuesReachTheSettings) {
    const PovSettings s = read({"+Iscene.pov",
                                "+Oout.png",
                                "+W320.7",
                                "+H200",
                                "+FN16",
                                "+UA",
                                "+A0.1",
                                "+AM2",
                                "+R12",
                                "+J0.5",
                                "+Q15",
                                "+WT3",
                                "+Lone",
                                "+Ltwo",
                                "+Lone",
                                "+HIh.inc",
                                "+MV3.6",
                                "-GD",
                                "+GSs.txt",
                                "+KFI2",
                                "+KFF9",
                                "+KI0.5",
                                "+KF1.5",
                                "+KC",
                                "+SF3",
                                "+EF0.5",
                                "+STP2",
                                "+SC0.25",
                                "+EC30",
                                "+SR5",
                                "+ER0.75",
                                "+C",
                                "+P",
                                "+D",
                                "+V",
                                "Declare=Rad=2.5",
                                "File_Gamma=1.8",
                                "Compression=70"});
    EXPECT_EQ(s.input_file, "scene.pov");
    ASSERT_TRUE(s.output_file);
    EXPECT_EQ(s.output_file->name, "out.png");
    EXPECT_TRUE(s.output_file->from_command_line);
    EXPECT_EQ(s.width, 320) << "the whole part";
    EXPECT_EQ(s.height, 200);
    EXPECT_EQ(s.file_type, PovFileType::png);
    EXPECT_EQ(s.bits_per_color, 16);
    EXPECT_TRUE(s.output_alpha && s.antialias && s.jitter && s.continue_trace && s.pause_when_done && s.display &&
                s.verbose && s.cyclic_animation);
    EXPECT_EQ(s.antialias_threshold, 0.1);
    EXPECT_EQ(s.sampling_method, 2);
    EXPECT_EQ(s.antialias_depth, 9) << "brought into its range";
    EXPECT_EQ(s.jitter_amount, 0.5);
    EXPECT_EQ(s.quality, 11) << "brought into its range";
    EXPECT_EQ(s.work_threads, 3);
    EXPECT_EQ(s.library_paths, (Words{"one", "two"}));
    EXPECT_EQ(s.include_header, "h.inc");
    EXPECT_EQ(s.version, 3.6);
    EXPECT_FALSE(s.text[static_cast<std::size_t>(PovText::debug)].console);
    EXPECT_EQ(s.text[static_cast<std::size_t>(PovText::statistic)].file->name, "s.txt");
    EXPECT_EQ(s.initial_frame, 2);
    EXPECT_EQ(s.final_frame, 9);
    EXPECT_EQ(s.initial_clock, 0.5);
    EXPECT_EQ(s.final_clock, 1.5);
    EXPECT_EQ(s.subset_start_frame, 3);
    EXPECT_EQ(s.subset_end_frame, 0.5);
    EXPECT_EQ(s.frame_step, 2);
    EXPECT_EQ(s.start_column, 0.25);
    EXPECT_EQ(s.end_column, 30);
    EXPECT_EQ(s.start_row, 5);
    EXPECT_EQ(s.end_row, 0.75);
    ASSERT_EQ(s.declarations.size(), 1U);
    EXPECT_EQ(s.declarations[0].name, "Rad");
    EXPECT_EQ(s.declarations[0].value, 2.5);
    EXPECT_EQ(s.file_gamma, 1.8);
    EXPECT_EQ(s.jpeg_quality, 70);
}

// Catches bad words that are swallowed, or refused without saying what would be right.
TEST_F(CommandLine, RefusesBadWords) {
    const std::vector<std::pair<Words, std::string>> bad{
        {{"a.pov", "+Znonsense"}, "no switch '+Znonsense'"},
        {{"a.pov", "-display", ":0"}, "no switch '-display'"},
        {{"a.pov", "+Wabc"}, "Width can't be 'abc'"},
        {{"a.pov", "+W"}, "needs a value"},
        {{"a.pov", "+W0"}, "from 1 to 65535"},
        {{"a.pov", "+W-8"}, "from 1 to 65535"},
        {{"a.pov", "+H1e9"}, "from 1 to 65535"},
        {{"a.pov", "+W8x"}, "expected a number"},
        {{"a.pov", "+Knan"}, "expected a number"},
        {{"a.pov", "+FX"}, "N (PNG)"},
        {{"a.pov", "+K"}, "needs a value"},
        {{"a.pov", "+GI"}, "needs a value"},
        {{"a.pov", "Widht=8"}, "did you mean 'Width'"},
        {{"a.pov", "Declare=x"}, "Declare=NAME=NUMBER"},
        {{"a.pov", "Declare=1x=2"}, "Declare=NAME=NUMBER"},
        {{"a.pov", "Declare=x=y"}, "expected a number"},
        {{"a.pov", "File_Gamma=foo"}, "expected a number"},
        {{"nofile"}, "no INI file 'nofile'"},
        {{"a.pov", "--sandbx"}, "did you mean '--sandbox'"},
        {{"a.pov", "--allow-write"}, "needs a value"},
        {{"a.pov", "--max-steps", "-1"}, "from 1"},
    };
    for (const auto& [words, said] : bad)
        EXPECT_NE(refusal(words).find(said), std::string::npos) << words.back() << ": " << refusal(words);
}

// Catches an order of reading other than POV-Ray's: default INI, then the words from left to right.
TEST_F(CommandLine, LaterSettingsWin) {
    folder_.write("etc/povray.ini", "Width=800\nHeight=600\nLibrary_Path=/usr/lib/pov\n");
    folder_.write("small.ini", "Width=80\nLibrary_Path=more\n");
    PovSettings s = read({});
    EXPECT_EQ(s.width, 800);
    EXPECT_EQ(s.height, 600);
    s = read({"+W10", "small", "+Lmine"});
    EXPECT_EQ(s.width, 80) << "the INI file stands after the switch";
    EXPECT_EQ(s.library_paths, (Words{"/usr/lib/pov", "more", "mine"})) << "library paths add up";
    s = read({"small.ini", "+W10", "Width=11", "-W12"});
    EXPECT_EQ(s.width, 12);
    s = read({"+A0.1", "-A"});
    EXPECT_FALSE(s.antialias);
    EXPECT_EQ(s.antialias_threshold, 0.1) << "the amount stays";
    EXPECT_TRUE(read({"-A0.1", "+A"}).antialias);
}

// Catches the wrong default INI file: POVINI, working folder, home, system; only the first is read.
TEST_F(CommandLine, TheFirstDefaultIniIsTheOnlyOne) {
    folder_.write("etc/povray.ini", "Width=1\nHeight=100\n");
    EXPECT_EQ(read({}).width, 1);
    folder_.write("home/.povray/3.7/povray.ini", "Width=2\n");
    EXPECT_EQ(read({}).width, 2);
    EXPECT_EQ(read({}).height, 480) << "the system's file isn't read any more";
    folder_.write("povray.ini", "Width=3\n");
    EXPECT_EQ(read({}).width, 3);
    surroundings_.povini = folder_.write("elsewhere/my.ini", "Width=4\n");
    EXPECT_EQ(read({}).width, 4);
    surroundings_.povini = folder_.path() / "missing.ini";
    EXPECT_EQ(read({}).width, 3);
    ASSERT_EQ(warnings_.size(), 1U);
    EXPECT_NE(warnings_[0].find("POVINI"), std::string::npos);
}

// Catches sections that are mixed up, and labels compared by case.
TEST_F(CommandLine, SectionsOfIniFiles) {
    folder_.write("res.ini",
                  "; resolutions\n+W120 +H100 ; two switches\n[Low]\nWidth=80 ; comment\n[Really High]\n"
                  "Width=800\n[other]\nWidth=1\n[LOW]\nHeight = 60\n");
    EXPECT_EQ(read({"res"}).width, 120);
    EXPECT_EQ(read({"res[low]"}).width, 80);
    EXPECT_EQ(read({"res[low]"}).height, 60) << "both sections of that label";
    EXPECT_EQ(read({"res.ini[REALLY HIGH]"}).width, 800);
    EXPECT_EQ(read({"res.ini[really high]"}).height, 100) << "the lines at the top count too";
    EXPECT_EQ(read({"res[lw]"}).width, 120);
    EXPECT_EQ(warnings_.size(), 1U) << "no such section";
}

// Catches quotes that stay in names, comments cut out of quotes, and apostrophes taken for quotes.
TEST_F(CommandLine, QuotesInIniFiles) {
    folder_.write("q.ini",
                  "Input_File_Name=\"my file;1.pov\" ; c\n+O'my \"big\" out.png' +W10\n# a comment too\n"
                  "Include_Header=bob's.inc\n");
    const PovSettings s = read({"q"});
    EXPECT_EQ(s.input_file, "my file;1.pov");
    EXPECT_EQ(s.output_file->name, "my \"big\" out.png");
    EXPECT_FALSE(s.output_file->from_command_line) << "an INI file is less trusted";
    EXPECT_EQ(s.width, 10);
    EXPECT_EQ(s.include_header, "bob's.inc");
    EXPECT_EQ(read({"+I\"b.pov\""}).input_file, "b.pov");
}

// Catches INI files that don't name others, or name them without end.
TEST_F(CommandLine, NestedIniFiles) {
    folder_.write("outer.ini", "inner[Deep]\nscene.pov\n");
    folder_.write("inner.ini", "Height=1\n[deep]\nHeight=77\n");
    folder_.write("loop.ini", "loop\n");
    folder_.write("lib/there.ini", "Width=55\n");
    const PovSettings s = read({"outer"});
    EXPECT_EQ(s.height, 77);
    EXPECT_EQ(s.input_file, "scene.pov");
    EXPECT_NE(refusal({"loop"}).find("too deeply"), std::string::npos) << refusal({"loop"});
    EXPECT_EQ(read({"+Llib", "there"}).width, 55) << "INI files are looked for in the library paths";
    EXPECT_NE(refusal({"there", "+Llib"}).find("no INI file"), std::string::npos) << "named too late";
}

// Catches messages about INI files without the line that is wrong.
TEST_F(CommandLine, BadIniLinesAreLocated) {
    folder_.write("bad.ini", "Width=10\n  Widht=20\n");
    EXPECT_NE(refusal({"bad"}).find("bad.ini:2:3: error: there is no option 'Widht'"), std::string::npos)
        << refusal({"bad"});
    folder_.write("two.ini", "Width=10 Height=20\n");
    EXPECT_NE(refusal({"two"}).find("two.ini:1:1: error: Width can't be"), std::string::npos) << refusal({"two"});
    folder_.write("word.ini", "+W10 oops\n");
    EXPECT_NE(refusal({"word"}).find("expected a switch"), std::string::npos) << refusal({"word"});
    folder_.write("open.ini", "[low\n");
    EXPECT_NE(refusal({"open"}).find("expected [label]"), std::string::npos) << refusal({"open"});
}

// Catches shell commands that are forgotten without a word, and Sundog's own switches.
TEST_F(CommandLine, ShellCommandsAndOwnSwitches) {
    folder_.write("cmd.ini", "Pre_Scene_Command=touch x\nPost_Frame_Command=rm -rf y\nUser_Abort_Return=F\n");
    EXPECT_EQ(read({"cmd"}).shell_commands, (Words{"Pre_Scene_Command", "Post_Frame_Command"}));
    const PovSettings s = read({"a.pov", "--sandbox", "--allow-write", "x", "--allow-write=y", "--max-steps=1000",
                                "--max-memory", "64", "--device", "cpu"});
    EXPECT_TRUE(s.sandbox);
    EXPECT_EQ(s.allow_write, (Words{"x", "y"}));
    EXPECT_EQ(s.max_steps, 1000U);
    EXPECT_EQ(s.max_memory_mb, 64U);
    EXPECT_EQ(s.device, "cpu");
    EXPECT_EQ(read({"-?"}).wanted, PovSettings::Wanted::help);
    EXPECT_EQ(read({"+H"}).wanted, PovSettings::Wanted::help) << "the only word";
    EXPECT_EQ(read({"a.pov", "--format"}).wanted, PovSettings::Wanted::formatted);
    EXPECT_EQ(read({"--version"}).wanted, PovSettings::Wanted::version);
}

// Catches bare words that are taken for the wrong kind of file, and folders that are trusted without having been named.
TEST_F(CommandLine, BareNames) {
    folder_.write("a.pov", "");
    folder_.write("d/s.ini", "Input_File_Name=other/x.pov\n");
    EXPECT_EQ(read({"a.pov"}).input_file, "a.pov");
    EXPECT_EQ(read({"a"}).input_file, "a.pov") << "no INI file of that name";
    EXPECT_EQ(read({"a.pov", "B.POV"}).input_file, "B.POV") << "the last one counts";
    const PovSettings s = read({"d/s.ini"});
    EXPECT_EQ(s.input_file, "other/x.pov");
    ASSERT_EQ(s.command_line_folders.size(), 1U) << "the INI file's, not that of the scene that it names";
    EXPECT_EQ(s.command_line_folders[0], folder_.path() / "d");
}

}  // namespace
}  // namespace sundog::app
