// SPDX-License-Identifier: Apache-2.0
// The SDL window, and the picture in it.
#pragma once

#include <SDL.h>

#include <cstdint>
#include <memory>
#include <string>

#include "viewer/imgui_renderer.h"
#include "viewer/picture_maker.h"

namespace sundog::viewer {

/// Starts SDL's video while it lives. Errors: DeviceError where there is no display.
class SdlVideo {
public:
    SdlVideo();
    ~SdlVideo();
    SdlVideo(const SdlVideo&) = delete;
    SdlVideo& operator=(const SdlVideo&) = delete;
};

/// A window that shows one picture, scaled to fill it.
class Window {
public:
    /// size: of its inside, in window coordinates, cut to the screen. Errors: DeviceError.
    Window(const std::string& title, PixelSize size, bool fullscreen);

    /// The inside, in pixels of the screen.
    [[nodiscard]] PixelSize size_px() const;
    /// The inside, in window coordinates (those of the mouse).
    [[nodiscard]] PixelSize size() const;
    [[nodiscard]] double refresh_hz() const;
    void set_title(const std::string& title) { SDL_SetWindowTitle(window_.get(), title.c_str()); }
    void toggle_fullscreen();

    /// Replaces the picture. Errors: DeviceError (out of texture memory).
    void set_picture(const Picture& picture);
    /// Draws the picture over the whole window (black before there is one).
    void draw_picture();
    /// Puts what was drawn on the screen.
    void present() { SDL_RenderPresent(renderer_.get()); }

    [[nodiscard]] SDL_Window* sdl_window() const { return window_.get(); }
    [[nodiscard]] SDL_Renderer* sdl_renderer() const { return renderer_.get(); }

private:
    struct WindowDeleter {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    };
    struct RendererDeleter {
        void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    };
    SdlVideo video_;
    std::unique_ptr<SDL_Window, WindowDeleter> window_;
    std::unique_ptr<SDL_Renderer, RendererDeleter> renderer_;
    SdlTexture picture_;
    PixelSize picture_size_;
    PixelSize windowed_size_;  ///< What it has when it does not fill the screen.
};

}  // namespace sundog::viewer
