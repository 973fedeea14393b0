// SPDX-License-Identifier: Apache-2.0
// Cameras that the host makes the rays of: lenses, meshes, functions.
#pragma once

#include <memory>
#include <span>

#include "device/camera_rays.h"
#include "scene/scene.h"

namespace sundog {

/// The rays of a camera with focal blur. Its projection comes with the frame.
std::shared_ptr<const CameraRays> make_lens_camera(const scene::ProjectionCamera& camera,
                                                   std::span<const scene::Texture> textures);
/// Rays that start on triangles. `camera.mesh` is set.
std::shared_ptr<const CameraRays> make_mesh_camera(const scene::ProjectionCamera& camera);
/// Rays of functions. `camera.function` is set.
std::shared_ptr<const CameraRays> make_function_camera(const scene::ProjectionCamera& camera,
                                                       std::span<const scene::Texture> textures);

}  // namespace sundog
