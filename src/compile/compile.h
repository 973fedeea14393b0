// SPDX-License-Identifier: Apache-2.0
// From the scene as written to what devices render.
#pragma once

#include <memory>
#include <optional>

#include "base/diagnostics.h"
#include "device/render_scene.h"
#include "scene/scene.h"

namespace sundog {

/// Flattens a scene into the kernel's arrays. Zero-area triangles are dropped with one warning an object; a scene
/// without any primitive is fine (all sky). Vertex normals of zero length fall back to the face's. Unless it is
/// `for_paths`, what makes path tracing alone faster (grids of media, which may take a second) is left out.
std::shared_ptr<const RenderScene> compile(const scene::Scene& scene, const WarningSink& warn, bool for_paths = true);

/// What the caller chooses of a picture; what is not set comes from the scene's Settings, then from the defaults
/// that the manual names (640x480, depth 5, for paths 16, min_weight 0.01, shadows on, no far clip).
struct FrameOptions {
    std::optional<int> width, height;
    float time_s = 0;  ///< Overruled by Settings::freeze_s.
    std::optional<int> max_depth;
    std::optional<float> min_weight;
    std::optional<bool> shadows;
    std::optional<float> far_z;
    std::optional<kernel::Camera> camera;  ///< Instead of the scene's own.
    std::uint32_t aovs = 0;                ///< AOV_* bits
    kernel::PixelSampling sampling{};      ///< Else the middle first, then all over the pixel's square.
    std::uint32_t integrator = kernel::INTEGRATOR_WHITTED;
    std::uint32_t seed = 0;         ///< Of paths: another one gives other noise.
    float most_radiance = 0;        ///< A path brings no more than this; 0: as much as there is.
    float occlusion_distance = 0;   ///< Of ambient occlusion; 0: half the size of the scene's bounds.
    float lens_radius = 0;          ///< Of a thin lens, in the scene's units; 0: a pinhole.
    float focus_distance = 0;       ///< To what is sharp, along the view axis.
    std::uint32_t lens_blades = 0;  ///< Sides of its aperture; under 3: it is round.
    bool radiosity = true;          ///< False: scenes that have it are drawn with ambient light instead.
    bool subsurface = true;         ///< False: light that enters a surface comes out where it entered.
};

/// The frame of a compiled scene at a moment: camera, lights, moving objects, limits.
Frame make_frame(const scene::Scene& scene, const RenderScene& compiled, const FrameOptions& options);

/// The scene's camera at time_s for a window of the given aspect (width / height).
kernel::Camera camera_at(const scene::OrbitCamera& camera, float time_s, float aspect);
/// A camera placed by vectors, as a pinhole: a perspective camera's width follows the window's aspect, others keep
/// their vectors.
kernel::Camera camera_at(const scene::ProjectionCamera& camera, float aspect);

}  // namespace sundog
