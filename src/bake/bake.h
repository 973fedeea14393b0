// SPDX-License-Identifier: Apache-2.0
// Diffuse light between surfaces, computed once and kept at their vertices, for pictures in real time (radiosity:
// Goral, Torrance, Greenberg and Battaile, Modeling the Interaction of Light Between Diffuse Surfaces, SIGGRAPH 1984).
// What each vertex gets is gathered by paths (Kajiya 1986), so that there are no form factors to store and textures,
// mirrors and glass in the way count.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "bake/patches.h"
#include "base/progress.h"
#include "compile/compile.h"
#include "session/session.h"

namespace sundog::bake {

struct BakeOptions {
    float longest_edge = 0;  ///< Of patches; 0: a 64th of the scene's diagonal.
    std::uint32_t samples = 256;
    int max_depth = 16;
    float time_s = 0;
    std::uint32_t seed = 0;
};

struct BakedScene {
    std::vector<Part> parts;
    std::size_t vertices = 0, triangles = 0;
    double seconds = 0;
    bool stopped = false;  ///< Early; each vertex has some light all the same.
};

/// The light of all vertices of a scene that `session`, on the CPU, has loaded as `compiled`. An object whose faces
/// are darker in front than behind, all in all, was written the other way round: its normals are turned. The same bits
/// for any number of threads. Errors: InputError (parts_of); StoppedEarly where it was stopped before each vertex had
/// light.
BakedScene bake(const scene::Scene& scene, const RenderScene& compiled, Session& session, const BakeOptions& options,
                const WarningSink& warn, const ProgressSink& progress, const StopFlag& stop);

class StoppedEarly : public std::runtime_error {
public:
    StoppedEarly() : std::runtime_error("stopped before each vertex had light") {}
};

}  // namespace sundog::bake
