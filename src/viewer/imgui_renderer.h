// SPDX-License-Identifier: Apache-2.0
// Draws Dear ImGui through SDL's renderer, for any ImGui from 1.86 on.
#pragma once

#include <SDL.h>

#include <memory>

namespace sundog::viewer {

struct SdlTextureDeleter {
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};
using SdlTexture = std::unique_ptr<SDL_Texture, SdlTextureDeleter>;

/// Owns the ImGui context of one window, its font texture and its input.
class ImguiRenderer {
public:
    /// font_px: height of the text in window coordinates. Font 0 is for text, font 1 monospaced. Errors: DeviceError.
    ImguiRenderer(SDL_Window* window, SDL_Renderer* renderer, float font_px);
    ~ImguiRenderer();
    ImguiRenderer(const ImguiRenderer&) = delete;
    ImguiRenderer& operator=(const ImguiRenderer&) = delete;

    /// Shows ImGui an event first; it then says whether it wants the mouse or the keyboard (ImGui::GetIO()).
    static void process_event(const SDL_Event& event);
    /// Before any ImGui call of a picture.
    void begin();
    /// After the last one: draws over what the renderer's target holds.
    void end();

private:
    void make_font_texture();

    SDL_Renderer* renderer_;
    SdlTexture font_;
};

}  // namespace sundog::viewer
