// SPDX-License-Identifier: Apache-2.0
#include "scene/files.h"

#include <algorithm>

namespace sundog::scene {

void add_file(Scene& scene, const std::filesystem::path& file) {
    if (!has_file(scene, file)) scene.files.push_back(file.string());
}

bool has_file(const Scene& scene, const std::filesystem::path& file) {
    return std::find(scene.files.begin(), scene.files.end(), file.string()) != scene.files.end();
}

}  // namespace sundog::scene
