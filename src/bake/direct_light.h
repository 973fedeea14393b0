// SPDX-License-Identifier: Apache-2.0
// Light that comes to vertices straight from what shines.
#pragma once

#include <set>

#include "bake/bake.h"
#include "bake/vertex_rays.h"

namespace sundog::bake {

/// Of each pixel of VertexPixels, in the scene's own numbers (before FrameParams::working_gamma).
struct DirectLight {
    std::vector<Vec3> own;        ///< Radiance that it shines with.
    std::vector<Vec3> reflected;  ///< Radiance that it makes of what comes straight from elsewhere.
    std::vector<Vec3> albedo;     ///< Of its diffuse reflection.
    bool stopped = false;         ///< Early: with more noise.
};

/// How light comes to vertices from surfaces that shine: by form factors from those in the parts, or aimed at by paths.
struct ShiningSurfaces {
    /// Objects' materials that paths aim at. All others of the parts send their light by form factors.
    std::set<std::pair<std::size_t, scene::Index>> aimed_at;
    /// Which of the frame's emitters paths aim at, beside lights and the environment.
    std::vector<bool> emitters;
};

/// By form factors wherever all that may stop light is in the parts, and stops it whole.
ShiningSurfaces shining_surfaces(const RenderScene& compiled, const Frame& frame, const std::vector<Part>& parts);

/// Light from lights, the sky, and those shining surfaces that are aimed at, rendered on the session's device by paths
/// that end where they begin. `frame` is a picture of the vertices by paths, seen by VertexRays. Lights without size
/// are added up one by one, without noise. Surfaces, areas and environments, which are aimed at, are sampled
/// options.samples times; so is the sky, in directions that are the same for all (ViewRays). Errors: StoppedEarly where
/// vertices had no light yet.
DirectLight direct_light(const RenderScene& compiled, Session& session, const Frame& frame,
                         const ShiningSurfaces& shining, const VertexPixels& pixels, float distance,
                         const BakeOptions& options, const ProgressSink& progress, const StopFlag& stop);

}  // namespace sundog::bake
