// SPDX-License-Identifier: Apache-2.0
// Holds the table of docs/architecture.md: which folder may include which.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string_view>

#include "source_files.h"

namespace sundog::tests {
namespace {

/// Files below `folder` may include what lies below one of `allowed` (or is one of them). The most specific folder
/// that contains a file decides. "device/" alone, with a slash, stands for the files of that folder, not of those in
/// it.
struct Rule {
    std::string_view folder;
    std::vector<std::string_view> allowed;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> table{
        {"src/base", {"base"}},
        {"src/kernel", {"kernel", "sampling"}},
        {"src/sampling", {"sampling", "kernel"}},
        {"src/scene", {"scene", "base"}},
        {"src/fields", {"fields", "scene", "kernel", "base"}},
        {"src/output", {"output", "base"}},
        {"src/denoise", {"denoise", "base"}},
        {"src/import", {"import", "scene", "base", "output"}},
        {"src/import/gltf", {"import/gltf", "scene", "base", "output"}},
        {"src/import/obj", {"import/obj", "scene", "base", "output"}},
        {"src/import/pov", {"import/pov", "import/obj/obj_import.h", "scene", "base", "output", "fields", "solids"}},
        {"src/import/orbit", {"import/orbit", "import/obj/obj_import.h", "scene", "base", "output"}},
        {"src/solids", {"solids", "fields", "scene", "base"}},
        {"src/compile",
         {"compile", "scene", "fields", "solids", "kernel", "base", "device/render_scene.h", "device/camera_rays.h"}},
        {"src/device", {"device/", "kernel", "base"}},
        {"src/device/bvh", {"device/bvh", "device/", "kernel", "base"}},
        {"src/device/accel", {"device/accel", "device/bvh", "device/", "solids", "kernel", "base"}},
        {"src/device/cpu",
         {"device/cpu", "device/accel", "device/bvh", "device/", "solids", "sampling", "kernel", "base"}},
        {"src/device/vulkan", {"device/vulkan", "device/bvh", "device/", "solids", "kernel", "base"}},
        {"src/device/choose",
         {"device/choose", "device/cpu/cpu_device.h", "device/vulkan/vulkan_device.h", "device/", "base"}},
        {"src/bake",
         {"bake", "session", "compile", "device/", "device/cpu/triangle_occluders.h", "kernel", "scene", "output",
          "base"}},
        {"src/postprocess", {"postprocess", "base"}},
        {"src/session", {"session", "denoise", "postprocess", "device/", "sampling", "kernel", "base"}},
        {"apps/intro64k", {"apps/intro64k", "kernel", "sampling"}},
    };
    return table;
}

bool is_below(std::string_view path, std::string_view folder) {
    return path == folder || (path.starts_with(folder) && path.substr(folder.size()).starts_with("/"));
}

const Rule* rule_for(std::string_view path) {
    const Rule* best = nullptr;
    for (const Rule& rule : rules())
        if (is_below(path, rule.folder) && (!best || rule.folder.size() > best->folder.size())) best = &rule;
    return best;
}

bool is_allowed(const Rule& rule, std::string_view included) {
    for (const std::string_view allowed : rule.allowed) {
        if (!allowed.ends_with('/')) {
            if (is_below(included, allowed)) return true;
        } else if (included.starts_with(allowed) && included.find('/', allowed.size()) == std::string_view::npos) {
            return true;
        }
    }
    return false;
}

/// The path between quotes of an #include line.
std::optional<std::string> quoted_include(const std::string& line) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') return std::nullopt;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) return std::nullopt;
    const std::size_t open = line.find('"', word);
    const std::size_t close = open == std::string::npos ? open : line.find('"', open + 1);
    if (close == std::string::npos) return std::nullopt;
    return line.substr(open + 1, close - open - 1);
}

/// Relative to src: includes are written from src, from the demo's folder (in the demo), or from the including file's
/// own folder.
std::string from_src(const SourceFile& source, const std::string& included) {
    namespace fs = std::filesystem;
    const fs::path root = SUNDOG_SOURCE_DIR;
    if (fs::exists(root / "src" / included)) return included;
    constexpr std::string_view kDemo = "apps/intro64k";
    if (is_below(source.path, kDemo) && fs::exists(root / kDemo / included))
        return (fs::path(kDemo) / included).string();
    const fs::path beside = fs::path(source.path).parent_path() / included;
    return beside.lexically_normal().lexically_relative("src").generic_string();
}

// Catches a folder that comes to depend on one above it, so that the parts can no longer be used apart.
TEST(SourceRules, IncludesPointTheRightWay) {
    const auto sources = read_sources({"src", "apps/intro64k"}, {".h", ".cpp", ".comp", ".glsl"});
    ASSERT_GT(sources.size(), 40U) << "the search itself found too little";
    for (const SourceFile& source : sources) {
        const Rule* rule = rule_for(source.path);
        if (!rule) continue;
        for (std::size_t i = 0; i < source.lines.size(); ++i)
            if (const auto included = quoted_include(source.lines[i])) {
                EXPECT_TRUE(is_allowed(*rule, from_src(source, *included)))
                    << source.path << ":" << i + 1 << ": " << rule->folder << " must not include " << *included;
            }
    }
}

// Catches the base, or the freestanding folders, growing a dependency on a library.
TEST(SourceRules, BaseKernelAndSamplingNeedNoLibrary) {
    for (const SourceFile& source : read_sources({"src/base", "src/kernel", "src/sampling"}, {".h", ".cpp"})) {
        if (source.path.ends_with("_test.cpp")) continue;
        for (std::size_t i = 0; i < source.lines.size(); ++i) {
            const std::string& line = source.lines[i];
            if (!line.starts_with("#include <")) continue;
            const std::string name = line.substr(10, line.find('>') - 10);
            // The standard library's headers have neither folder nor ending; intrinsics are the compiler's own.
            const bool own = name.find_first_of("./") == std::string::npos || name.ends_with("intrin.h");
            EXPECT_TRUE(own) << source.path << ":" << i + 1 << ": " << name;
        }
    }
}

// Catches a checker that lets everything pass.
TEST(SourceRules, TheCheckRefusesWrongDirections) {
    const auto allowed = [](std::string_view file, std::string_view included) {
        return is_allowed(*rule_for(file), included);
    };
    EXPECT_FALSE(allowed("src/base/a.h", "scene/scene.h"));
    EXPECT_FALSE(allowed("src/device/cpu/a.cpp", "device/vulkan/vulkan_device.h"));
    EXPECT_FALSE(allowed("src/device/vulkan/a.cpp", "device/cpu/cpu_device.h"));
    EXPECT_FALSE(allowed("src/compile/a.cpp", "device/device.h"));
    EXPECT_FALSE(allowed("src/session/a.cpp", "device/cpu/cpu_device.h"));
    EXPECT_FALSE(allowed("src/import/obj/a.cpp", "import/orbit/orbit_import.h"));
    EXPECT_FALSE(allowed("src/denoise/a.cpp", "device/film.h"));
    EXPECT_FALSE(allowed("src/kernel/a.h", "kernels/b.h"));
    EXPECT_FALSE(allowed("apps/intro64k/show/a.cpp", "base/vec.h"));
    EXPECT_TRUE(allowed("src/session/a.cpp", "device/device.h"));
    EXPECT_EQ(quoted_include("  #  include \"a/b.h\"  // why"), "a/b.h");
    EXPECT_FALSE(quoted_include("// #include \"a/b.h\""));
}

}  // namespace
}  // namespace sundog::tests
