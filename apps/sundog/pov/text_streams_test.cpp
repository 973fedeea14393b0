// SPDX-License-Identifier: Apache-2.0
#include "text_streams.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "base/diagnostics.h"
#include "base/test_folder.h"
#include "command_line.h"
#include "ini_writer.h"

namespace sundog::app {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

PovSettings settings_in(const fs::path& folder, const std::vector<std::string>& words) {
    return read_command_line(words, {folder, {}, {}, {}}, {});
}

// Catches streams that reach the wrong place, or the console although they are turned off.
TEST(TextStreams, GoToConsoleAndFiles) {
    const TestFolder folder;
    const std::string file = (folder.path() / "debug.txt").string();
    const PovSettings s = settings_in(folder.path(), {"-GA", "+GD" + file, "-GD", "+GW"});
    std::string console;
    {
        TextStreams streams(s, output_policy(s, folder.path()), [&](std::string_view text) { console += text; });
        streams.write(PovText::debug, "one\n");
        streams.write(PovText::warning, "two\n");
        streams.write(PovText::render, "three\n");
        streams.write(PovText::debug, "four\n");
    }
    EXPECT_EQ(console, "two\n");
    EXPECT_EQ(read(file), "one\nfour\n");
}

// Catches a file that several streams share and each of them empties, and appending that doesn't.
TEST(TextStreams, ShareAndAppend) {
    const TestFolder folder;
    const std::string file = folder.write("all.txt", "before\n").string();
    for (const bool append : {true, false}) {
        std::vector<std::string> words{"+GA" + file};
        if (append) words.emplace_back("+GP");
        const PovSettings s = settings_in(folder.path(), words);
        TextStreams streams(s, output_policy(s, folder.path()), {});
        streams.write(PovText::fatal, "a\n");
        streams.write(PovText::statistic, "b\n");
        EXPECT_EQ(read(file), append ? "before\na\nb\n" : "a\nb\n");
    }
}

// Catches INI files that write where the command line didn't allow it: by absolute names, by .., through links, into
// hidden files and devices.
TEST(TextStreams, IniFilesCannotWriteElsewhere) {
    const TestFolder folder;
    const fs::path work = folder.path() / "work";
    folder.write("work/here.txt", "");
    folder.write("outside.txt", "precious");
    fs::create_symlink(folder.path() / "outside.txt", work / "link");
    for (const fs::path& target : {folder.path() / "outside.txt", work / "../outside.txt", work / "link",
                                   work / ".profile", fs::path("/dev/null")}) {
        folder.write("work/evil.ini", "All_File=" + target.string() + "\n");
        const PovSettings s = settings_in(work, {"evil.ini"});
        EXPECT_THROW(TextStreams(s, output_policy(s, work), {}), OutputError) << target;
    }
    EXPECT_EQ(read(folder.path() / "outside.txt"), "precious");
    folder.write("work/evil.ini", "All_File=" + (folder.path() / "outside.txt").string() + "\n");
    const PovSettings allowed = settings_in(work, {"evil.ini", "--allow-write", ".."});
    EXPECT_NO_THROW(TextStreams(allowed, output_policy(allowed, work), {}));
    const PovSettings named = settings_in(work, {"+GD" + (folder.path() / "outside.txt").string()});
    EXPECT_NO_THROW(TextStreams(named, output_policy(named, work), {})) << "the command line may";
}

// Catches an INI file beside its scene, called from elsewhere, whose picture is refused; and a scene that an INI file
// names and whose folder would then be trusted.
TEST(TextStreams, FoldersOfNamedFilesMayBeWritten) {
    const TestFolder folder;
    folder.write("scenes/run.ini", "Input_File_Name=../secret/a.pov\n");
    folder.write("secret/a.pov", "");
    folder.write("elsewhere/x", "");
    const fs::path work = folder.path() / "elsewhere";
    const PovSettings s = settings_in(work, {"../scenes/run.ini"});
    const FileAccess policy = output_policy(s, work);
    EXPECT_NO_THROW(check_named_output({"", false}, folder.path() / "scenes/a.png", policy));
    EXPECT_THROW(check_named_output({"", false}, folder.path() / "secret/a.png", policy), OutputError);
}

// Catches an INI file that, read again, doesn't give the same settings.
TEST(IniWriter, RepeatsTheRun) {
    const TestFolder folder;
    const PovSettings s = settings_in(folder.path(), {"+Imy scene.pov", "+W10", "+W20", "+A0.1", "-J", "+FN16",
                                                      "+L/one two", "+Lthree", "Declare=Rad=0.1", "+GIx.ini"});
    EXPECT_EQ(ini_text(s),
              "Antialias=On\nAntialias_Threshold=0.1\nBits_Per_Color=16\nInput_File_Name=\"my scene.pov\"\nJitter=Off\n"
              "Output_File_Type=N\nOutput_to_File=On\nWidth=20\nLibrary_Path=\"/one two\"\nLibrary_Path=three\n"
              "Declare=Rad=0.1\n");
    folder.write("again.ini", ini_text(s));
    const PovSettings again = settings_in(folder.path(), {"again.ini"});
    EXPECT_EQ(ini_text(again), ini_text(s));
    EXPECT_EQ(again.input_file, "my scene.pov");
}

}  // namespace
}  // namespace sundog::app
