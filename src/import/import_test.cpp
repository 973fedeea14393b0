// SPDX-License-Identifier: Apache-2.0
#include "import/import.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "scene/bounds.h"

namespace sundog {
namespace {

std::filesystem::path gallery(const char* scene) { return std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / scene; }

scene::Scene import_quietly(const std::filesystem::path& file) {
    return import::import_scene(file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); });
}

// Catches a gallery scene that no longer reads, or only with warnings, and settings of raytracer.conf that get lost.
TEST(Import, ReadsTheGallery) {
    for (const char* name : {"cornell", "glass", "mirrors", "table", "textured"}) {
        const scene::Scene scene = import_quietly(gallery(name) / (std::string(name) + ".scene"));
        EXPECT_FALSE(scene.objects.empty()) << name;
        EXPECT_FALSE(scene.lights.empty()) << name;
        EXPECT_TRUE(scene.settings.width.has_value()) << name;
        EXPECT_FALSE(scene::bounds_of(scene).empty()) << name;
    }
}

}  // namespace
}  // namespace sundog
