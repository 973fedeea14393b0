// SPDX-License-Identifier: Apache-2.0
// Light that comes to vertices straight from what shines.
#pragma once

#include "bake/bake.h"
#include "bake/vertex_rays.h"

namespace sundog::bake {

/// Of each pixel of VertexPixels, in the scene's own numbers (before FrameParams::working_gamma).
struct DirectLight {
    std::vector<Vec3> own;        ///< Radiance that it shines with.
    std::vector<Vec3> reflected;  ///< Radiance that it makes of light from lights, shining surfaces and the sky.
    std::vector<Vec3> albedo;     ///< Of its diffuse reflection.
    bool stopped = false;         ///< Early: with more noise.
};

/// Rendered on the session's device by paths that end where they begin. `frame` is a picture of the vertices by paths,
/// seen by VertexRays. Lights without size are added up one by one, without noise. Surfaces that shine, areas and
/// environments, which paths aim at, are sampled options.samples times, the same for all other skies (ViewRays).
/// Surfaces that shine but aren't among the frame's emitters are `own` light alone. Errors: StoppedEarly where vertices
/// had no light yet.
DirectLight direct_light(const RenderScene& compiled, Session& session, const Frame& frame, const VertexPixels& pixels,
                         float distance, const BakeOptions& options, const ProgressSink& progress,
                         const StopFlag& stop);

}  // namespace sundog::bake
