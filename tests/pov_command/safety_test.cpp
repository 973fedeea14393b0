// SPDX-License-Identifier: Apache-2.0
// What a scene or an INI file from a stranger tries, and what comes of it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "program.h"

namespace sundog::tests {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* kRest =
    "\ncamera { location -4*z look_at 0 } light_source { -9*z rgb 1 } sphere { 0, 1 pigment { rgb 1 } }\n";

/// work/ is where the scene lies and is rendered; secret.txt lies beside it.
class Safety : public testing::Test {
protected:
    Safety() {
        fs::create_directories(work() / "sub");
        write_bytes(folder_ / "secret.txt", "\"precious\"");
        write_bytes(folder_ / "secret.inc", "#debug \"read the secret\\n\"\n");
    }
    [[nodiscard]] fs::path work() const { return folder_ / "work"; }
    [[nodiscard]] fs::path secret() const { return folder_ / "secret.txt"; }
    Outcome render(const std::string& statements, Words words = {}) {
        write_bytes(work() / "a.pov", "#version 3.7;\n" + statements + kRest);
        words.insert(words.begin(), {"pov", "a.pov", "+W16", "+H12", "--device", "cpu"});
        return run(words, work());
    }
    void expect_refused(const Outcome& outcome, const std::string& said) {
        EXPECT_EQ(outcome.status, 1) << outcome.err;
        EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
        EXPECT_EQ(read_bytes(secret()), "\"precious\"");
    }
    TemporaryFolder folder_;
};

std::string writing(const fs::path& file, const std::string& mode = "write") {
    return "#fopen F \"" + file.string() + "\" " + mode + "\n#write (F, \"gotcha\\n\")\n#fclose F\n";
}

// Catches a policy that forbids what scenes may do: files beside the picture.
TEST_F(Safety, ScenesMayWriteBelowTheOutput) {
    const Outcome outcome = render(writing("data.txt") + writing("sub/more.txt") + writing("sub/more.txt", "append"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(read_bytes(work() / "data.txt"), "gotcha\n");
    EXPECT_EQ(read_bytes(work() / "sub/more.txt"), "gotcha\ngotcha\n");
}

// Catches each way out for #fopen: absolute names, .., links to files and folders, links to what isn't there yet,
// hidden files, devices and pipes.
TEST_F(Safety, ScenesCannotWriteElsewhere) {
    fs::create_symlink(secret(), work() / "link");
    fs::create_symlink("..", work() / "up");
    fs::create_symlink("../new.txt", work() / "dangling");
    ASSERT_EQ(::mkfifo((work() / "pipe").c_str(), 0600), 0);
    for (const char* mode : {"write", "append"}) {
        for (const fs::path& file : {secret(), fs::path("../secret.txt"), fs::path("sub/../../secret.txt"),
                                     fs::path("link"), fs::path("up/secret.txt"), fs::path("dangling"),
                                     fs::path(".profile"), fs::path("/dev/null"), fs::path("pipe")}) {
            SCOPED_TRACE(file.string() + " " + mode);
            expect_refused(render(writing(file, mode)), "write");
        }
    }
    EXPECT_FALSE(fs::exists(folder_ / "new.txt"));
    EXPECT_FALSE(fs::exists(work() / ".profile"));
    EXPECT_FALSE(fs::exists(work() / "a.png")) << "no picture of a scene that was refused";
    EXPECT_EQ(render(writing("../allowed.txt"), {"--allow-write", ".."}).status, 0);
    EXPECT_EQ(read_bytes(folder_ / "allowed.txt"), "gotcha\n");
}

// Catches photons that are saved elsewhere, not saved, or not what a picture is made of when they are loaded.
TEST_F(Safety, PhotonsAreSavedBelowTheOutput) {
    const auto photons = [](const std::string& items) {
        return "global_settings { photons { " + items +
               " } }\nplane { y, -2 pigment { rgb 1 } }\n"
               "sphere { 2*x, 0.5 pigment { rgb 1 } finish { reflection 1 } photons { target reflection on } }\n";
    };
    fs::create_symlink(secret(), work() / "link.ph");
    for (const fs::path& file :
         {secret(), fs::path("../secret.txt"), fs::path("link.ph"), fs::path(".photons"), fs::path("/dev/null")}) {
        SCOPED_TRACE(file.string());
        expect_refused(render(photons("count 2000 save_file \"" + file.string() + "\"")), "can't write to");
    }
    EXPECT_FALSE(fs::exists(work() / "a.png"));
    ASSERT_EQ(render(photons("count 2000 save_file \"sub/map.ph\"")).status, 0);
    const std::string shot = read_bytes(work() / "a.png");
    EXPECT_EQ(read_bytes(work() / "sub/map.ph").substr(0, 17), "sundog photons 1\n");
    ASSERT_EQ(render(photons("load_file \"sub/map.ph\"")).status, 0);
    EXPECT_EQ(read_bytes(work() / "a.png"), shot);
    ASSERT_EQ(render(photons("autostop 0")).status, 0);
    EXPECT_NE(read_bytes(work() / "a.png"), shot) << "photons light something here";
    EXPECT_NE(render(photons("load_file \"/dev/zero\"")).status, 0);
    EXPECT_EQ(render(photons("load_file \"../secret.txt\""), {"--sandbox"}).status, 1);
}

// The same of radiosity, by the scene and by the command line.
TEST_F(Safety, RadiosityIsSavedBelowTheOutput) {
    const auto radiosity = [](const std::string& items) {
        return "global_settings { radiosity { count 50 " + items +
               " } }\nplane { y, -2 pigment { rgb 1 } }\nsphere { 2*x, 0.5 pigment { rgb <1, 0.2, 0> } "
               "finish { emission 1 } }\n";
    };
    fs::create_symlink(secret(), work() / "link.rca");
    for (const fs::path& file :
         {secret(), fs::path("../secret.txt"), fs::path("link.rca"), fs::path(".radiosity"), fs::path("/dev/null")}) {
        SCOPED_TRACE(file.string());
        expect_refused(render(radiosity("save_file \"" + file.string() + "\"")), "can't write to");
        expect_refused(render(radiosity(""), {"+RF" + file.string(), "+RFO"}), "can't write to");
    }
    ASSERT_EQ(render(radiosity("save_file \"sub/light.rca\"")).status, 0);
    const std::string gathered = read_bytes(work() / "a.png");
    EXPECT_EQ(read_bytes(work() / "sub/light.rca").substr(0, 19), "sundog radiosity 1\n");
    ASSERT_EQ(render(radiosity("load_file \"sub/light.rca\"")).status, 0);
    EXPECT_EQ(read_bytes(work() / "a.png"), gathered);
    ASSERT_EQ(render(radiosity(""), {"+RFlight.rca", "+RFO"}).status, 0);
    EXPECT_EQ(read_bytes(work() / "light.rca"), read_bytes(work() / "sub/light.rca"));
    // Loaded light counts, whatever would be gathered now.
    ASSERT_EQ(render(radiosity("brightness 3"), {"+RFlight.rca", "+RFI"}).status, 0);
    EXPECT_EQ(read_bytes(work() / "a.png"), gathered);
    EXPECT_NE(render(radiosity("load_file \"/dev/zero\"")).status, 0);
    EXPECT_EQ(render(radiosity("load_file \"../secret.txt\""), {"--sandbox"}).status, 1);
}

// Catches INI files whose picture, texts or INI file go where the command line didn't send them.
TEST_F(Safety, IniFilesCannotWriteElsewhere) {
    for (const std::string& line : std::vector<std::string>{
             "Output_File_Name=../escaped", "+O../escaped.png", "Output_File_Name=" + (folder_ / "escaped").string(),
             std::string("All_File=../escaped.png"), std::string("Create_Ini=../escaped.png")}) {
        SCOPED_TRACE(line);
        write_bytes(work() / "evil.ini", line + "\n");
        expect_refused(render("", {"evil.ini"}), "an INI file wants to write");
        EXPECT_FALSE(fs::exists(folder_ / "escaped.png"));
    }
    write_bytes(work() / "evil.ini", "Output_File_Name=../escaped\n");
    EXPECT_EQ(render("", {"evil.ini", "--allow-write=.."}).status, 0);
    EXPECT_TRUE(fs::exists(folder_ / "escaped.png"));
    EXPECT_EQ(render("", {"+O../named.png"}).status, 0) << "the command line may";
    EXPECT_TRUE(fs::exists(folder_ / "named.png"));
}

// Catches commands that are run, or left out without a word.
TEST_F(Safety, CommandsAreNeverRun) {
    write_bytes(work() / "run.ini",
                "Pre_Scene_Command=touch ran1\nPre_Frame_Command=touch ran2\nPost_Frame_Command=touch ran3\n"
                "Post_Scene_Command=touch ran4\nUser_Abort_Command=touch ran5\nFatal_Error_Command=touch ran6\n");
    const Outcome good = render("", {"run.ini"});
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_NE(good.err.find("Pre_Scene_Command is not run"), std::string::npos) << good.err;
    EXPECT_EQ(render("#error \"no\"\n", {"run.ini"}).status, 1);
    for (int i = 1; i <= 6; ++i) EXPECT_FALSE(fs::exists(work() / ("ran" + std::to_string(i))));
}

// Catches devices and pipes that are read, which may never end.
TEST_F(Safety, OnlyRegularFilesAreRead) {
    ASSERT_EQ(::mkfifo((work() / "pipe.inc").c_str(), 0600), 0);
    for (const char* file : {"/dev/zero", "pipe.inc", "sub"}) {
        SCOPED_TRACE(file);
        EXPECT_EQ(render("#include \"" + std::string(file) + "\"\n").status, 1);
        EXPECT_EQ(render("#fopen F \"" + std::string(file) + "\" read\n#read (F, V)\n").status, 1);
        EXPECT_EQ(run({"pov", std::string("+I") + file, "+W16", "+H12"}, work()).status, 1);
    }
    EXPECT_NE(render("sphere { 0, 1 pigment { image_map { png \"/dev/zero\" } } }\n").status, -1) << "not killed";
}

// Catches a sandbox with a hole: includes, data, images and links that lead out; and one that shuts out libraries.
TEST_F(Safety, SandboxNarrowsReading) {
    fs::create_symlink("../secret.inc", work() / "link.inc");
    const std::string outside = "#include \"" + (folder_ / "secret.inc").string() + "\"\n";
    EXPECT_NE(render(outside).err.find("read the secret"), std::string::npos) << "allowed without --sandbox";
    for (const std::string& statement :
         {outside, std::string("#include \"../secret.inc\"\n"), std::string("#include \"link.inc\"\n"),
          std::string("#fopen F \"../secret.txt\" read\n#read (F, V)\n#debug V\n")}) {
        SCOPED_TRACE(statement);
        const Outcome outcome = render(statement, {"--sandbox"});
        EXPECT_EQ(outcome.status, 1) << outcome.err;
        EXPECT_EQ(outcome.err.find("read the secret"), std::string::npos);
        EXPECT_EQ(outcome.err.find("precious\n"), std::string::npos);
    }
    write_bytes(work() / "sub/own.inc", "#debug \"own\\n\"\n");
    write_bytes(folder_ / "library/lib.inc", "");
    fs::create_directories(folder_ / "library");
    write_bytes(folder_ / "library/lib.inc", "#debug \"library\\n\"\n");
    const Outcome inside = render("#include \"sub/own.inc\"\n#include \"lib.inc\"\n",
                                  {"--sandbox", "+L" + (folder_ / "library").string()});
    EXPECT_EQ(inside.status, 0) << inside.err;
    EXPECT_NE(inside.err.find("library"), std::string::npos);
}

// Catches loops without an end, bottomless macros and scenes that eat all memory.
TEST_F(Safety, LimitsAreNamed) {
    expect_refused(render("#while (1) #local A = 1; #end\n", {"--max-steps", "100000"}), "100000");
    const Outcome deep = render("#macro M() M() #end M()\n");
    EXPECT_EQ(deep.status, 1) << deep.err;
    const Outcome large = render("#declare A = array[1000][1000][1000];\n", {"--max-memory", "64"});
    EXPECT_EQ(large.status, 1) << large.err;
}

}  // namespace
}  // namespace sundog::tests
