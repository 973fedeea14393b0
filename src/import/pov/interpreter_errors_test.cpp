// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "base/test_folder.h"
#include "import/pov/pov_language_test.h"

namespace sundog::pov {
namespace {

/// The message that reading the scene ends with.
std::string message(const std::string& scene, const PovOptions& options = {}) {
    try {
        formatted(scene, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Messages without the place, the caret or the nearest name.
TEST(PovErrors, UndeclaredIdentifiersHaveNearestNames) {
    const std::string text = message("#declare Radius = 1;\nsphere { 0,\n  Radis }");
    EXPECT_TRUE(holds(text, "test.pov:3:3: error: undeclared identifier 'Radis'")) << text;
    EXPECT_TRUE(holds(text, "    3 |   Radis }\n      |   ^")) << text;
    EXPECT_TRUE(holds(text, "did you mean 'Radius'")) << text;
}

// Errors that name the wrong thing, or that end in a crash instead.
TEST(PovErrors, BrokenScenes) {
    EXPECT_TRUE(holds(message("sphere { 0, 1"), "found the end of the file"));
    EXPECT_TRUE(holds(message("sphere { 0, }}"), "found '}'"));
    EXPECT_TRUE(holds(message("#if (1) sphere { 0, 1 }"), "#if has no #end"));
    EXPECT_TRUE(holds(message("#end"), "#end without"));
    EXPECT_TRUE(holds(message("#while (0)"), "#while has no #end"));
    EXPECT_TRUE(holds(message("#macro M(A) #end M()"), "M takes 1 parameters, not 0"));
    EXPECT_TRUE(holds(message("#macro M() #end M(1)"), "expected ')'"));
    EXPECT_TRUE(holds(message("#declare sphere = 1;"), "is a reserved word"));
    EXPECT_TRUE(holds(message("#declar A = 1;"), "did you mean 'declare'"));
    EXPECT_TRUE(holds(message("#declare A = array[2]; #declare A[2] = 1;"), "elements 0 to 1"));
    EXPECT_TRUE(holds(message("#declare A = array[2]; #declare B = A[0];"), "no value yet"));
    EXPECT_TRUE(holds(message("#include \"nowhere.inc\""), "can't find the file 'nowhere.inc'"));
    EXPECT_TRUE(holds(message("#error \"as the scene says\""), "as the scene says"));
    EXPECT_TRUE(holds(message("#declare T = texture {}; sphere { 0, T*2 }"), "found '*'"));
    EXPECT_TRUE(holds(message("sphere { 0, \"open }"), "no closing quote"));
    EXPECT_TRUE(holds(message("/* open"), "comment has no end"));
    EXPECT_TRUE(holds(message("#declare F = function(x) { y }"), "'y' is no parameter"));
    EXPECT_TRUE(holds(message("#declare F = function(x) { x } background { F(1, 2) }"), "takes 1 arguments, not 2"));
    EXPECT_TRUE(holds(message("#declare A = rand(0);"), "seed()"));
    EXPECT_TRUE(holds(message("#declare S = sphere { 0, 1 } #declare A = min_extent(S);"), "shape"));
    EXPECT_TRUE(holds(message("5"), "expected an object"));
}

// A finish within a finish, which povray refuses; a declared one by its name is none, where it comes first.
TEST(PovErrors, FinishesDontNest) {
    EXPECT_TRUE(holds(message("sphere { 0, 1 finish { finish { phong 1 } } }"), "found 'finish'"));
    const std::string declared = "#declare F = finish { phong 1 }; ";
    EXPECT_TRUE(holds(message(declared + "sphere { 0, 1 finish { diffuse 1 F } }"), "behind other items"));
    EXPECT_EQ(formatted(declared + "sphere { 0, 1 finish { F diffuse 1 } }"),
              formatted("sphere { 0, 1 finish { phong 1 diffuse 1 } }"));
}

// What is wrong in parts that are never read mustn't stop a scene.
TEST(PovErrors, SkippedPartsMayBeWrong) {
    EXPECT_EQ(message("#if (0) #nonsense \xff ^ undeclared { #end"), "no error");
}

// Scenes that would take all time, stack or memory.
TEST(PovErrors, LimitsStopRunawayScenes) {
    PovOptions options;
    options.limits.steps = 100000;
    EXPECT_TRUE(holds(message("#while (1) #end", options), "more than 100000 steps"));
    EXPECT_TRUE(holds(message("#declare F = function(x) { sum(i, 1, 1e9, i) } background { F(1) }", options),
                      "more than 100000 steps"));
    EXPECT_TRUE(holds(message("#macro M() M() #end M()"), "more than 200 macros within each other"));
    EXPECT_TRUE(holds(message("background { " + std::string(100000, '(')), "more than 400 brackets"));
    EXPECT_TRUE(holds(message("background { " + std::string(100000, '-') + "1 }"), "more than 400 brackets"));
    EXPECT_TRUE(holds(message("#declare O = sphere { 0, 1 } #while (1) #declare O = object { O } #end"), "400 levels"));
    EXPECT_TRUE(holds(message("#declare A = array[1]{1} #while (1) #declare A = array[1]{A} #end"), "400 levels"));
    EXPECT_TRUE(holds(message("#declare A = array[100000][100000][100000];"), "limit of memory"));
    EXPECT_TRUE(
        holds(message("#declare S = \"0123456789abcdef\" #while (1) #declare S = concat(S, S) #end"), "64 MiB"));
    EXPECT_TRUE(holds(message("#declare F = function(x) { x } #while (1) #declare G = function(x) { F(x) } "
                              "#declare F = function(x) { G(x) } #end"),
                      "levels deep"));
}

// Files that include themselves; names that the includer's folder should answer.
TEST(PovFiles, Includes) {
    const TestFolder folder;
    folder.write("sub/a.inc", "#include \"b.inc\" #local L = 1; #declare G = 2;");
    folder.write("sub/b.inc", "#debug \"b\"");
    const auto scene =
        folder.write("s.pov", "#include \"sub\\a.inc\" #debug str(G,0,0) #ifndef (L) #debug \"L gone\" #end");
    std::string text;
    PovOptions options;
    options.print = [&](PovStream, std::string_view line) { text += line; };
    std::string blocks;
    FormattingSink sink(blocks);
    SourceFiles sources;
    interpret(scene, options, sources, sink, nullptr, {});
    EXPECT_EQ(text, "b2L gone");
    EXPECT_EQ(sources.paths().size(), 3U);
    const auto endless = folder.write("r.pov", "#include \"r.pov\"");
    EXPECT_THROW(interpret(endless, options, sources, sink, nullptr, {}), InputError);
}

// Scenes that write where they weren't allowed to, or that can't read what they have written.
TEST(PovFiles, WritingAndReading) {
    const TestFolder folder, output;
    const auto scene = folder.write(
        "s.pov",
        "#fopen F \"data.txt\" write #write (F, \"\\\"text\\\",\", 1.5, \",\", <1,-2,3>, \"\\n\") #fclose F\n"
        "#fopen F \"data.txt\" read #read (F, S, N, V) #debug concat(S, str(N,0,1), vstr(3,V,\" \",0,0))\n"
        "#ifndef (F) #debug \" end\" #end");
    std::string text, blocks;
    PovOptions options;
    options.print = [&](PovStream, std::string_view line) { text += line; };
    FormattingSink sink(blocks);
    SourceFiles sources;
    EXPECT_THROW(interpret(scene, options, sources, sink, nullptr, {}), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "data.txt"));
    options.access.writable = {output.path()};
    interpret(scene, options, sources, sink, nullptr, {});
    EXPECT_EQ(text, "text1.51 -2 3 end");
    EXPECT_TRUE(std::filesystem::exists(output.path() / "data.txt"));
}

TEST(PovWarnings, OncePerKind) {
    Warnings warnings;
    formatted("#macro M(A, B) A*B #end background { M(1 2) } background { M(1 2) } #declare A = 1 #declare B = 2", {},
              warnings.sink());
    ASSERT_EQ(warnings.texts.size(), 2U);
    EXPECT_TRUE(holds(warnings.texts[0], "comma is missing"));
    EXPECT_TRUE(holds(warnings.texts[1], "no ';'"));
}

}  // namespace
}  // namespace sundog::pov
