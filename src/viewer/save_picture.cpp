// SPDX-License-Identifier: Apache-2.0
#include "viewer/save_picture.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/diagnostics.h"

namespace sundog::viewer {
namespace {

constexpr int kLastNumber = 9999;

// Creates the file exclusively, so that two windows that save at once get two names.
std::filesystem::path reserve_name(const std::filesystem::path& folder, const std::string& stem) {
    for (int number = 1; number <= kLastNumber; ++number) {
        std::filesystem::path file = folder / fmt::format("{}-{:04}.png", stem, number);
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> reserved(std::fopen(file.c_str(), "wx"), &std::fclose);
        if (reserved) return file;
        if (errno != EEXIST) throw OutputError(fmt::format("can't write {}: {}", file.string(), std::strerror(errno)));
    }
    throw OutputError(fmt::format("{} already holds {} pictures of '{}'", folder.string(), kLastNumber, stem));
}

}  // namespace

std::filesystem::path save_numbered_png(const std::filesystem::path& folder, const std::string& stem,
                                        const output::Image& image) {
    std::filesystem::path file = reserve_name(folder, stem);
    try {
        output::write_image(file, image);
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
        throw;
    }
    return file;
}

}  // namespace sundog::viewer
