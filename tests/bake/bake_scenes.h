// SPDX-License-Identifier: Apache-2.0
// Small scenes, baked.
#pragma once

#include <filesystem>

#include "bake/bake.h"
#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "scenes/scene_builder.h"

namespace sundog::bake {

inline BakedScene baked(const scene::Scene& s, BakeOptions options, int threads = 2, const ProgressSink& progress = {},
                        const StopFlag& stop = {}) {
    options.threads = threads;
    const auto compiled = compile(s, {});
    Session session(make_cpu_device({.threads = threads}));
    session.load(compiled);
    return bake(s, *compiled, session, options, {}, progress, stop);
}

inline scene::Scene cornell_box() {
    return import::import_scene(std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes/cornell/cornell.scene", {});
}

}  // namespace sundog::bake
