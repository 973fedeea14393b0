// SPDX-License-Identifier: Apache-2.0
// Diffuse light between surfaces, computed once and kept at their vertices, for pictures in real time (radiosity:
// Goral, Torrance, Greenberg and Battaile, Modeling the Interaction of Light Between Diffuse Surfaces, SIGGRAPH 1984):
// gathered by paths (Kajiya 1986), for which mirrors, glass and all shapes count, or by form factors, without noise.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "bake/patches.h"
#include "base/progress.h"
#include "compile/compile.h"
#include "session/session.h"

namespace sundog::bake {

enum class Method : std::uint8_t {
    paths,
    radiosity,  ///< Direct light by rays to what shines, the rest by form factors, as if all surfaces were matt.
};

/// Their names on the command line, in the enumeration's order.
inline constexpr std::array<std::string_view, 2> kMethodNames{"paths", "radiosity"};

struct BakeOptions {
    Method method = Method::paths;
    float longest_edge = 0;  ///< Of patches; 0: a 64th of the scene's diagonal.
    /// For each vertex: paths; with radiosity, rays to what has a size and shines.
    std::uint32_t samples = 256;
    int max_depth = 16;
    float time_s = 0;
    std::uint32_t seed = 0;
    int threads = 0;  ///< Of what the session's device doesn't do itself; 0: all.
};

struct BakedScene {
    std::vector<Part> parts;
    std::size_t vertices = 0, triangles = 0;
    double seconds = 0;
    bool stopped = false;  ///< Early; each vertex has some light all the same.
};

/// The light of all vertices of a scene that `session`, on the CPU, has loaded as `compiled`. An object whose faces
/// are clearly darker in front than behind, all in all, was written the other way round: its normals are turned. The
/// same bits for any number of threads. Errors: InputError (parts_of); DeviceError; StoppedEarly where it was stopped
/// before each vertex had light.
///
/// By Method::radiosity, what isn't in the parts (planes, exact solids) casts shadows, but doesn't send light back; nor
/// do mirrors and glass (make_matt() has them as matt surfaces).
BakedScene bake(const scene::Scene& scene, const RenderScene& compiled, Session& session, const BakeOptions& options,
                const WarningSink& warn, const ProgressSink& progress, const StopFlag& stop);

class StoppedEarly : public std::runtime_error {
public:
    StoppedEarly() : std::runtime_error("stopped before each vertex had light") {}
};

}  // namespace sundog::bake
