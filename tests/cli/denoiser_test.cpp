// SPDX-License-Identifier: Apache-2.0
// Which denoiser is taken and what is said of it, with libraries that are there and such that are none.
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "program.h"

namespace sundog::tests {
namespace {

/// While one stands, programs look for shared libraries in a folder first.
class LibraryPath {
public:
    explicit LibraryPath(const std::filesystem::path& folder) {
        if (const char* before = std::getenv(kName)) before_ = before;
        setenv(kName, folder.c_str(), 1);
    }
    ~LibraryPath() {
        if (before_) setenv(kName, before_->c_str(), 1);
        else unsetenv(kName);
    }
    LibraryPath(const LibraryPath&) = delete;
    LibraryPath& operator=(const LibraryPath&) = delete;

private:
    static constexpr const char* kName = "LD_LIBRARY_PATH";
    std::optional<std::string> before_;
};

Outcome render(const std::filesystem::path& file, std::vector<std::string> further) {
    further.insert(further.begin(),
                   {"render", table_scene(), "-o", file.string(), "--size", "16x12", "--device", "cpu", "--spp", "4"});
    return run(further);
}

// Catches a library that isn't found under the name by which its makers install it, one that is used where the filter
// was asked for, and a report that doesn't say which of them it was.
TEST(Denoiser, TakesTheLibraryWhereItIsInstalled) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink(FAKE_OIDN_2, folder / "libOpenImageDenoise.so.2");
    const LibraryPath path(folder.path());
    for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
             {"--denoise"}, {"--denoiser", "oidn"}, {"--denoiser", "oidn", "--denoise"}, {"--denoiser", "auto"}}) {
        const Outcome outcome = render(folder / "oidn.hdr", options);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("denoised by Open Image Denoise 2.3.1 in "), std::string::npos) << outcome.err;
    }
    const Outcome outcome = render(folder / "filter.hdr", {"--denoise", "--denoiser", "filter"});
    EXPECT_NE(outcome.err.find("denoised by Sundog's filter in "), std::string::npos) << outcome.err;
    EXPECT_TRUE(read_bytes(folder / "oidn.hdr") != read_bytes(folder / "filter.hdr"));
    const Outcome frames = render(folder / "turn.ppm", {"--denoise", "--frames", "0..1"});
    EXPECT_NE(frames.err.find("denoised by Open Image Denoise 2.3.1, "), std::string::npos) << frames.err;
}

// Catches a picture without the library that was asked for, an error that doesn't say what was looked for, and no
// picture where the filter would have done.
TEST(Denoiser, SaysWhatItLookedFor) {
    const TemporaryFolder folder;
    const std::vector<std::string> names{"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1",
                                         "libOpenImageDenoise.so.0", "libOpenImageDenoise.so"};
    // So that none is found where it is installed, either.
    for (const std::string& name : names) write_bytes(folder / name, "no library");
    const LibraryPath path(folder.path());
    const Outcome outcome = render(folder / "a.ppm", {"--denoiser", "oidn"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("sundog: error: Open Image Denoise can't be loaded: ")) << outcome.err;
    for (const std::string& name : names) EXPECT_NE(outcome.err.find(name + ": "), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.ppm"));
    const Outcome plain = render(folder / "a.ppm", {"--denoise"});
    EXPECT_EQ(plain.status, 0) << plain.err;
    EXPECT_NE(plain.err.find("denoised by Sundog's filter in "), std::string::npos) << plain.err;
}

}  // namespace
}  // namespace sundog::tests
