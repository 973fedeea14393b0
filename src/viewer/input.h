// SPDX-License-Identifier: Apache-2.0
// What the user does, apart from how SDL says it.
#pragma once

#include <SDL.h>

#include <optional>

#include "base/vec.h"
#include "viewer/camera_control.h"

namespace sundog::viewer {

/// Everything since the last reading. Positions are in window coordinates.
struct Input {
    bool any = false;  ///< Something came that may change what the panels show.
    bool quit = false;
    bool toggle_play = false, toggle_help = false, toggle_panels = false, toggle_fullscreen = false;
    bool toggle_rays = false, toggle_light = false;
    bool go_home = false;
    bool save = false;
    int steps_in_time = 0;  ///< Frames forward, negative: back.
    std::optional<Vec2> pick_at;
    MouseMove orbit, pan, look;
    float zoom = 0;
    FlyDirection fly;  ///< Of the keys that are down.
    float fly_speed = 1;
};

/// Turns SDL's events into Input. What ImGui wants for itself (mouse over a
/// panel, typing) doesn't count.
class InputReader {
public:
    /// Waits up to wait_ms for an event, then reads all there are. Calls ImGui; a
    /// context must be current.
    [[nodiscard]] Input read(int wait_ms);

private:
    void take(const SDL_Event& event, Input& input);
    void note_modifier(const SDL_KeyboardEvent& event);
    void press_button(const SDL_MouseButtonEvent& event, Input& input);
    void press_key(const SDL_KeyboardEvent& event, Input& input) const;

    enum class Drag { none, orbit, pan, look } drag_ = Drag::none;
    int drag_button_ = 0;
    // As of the event at hand: SDL_GetModState() already knows of those that wait
    // behind it.
    bool ctrl_ = false, shift_ = false;
    bool saving_key_down_ = false;  ///< S, since it was pressed together with Ctrl.
    Vec2 mouse_;
};

}  // namespace sundog::viewer
