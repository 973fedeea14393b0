// SPDX-License-Identifier: Apache-2.0
#include "show/player.h"

#include <cstdio>

#include "film/film.h"
#include "show/sound.h"

namespace sundog::intro {
namespace {

/// SDL, from start to quit.
class Screen {
public:
    explicit Screen(const Options& options) {
        if (SDL_Init(SDL_INIT_VIDEO) != 0) return;
        const bool full = options.width == 0;
        window_ = SDL_CreateWindow("sundog", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   static_cast<int>(full ? 1280 : options.width),
                                   static_cast<int>(full ? 720 : options.height),
                                   full ? static_cast<Uint32>(SDL_WINDOW_FULLSCREEN_DESKTOP) : 0);
        if (window_ == nullptr) return;
        SDL_ShowCursor(SDL_DISABLE);
        SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "1");
        renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_PRESENTVSYNC);
        if (renderer_ == nullptr) return;
        int width = 0;
        int height = 0;
        SDL_GetRendererOutputSize(renderer_, &width, &height);
        // Full screens have their own shape and our height; the graphics card enlarges it.
        picture_.height = full ? 720U : static_cast<uint>(height);
        picture_.width = full ? 720U * static_cast<uint>(width) / static_cast<uint>(height) : static_cast<uint>(width);
        texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGB888, SDL_TEXTUREACCESS_STREAMING,
                                     static_cast<int>(picture_.width), static_cast<int>(picture_.height));
    }
    ~Screen() { SDL_Quit(); }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    [[nodiscard]] bool good() const { return texture_ != nullptr; }

    /// The picture to draw next, hidden until show().
    Picture hidden() {
        void* pixels = nullptr;
        int pitch = 0;
        if (SDL_LockTexture(texture_, nullptr, &pixels, &pitch) != 0) return {};
        picture_.pixels = static_cast<uint*>(pixels);
        picture_.pitch = static_cast<uint>(pitch) / 4;
        return picture_;
    }
    void show() {
        SDL_UnlockTexture(texture_);
        SDL_RenderCopy(renderer_, texture_, nullptr, nullptr);
        SDL_RenderPresent(renderer_);
    }

private:
    SDL_Window* window_ = nullptr;
    SDL_Renderer* renderer_ = nullptr;
    SDL_Texture* texture_ = nullptr;
    Picture picture_{};
};

bool wants_to_leave() {
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0)
        if (event.type == SDL_QUIT || (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE)) return true;
    return false;
}

}  // namespace

int play(Renderer& renderer, const Quality& quality, const Options& options) {
    Screen screen(options);
    if (!screen.good()) {
        std::fprintf(stderr, "sundog-intro: no window: %s\n", SDL_GetError());
        return 1;
    }
    const Sound sound(options.sound);
    const double per_second = static_cast<double>(SDL_GetPerformanceFrequency());
    const Uint64 start = SDL_GetPerformanceCounter();
    while (!wants_to_leave()) {
        const double seconds = static_cast<double>(SDL_GetPerformanceCounter() - start) / per_second;
        if (seconds >= static_cast<double>(kFilmSeconds)) break;
        const Picture picture = screen.hidden();
        if (picture.pixels == nullptr) return 1;
        renderer.draw(static_cast<float>(seconds), quality, picture);
        screen.show();
    }
    return 0;
}

}  // namespace sundog::intro
