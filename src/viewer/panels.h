// SPDX-License-Identifier: Apache-2.0
// The controls over the picture: what they show, and what the user can set with them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "viewer/display.h"
#include "viewer/picked.h"
#include "viewer/picture_maker.h"
#include "viewer/playback.h"

namespace sundog::viewer {

/// A line of the device menu.
struct DeviceChoice {
    std::string choice;  ///< As open_device() takes it.
    std::string label;
    std::string why_unusable;  ///< Empty if it can be chosen.
};

/// What the user sets.
struct Controls {
    std::string device;            ///< "cpu" or "gpu"
    std::optional<int> max_depth;  ///< Where not set, the scene's.
    std::optional<bool> shadows;
    Exposure exposure;
    std::uint32_t integrator = kernel::INTEGRATOR_WHITTED;
    float lens_radius = 0;     ///< 0: a pinhole.
    float focus_distance = 0;  ///< To what is sharp; 0: not set yet.
    bool denoise = false;
    bool show_rays = false;  ///< Where the picture is interpolated, what is traced is white.
    bool show_panels = true;
    bool show_help = false;
    bool copied = false;  ///< Set when the user copied the command line; the caller says so and clears it.
};

/// What there is to know.
struct Status {
    std::string scene_name;
    std::string device_name;
    std::vector<DeviceChoice> devices;
    int scene_max_depth = 0;
    bool scene_shadows = true;
    PixelSize size;  ///< Of the picture shown.
    PixelSize full_size;
    std::uint32_t samples = 0;
    double pictures_per_s = 0;  ///< 0: at rest.
    double rays_per_s = 0;
    float scene_size = 1;    ///< Of its bounds, from corner to corner.
    bool own_camera = true;  ///< The scene's, not the user's.
    bool loading = false;
    bool animated = false;
    std::string error;  ///< Why the scene on disk or the device can't be used; empty if all is well.
    std::vector<std::string> warnings;
    std::optional<PickedPixel> picked;
    std::string note;  ///< Shown for a moment, such as "saved table-0001.png"; empty for none.
};

/// Colours, roundings and paddings, for text of the given height.
void set_style(float font_px);

/// Draws all of it with ImGui. Changes `controls`, `playback` and `picked` (which the user may close).
void draw_panels(Status& status, Controls& controls, Playback& playback);

/// "12.3 M", "845 k", "12": short, for counts.
std::string short_count(double count);

}  // namespace sundog::viewer
