// SPDX-License-Identifier: Apache-2.0
#include "viewer/input.h"

#include <imgui.h>

#include "viewer/imgui_renderer.h"

namespace sundog::viewer {
namespace {

void add(MouseMove& sum, const SDL_MouseMotionEvent& motion) {
    sum.dx_px += static_cast<float>(motion.xrel);
    sum.dy_px += static_cast<float>(motion.yrel);
}

/// `s_is_taken`: the key S was pressed for something else and is still down.
void read_flying(Input& input, bool s_is_taken) {
    const auto modifiers = SDL_GetModState();
    if (ImGui::GetIO().WantTextInput || (modifiers & (KMOD_CTRL | KMOD_ALT | KMOD_GUI))) return;
    const Uint8* down = SDL_GetKeyboardState(nullptr);
    const auto axis = [&](SDL_Scancode plus, SDL_Scancode minus) {
        return static_cast<float>(down[plus]) - static_cast<float>(down[minus]);
    };
    const float forward = s_is_taken ? static_cast<float>(down[SDL_SCANCODE_W]) : axis(SDL_SCANCODE_W, SDL_SCANCODE_S);
    input.fly = {axis(SDL_SCANCODE_D, SDL_SCANCODE_A), forward, axis(SDL_SCANCODE_E, SDL_SCANCODE_Q)};
    input.fly_speed = modifiers & KMOD_SHIFT ? 4.0F : 1.0F;
}

}  // namespace

Input InputReader::read(int wait_ms) {
    Input input;
    SDL_Event event;
    if (SDL_WaitEventTimeout(&event, wait_ms)) {
        do take(event, input);
        while (SDL_PollEvent(&event));
    }
    read_flying(input, saving_key_down_);
    return input;
}

void InputReader::take(const SDL_Event& event, Input& input) {
    if (event.type >= SDL_USEREVENT) return;  // the render thread's wake-up call
    ImguiRenderer::process_event(event);
    input.any = true;
    switch (event.type) {
        case SDL_QUIT:
            input.quit = true;
            break;
        case SDL_KEYDOWN:
            note_modifier(event.key);
            // Ctrl may be let go before S: that must not fly.
            if (event.key.keysym.scancode == SDL_SCANCODE_S && event.key.repeat == 0)
                saving_key_down_ = (event.key.keysym.mod & KMOD_CTRL) != 0;
            press_key(event.key, input);
            break;
        case SDL_KEYUP:
            note_modifier(event.key);
            if (event.key.keysym.scancode == SDL_SCANCODE_S) saving_key_down_ = false;
            break;
        case SDL_WINDOWEVENT:
            if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) ctrl_ = shift_ = saving_key_down_ = false;
            break;
        case SDL_MOUSEBUTTONDOWN:
            press_button(event.button, input);
            break;
        case SDL_MOUSEBUTTONUP:
            if (event.button.button == drag_button_) drag_ = Drag::none;
            break;
        case SDL_MOUSEMOTION:
            mouse_ = {static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
            if (drag_ == Drag::orbit) add(input.orbit, event.motion);
            if (drag_ == Drag::pan) add(input.pan, event.motion);
            if (drag_ == Drag::look) add(input.look, event.motion);
            break;
        case SDL_MOUSEWHEEL:
            if (!ImGui::GetIO().WantCaptureMouse) input.zoom += event.wheel.preciseY;
            break;
        default:
            break;
    }
}

void InputReader::note_modifier(const SDL_KeyboardEvent& event) {
    const bool down = event.type == SDL_KEYDOWN;
    if (event.keysym.sym == SDLK_LCTRL || event.keysym.sym == SDLK_RCTRL) ctrl_ = down;
    if (event.keysym.sym == SDLK_LSHIFT || event.keysym.sym == SDLK_RSHIFT) shift_ = down;
}

void InputReader::press_button(const SDL_MouseButtonEvent& event, Input& input) {
    if (ImGui::GetIO().WantCaptureMouse || drag_ != Drag::none) return;
    if (event.button == SDL_BUTTON_LEFT && ctrl_) {
        input.pick_at = Vec2{static_cast<float>(event.x), static_cast<float>(event.y)};
        return;
    }
    if (event.button == SDL_BUTTON_LEFT) drag_ = shift_ ? Drag::pan : Drag::orbit;
    if (event.button == SDL_BUTTON_MIDDLE) drag_ = Drag::pan;
    if (event.button == SDL_BUTTON_RIGHT) drag_ = Drag::look;
    drag_button_ = event.button;
}

void InputReader::press_key(const SDL_KeyboardEvent& event, Input& input) const {
    if (ImGui::GetIO().WantTextInput) return;
    const bool first = event.repeat == 0;
    const bool ctrl = (event.keysym.mod & KMOD_CTRL) != 0;
    switch (event.keysym.sym) {
        case SDLK_ESCAPE:
            input.quit = true;
            break;
        case SDLK_SPACE:
            input.toggle_play ^= first;
            break;
        case SDLK_F1:
            input.toggle_help ^= first;
            break;
        case SDLK_F11:
            input.toggle_fullscreen ^= first;
            break;
        case SDLK_TAB:
            input.toggle_panels ^= first;
            break;
        case SDLK_HOME:
            input.go_home = true;
            break;
        case SDLK_LEFT:
            --input.steps_in_time;
            break;
        case SDLK_RIGHT:
            ++input.steps_in_time;
            break;
        case SDLK_l:
            input.toggle_light ^= first && !ctrl;
            break;
        case SDLK_p:
            if (first) input.pick_at = mouse_;
            break;
        case SDLK_r:
            input.toggle_rays ^= first && !ctrl;
            break;
        case SDLK_s:
            if (ctrl && first) input.save = true;
            break;
        default:
            break;
    }
}

}  // namespace sundog::viewer
