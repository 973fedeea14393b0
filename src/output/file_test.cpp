// SPDX-License-Identifier: Apache-2.0
#include "output/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "base/diagnostics.h"
#include "output/test_files.h"

namespace sundog::output {
namespace {

namespace fs = std::filesystem;

std::string write_error(const fs::path& file, const std::string& bytes = "new") {
    try {
        write_file_atomically(file, bytes);
    } catch (const OutputError& error) {
        return error.what();
    }
    return "no error";
}

std::string read_error(const fs::path& file) {
    try {
        read_file(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

/// Lets files of this process grow to `bytes` only, as a full disk would.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limited{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

// Catches a temporary file left behind, lost bytes, and a replaced file that changes its permissions.
TEST(WriteFile, ReplacesAFileWhole) {
    const TemporaryFolder folder;
    put(folder / "a", "old and longer");
    ::chmod((folder / "a").c_str(), 0640);
    write_file_atomically(folder / "a", std::string("n\0w", 3));
    EXPECT_EQ(get(folder / "a"), std::string("n\0w", 3));
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
    EXPECT_EQ(folder.entries(), 1U);
}

// Catches a failed write that harms the old file, hides the reason or leaves its temporary file.
TEST(WriteFile, AFullDiskLeavesTheOldFile) {
    const TemporaryFolder folder;
    put(folder / "a", "old");
    {
        const FileSizeLimit limit(1000);
        const std::string message = write_error(folder / "a", std::string(5000, 'x'));
        EXPECT_NE(message.find((folder / "a").string() + "': File too large"), std::string::npos) << message;
    }
    EXPECT_EQ(get(folder / "a"), "old");
    EXPECT_EQ(folder.entries(), 1U);
}

// Catches targets that can't be files being mistaken, and messages without the reason.
TEST(WriteFile, SaysWhyATargetCanNotBeWritten) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "d");
    EXPECT_NE(write_error(folder / "d").find("d': it is a folder"), std::string::npos);
    EXPECT_NE(write_error(folder / "none/a").find("there is no folder '"), std::string::npos);
    // Creating a file there fails as it does in a folder that isn't there.
    EXPECT_NE(write_error("/proc/a").find("/proc/a': the folder '/proc' takes no files"), std::string::npos);
    put(folder / "f", "");
    EXPECT_NE(write_error(folder / "f/a").find("Not a directory"), std::string::npos);
    EXPECT_EQ(folder.entries(), 2U);
}

// Catches a device or a symbolic link being replaced by a regular file.
TEST(WriteFile, WritesToWhatIsNoRegularFile) {
    const TemporaryFolder folder;
    EXPECT_EQ(write_error("/dev/null"), "no error");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_NE(write_error("/dev/full").find("No space left on device"), std::string::npos);
    put(folder / "real", "old");
    fs::create_symlink("real", folder / "link");
    write_file_atomically(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(get(folder / "real"), "new");
}

// Catches a reader that hangs on a pipe, reads a device for ever, or takes a folder for an empty file.
TEST(ReadFile, ReadsRegularFilesOnly) {
    const TemporaryFolder folder;
    put(folder / "a", std::string("x\0y", 3));
    EXPECT_EQ(read_file(folder / "a"), (std::vector<unsigned char>{'x', 0, 'y'}));
    EXPECT_EQ(read_error(folder / "none"),
              (folder / "none").string() + ": error: can't read the file: No such file or directory");
    EXPECT_NE(read_error(folder / "").find("it is a folder"), std::string::npos);
    EXPECT_NE(read_error("/dev/zero").find("it is no regular file"), std::string::npos);
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_NE(read_error(folder / "pipe").find("it is no regular file"), std::string::npos);
}

}  // namespace
}  // namespace sundog::output
