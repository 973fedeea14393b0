// SPDX-License-Identifier: Apache-2.0
// What the user learns about a pixel.
#pragma once

#include <string>

#include "session/session.h"
#include "viewer/loaded_scene.h"

namespace sundog::viewer {

/// A pixel in words. Places are "file:line", or empty where not known.
struct PickedPixel {
    int x = 0, y = 0;
    PixelInfo info;
    bool hit = false;  ///< False: the sky; nothing below is set then.
    std::string object, object_place;
    std::string material, material_place;
    std::string replay;  ///< The command line that computes this pixel again.
};

/// Finds names and places of what `info` saw in the scene.
PickedPixel describe_pixel(const LoadedScene& scene, const PixelInfo& info, int x, int y);

}  // namespace sundog::viewer
