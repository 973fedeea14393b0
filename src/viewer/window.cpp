// SPDX-License-Identifier: Apache-2.0
#include "viewer/window.h"

#include <algorithm>
#include <string_view>

#include "base/diagnostics.h"

namespace sundog::viewer {
namespace {

[[noreturn]] void fail(const std::string& what) { throw DeviceError(what + ": " + SDL_GetError()); }

PixelSize cut_to_screen(PixelSize size) {
    SDL_Rect usable{};
    if (SDL_GetDisplayUsableBounds(0, &usable) != 0 || usable.w <= 0 || usable.h <= 0) return size;
    return {std::clamp(size.width, 1, usable.w), std::clamp(size.height, 1, usable.h)};
}

}  // namespace

SdlVideo::SdlVideo() {
    SDL_SetMainReady();
    // Ctrl-C on the terminal stays with the program that opened the window.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("no window can be opened");
    // Without a display SDL falls back to drivers whose window nobody sees and nobody can close.
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    const bool unseen = driver == "offscreen" || driver == "dummy" || driver == "evdev";
    if (unseen && !SDL_GetHint(SDL_HINT_VIDEODRIVER)) {
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        throw DeviceError("no window can be opened: there is no display (DISPLAY and WAYLAND_DISPLAY are not set)");
    }
}

SdlVideo::~SdlVideo() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }

Window::Window(const std::string& title, PixelSize size, bool fullscreen) {
    windowed_size_ = cut_to_screen(size);
    // Where no window manager runs, nobody enlarges a window that is to fill the screen: it is made as large from the
    // start.
    SDL_Rect place{SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, windowed_size_.width, windowed_size_.height};
    if (fullscreen) SDL_GetDisplayBounds(0, &place);
    const Uint32 flags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI |
                         (fullscreen ? static_cast<Uint32>(SDL_WINDOW_FULLSCREEN_DESKTOP) : 0U);
    window_.reset(SDL_CreateWindow(title.c_str(), place.x, place.y, place.w, place.h, flags));
    if (!window_) fail("no window can be opened");
    SDL_SetWindowMinimumSize(window_.get(), 160, 120);
    renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_PRESENTVSYNC));
    if (!renderer_) renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE));
    if (!renderer_) fail("the window can't be drawn to");
}

PixelSize Window::size_px() const {
    PixelSize size;
    SDL_GetRendererOutputSize(renderer_.get(), &size.width, &size.height);
    return {std::max(size.width, 1), std::max(size.height, 1)};
}

PixelSize Window::size() const {
    PixelSize size;
    SDL_GetWindowSize(window_.get(), &size.width, &size.height);
    return {std::max(size.width, 1), std::max(size.height, 1)};
}

double Window::refresh_hz() const {
    SDL_DisplayMode mode{};
    const int display = std::max(SDL_GetWindowDisplayIndex(window_.get()), 0);
    if (SDL_GetCurrentDisplayMode(display, &mode) != 0 || mode.refresh_rate <= 0) return 60;
    return mode.refresh_rate;
}

void Window::toggle_fullscreen() {
    const bool is_full = (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
    if (!is_full) windowed_size_ = size();
    SDL_SetWindowFullscreen(window_.get(), is_full ? 0 : static_cast<Uint32>(SDL_WINDOW_FULLSCREEN_DESKTOP));
    if (!is_full) return;
    SDL_SetWindowSize(window_.get(), windowed_size_.width, windowed_size_.height);
    SDL_SetWindowPosition(window_.get(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED);
}

void Window::set_picture(const Picture& picture) {
    if (picture.size != picture_size_ || !picture_) {
        // Without alpha, as windows mostly are: SDL's software renderer only smooths between like formats.
        picture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB888, SDL_TEXTUREACCESS_STREAMING,
                                         picture.size.width, picture.size.height));
        if (!picture_) fail("the picture can't be shown");
        SDL_SetTextureScaleMode(picture_.get(), SDL_ScaleModeLinear);
        SDL_SetTextureBlendMode(picture_.get(), SDL_BLENDMODE_NONE);
        picture_size_ = picture.size;
    }
    SDL_UpdateTexture(picture_.get(), nullptr, picture.argb.data(), 4 * picture.size.width);
}

void Window::draw_picture() {
    SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
    SDL_RenderClear(renderer_.get());
    if (picture_) SDL_RenderCopy(renderer_.get(), picture_.get(), nullptr, nullptr);
}

}  // namespace sundog::viewer
