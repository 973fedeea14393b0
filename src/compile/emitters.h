// SPDX-License-Identifier: Apache-2.0
// What paths aim at for its light.
#pragma once

#include <span>

#include "device/render_scene.h"
#include "scene/scene.h"

namespace sundog {

/// Lists in `out` the triangles and spheres whose material shines; for once all geometries are there.
void find_shining(RenderScene& out);

/// Mean luminance of what a surface emits in the colour `emission`, times the texture of that number where it has one.
float emission_power(Vec3 emission, scene::Index texture, std::span<const scene::Texture> textures);

/// Fills in the environment's picture and the table by which its directions are drawn.
void compile_environment(const scene::Environment& environment, RenderScene& out);

/// Makes the frame's list of emitters: shining surfaces, lights, the environment. Lights and instances are there.
void list_emitters(const RenderScene& compiled, Frame& frame);

/// Makes these the frame's emitters, each drawn by its share of all `power`, which is parallel to them; the sum of that
/// is the answer. FrameParams::emitted_power is the caller's to set.
double set_emitters(std::vector<kernel::Emitter> emitters, std::span<const double> power, Frame& frame);

}  // namespace sundog
