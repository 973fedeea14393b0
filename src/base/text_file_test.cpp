// SPDX-License-Identifier: Apache-2.0
#include "base/text_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

namespace sundog {
namespace {

/// A folder that goes away with the test.
class TextFile : public testing::Test {
protected:
    TextFile() {
        std::string pattern = (std::filesystem::temp_directory_path() / "sundog-text-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~TextFile() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::filesystem::path write(std::string_view bytes) const {
        std::filesystem::path file = folder_ / "file.txt";
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }
    static std::string message_of(const std::filesystem::path& file) {
        try {
            read_text_file(file);
        } catch (const InputError& error) {
            return error.diagnostic().message;
        }
        return "no error";
    }

    std::filesystem::path folder_;
};

// Catches a mark or old line ends that end up in the first token.
TEST_F(TextFile, UnderstandsMarksAndLineEnds) {
    EXPECT_EQ(read_text_file(write("\xef\xbb\xbfone\ntwo")).text, "one\ntwo");
    EXPECT_EQ(read_text_file(write("one\rtwo\r")).text, "one\ntwo\n");
    EXPECT_EQ(read_text_file(write("")).text, "");
}

// Catches reads of folders, pipes (which would wait for ever) and binary files.
TEST_F(TextFile, RefusesWhatIsNoText) {
    EXPECT_EQ(message_of(folder_ / "absent"), "no such file");
    EXPECT_EQ(message_of(folder_), "this is a folder");
    const std::filesystem::path pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(message_of(pipe), "not a regular file");
    EXPECT_EQ(message_of("/dev/zero"), "not a regular file");
    EXPECT_EQ(message_of(write(std::string_view("a\0b", 3))), "not a text file: it holds binary data");
    EXPECT_EQ(message_of(write("\xff\xfe"
                               "a")),
              "the file is UTF-16 text");
}

// Catches an attempt to hold a file larger than the memory (here one of holes, so that it costs nothing).
TEST_F(TextFile, RefusesFilesLargerThanTheMemory) {
    const std::filesystem::path file = write(std::string(8192, '#'));
    std::error_code error;
    std::filesystem::resize_file(file, std::uintmax_t{1} << 42U, error);
    if (error) GTEST_SKIP() << "the file system has no sparse files";
    EXPECT_NE(message_of(file).find("larger than half"), std::string::npos) << message_of(file);
}

// Catches messages that point beside the token, also in a line that was continued over several.
TEST(LineCursor, PointsAtWhatIsWrong) {
    const SourceText text = text_in_memory("a.txt", "first\nv 1 x2 3\n");
    LineReader lines(text);
    std::string_view line;
    ASSERT_TRUE(lines.next(line));
    ASSERT_TRUE(lines.next(line));
    LineCursor cursor = lines.cursor(line);
    cursor.token("v");
    EXPECT_EQ(cursor.number("a number"), 1.0F);
    try {
        cursor.number("three numbers");
        FAIL() << "'x2' was taken for a number";
    } catch (const InputError& error) {
        EXPECT_EQ(format(error.diagnostic()),
                  "a.txt:2:5: error: bad number 'x2'\n    2 | v 1 x2 3\n      |     ^\nhint: expected three numbers");
    }
    const SourceText continued = text_in_memory("b.txt", "f 1 \\\n 2 y\n");
    const std::string_view all = continued.text;
    const Diagnostic d = diagnose(Severity::error, continued, all, 7, all.data() + 9, "bad");
    EXPECT_EQ(d.where.line, 8U);
    EXPECT_EQ(d.where.column, 4U);
    EXPECT_EQ(d.source_line, " 2 y");
}

// Catches quotes and blanks that become part of a name.
TEST(LineCursor, TakesNamesAndRests) {
    const SourceText text = text_in_memory("a.txt", "  \"two words\" next  rest of it \t");
    LineCursor cursor(text, text.text, 1);
    EXPECT_EQ(cursor.name("a name"), "two words");
    EXPECT_EQ(cursor.name("a name"), "next");
    EXPECT_EQ(cursor.rest("a rest"), "rest of it");
    EXPECT_THROW(cursor.token("more"), InputError);
}

}  // namespace
}  // namespace sundog
