// SPDX-License-Identifier: Apache-2.0
#include "base/file_access.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/test_folder.h"

namespace sundog {
namespace {

namespace fs = std::filesystem;

/// A folder with a part that is allowed and a part that isn't.
class FileAccessTest : public testing::Test {
protected:
    FileAccessTest() {
        folder_.write("inside/a.txt", "a");
        folder_.write("inside/deep/b.txt", "b");
        folder_.write("outside/secret.txt", "s");
        folder_.write("inside-too/c.txt", "c");
        access_.allow_writing(root() / "inside");
        access_.confine_reading({root() / "inside"});
    }
    [[nodiscard]] fs::path root() const { return folder_.path(); }
    [[nodiscard]] bool reads(const fs::path& file) const { return !access_.why_unreadable(root() / file); }
    [[nodiscard]] bool writes(const fs::path& file) const { return !access_.why_unwritable(root() / file); }
    TestFolder folder_;
    FileAccess access_;
};

// Catches a policy that refuses what it should allow.
TEST_F(FileAccessTest, AllowsWhatLiesWithin) {
    EXPECT_TRUE(reads("inside/a.txt"));
    EXPECT_TRUE(reads("inside/deep/b.txt"));
    EXPECT_TRUE(reads("outside/../inside/a.txt"));
    EXPECT_TRUE(writes("inside/a.txt"));
    EXPECT_TRUE(writes("inside/new.txt"));
    EXPECT_TRUE(writes("inside/deep/../new.txt"));
    EXPECT_TRUE(reads("inside/missing.txt")) << "what isn't there is told by opening it";
}

// Catches `..` and folders whose names begin alike as ways out.
TEST_F(FileAccessTest, RefusesDotsAndLikeNames) {
    EXPECT_FALSE(reads("inside/../outside/secret.txt"));
    EXPECT_FALSE(reads("inside/deep/../../outside/secret.txt"));
    EXPECT_FALSE(writes("inside/../outside/new.txt"));
    EXPECT_FALSE(writes("new.txt"));
    EXPECT_FALSE(reads("inside-too/c.txt"));
    EXPECT_FALSE(writes("inside-too/c.txt"));
    EXPECT_FALSE(writes("inside/nowhere/../../outside/new.txt")) << "a missing folder could be made meanwhile";
}

// Catches links as ways out: to files, to folders, in chains, and to files that writing would create.
TEST_F(FileAccessTest, RefusesLinksOut) {
    fs::create_symlink(root() / "outside/secret.txt", root() / "inside/file");
    fs::create_symlink("../outside", root() / "inside/folder");
    fs::create_symlink("file", root() / "inside/chain");
    fs::create_symlink("../outside/not-yet.txt", root() / "inside/dangling");
    fs::create_symlink("loop", root() / "inside/loop");
    for (const char* name : {"inside/file", "inside/folder/secret.txt", "inside/chain"}) {
        EXPECT_FALSE(reads(name)) << name;
        EXPECT_FALSE(writes(name)) << name;
    }
    EXPECT_FALSE(writes("inside/dangling"));
    EXPECT_FALSE(writes("inside/folder/new.txt"));
    EXPECT_FALSE(writes("inside/loop"));
}

// Catches a policy that refuses links although they stay within, or an allowed folder that is a link itself.
TEST_F(FileAccessTest, AllowsLinksThatStayWithin) {
    fs::create_symlink("deep/b.txt", root() / "inside/link");
    EXPECT_TRUE(reads("inside/link"));
    EXPECT_TRUE(writes("inside/link"));
    fs::create_directory_symlink(root() / "inside", root() / "alias");
    FileAccess by_alias;
    by_alias.allow_writing(root() / "alias");
    EXPECT_FALSE(by_alias.why_unwritable(root() / "inside/new.txt"));
}

// Catches devices, pipes and folders taken for files, with and without confined reading.
TEST_F(FileAccessTest, RefusesAllButRegularFiles) {
    ASSERT_EQ(::mkfifo((root() / "inside/pipe").c_str(), 0600), 0);
    const FileAccess anywhere;
    EXPECT_FALSE(reads("inside/pipe"));
    EXPECT_FALSE(writes("inside/pipe"));
    EXPECT_FALSE(reads("inside/deep"));
    EXPECT_FALSE(writes("inside/deep"));
    EXPECT_TRUE(anywhere.why_unreadable("/dev/zero"));
    EXPECT_TRUE(anywhere.why_unreadable(root() / "inside/pipe"));
    EXPECT_FALSE(anywhere.why_unreadable(root() / "outside/secret.txt"));
    EXPECT_TRUE(anywhere.why_unwritable(root() / "inside/a.txt")) << "nothing is written unless it was allowed";
}

// Catches a scene in a home folder that appends to a shell's start-up file or a repository's hooks.
TEST_F(FileAccessTest, RefusesHiddenFilesBelowAnAllowedFolder) {
    fs::create_directories(root() / "inside/.git/hooks");
    EXPECT_FALSE(writes("inside/.bashrc"));
    EXPECT_FALSE(writes("inside/.git/hooks/post-commit"));
    access_.allow_writing(root() / "inside/.git");
    EXPECT_TRUE(writes("inside/.git/hooks/post-commit")) << "it was named";
}

}  // namespace
}  // namespace sundog
