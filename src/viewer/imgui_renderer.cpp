// SPDX-License-Identifier: Apache-2.0
#include "viewer/imgui_renderer.h"

#include <imgui.h>
#if __has_include(<imgui_impl_sdl2.h>)
#include <imgui_impl_sdl2.h>
#elif __has_include(<backends/imgui_impl_sdl2.h>)
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>

#include "base/diagnostics.h"

namespace sundog::viewer {
namespace {

// The platform part took the renderer as a second argument from 1.87 on; the overload that fits is chosen.
[[maybe_unused]] bool init_platform(bool (*init)(SDL_Window*), SDL_Window* window, SDL_Renderer*) {
    return init(window);
}
[[maybe_unused]] bool init_platform(bool (*init)(SDL_Window*, SDL_Renderer*), SDL_Window* window,
                                    SDL_Renderer* renderer) {
    return init(window, renderer);
}

// The first of the files that there is, else ImGui's own (small, monospaced).
void add_font(std::span<const char* const> files, float font_px) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    for (const char* file : files) {
        std::error_code unreadable;
        if (std::filesystem::is_regular_file(file, unreadable) && fonts.AddFontFromFileTTF(file, font_px)) return;
    }
    ImFontConfig built_in;
    built_in.SizePixels = font_px;
    fonts.AddFontDefault(&built_in);
}

void add_fonts(float font_px) {
    constexpr std::array kText = {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                  "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};
    constexpr std::array kMonospaced = {"/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
                                        "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                                        "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf"};
    add_font(kText, font_px);
    add_font(kMonospaced, std::round(font_px * 0.9F));
}

SDL_Rect clip_rect(const ImDrawCmd& command, const ImVec2& origin) {
    const int x0 = std::max(static_cast<int>(command.ClipRect.x - origin.x), 0);
    const int y0 = std::max(static_cast<int>(command.ClipRect.y - origin.y), 0);
    const int x1 = static_cast<int>(std::ceil(command.ClipRect.z - origin.x));
    const int y1 = static_cast<int>(std::ceil(command.ClipRect.w - origin.y));
    return {x0, y0, x1 - x0, y1 - y0};
}

}  // namespace

ImguiRenderer::ImguiRenderer(SDL_Window* window, SDL_Renderer* renderer, float font_px) : renderer_(renderer) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // a viewer leaves no files behind
    io.BackendRendererName = "sundog_sdl_renderer";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    add_fonts(font_px);
    if (!init_platform(&ImGui_ImplSDL2_InitForSDLRenderer, window, renderer)) {
        ImGui::DestroyContext();
        throw DeviceError("the window's controls could not be set up");
    }
    make_font_texture();
}

ImguiRenderer::~ImguiRenderer() {
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

void ImguiRenderer::process_event(const SDL_Event& event) { ImGui_ImplSDL2_ProcessEvent(&event); }

void ImguiRenderer::begin() {
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
}

void ImguiRenderer::end() {
    ImGui::Render();
    const ImDrawData& drawing = *ImGui::GetDrawData();
    // ImGui draws in window coordinates, which may be coarser than the screen's pixels.
    SDL_RenderSetScale(renderer_, drawing.FramebufferScale.x, drawing.FramebufferScale.y);
    for (int l = 0; l < drawing.CmdListsCount; ++l) {
        const ImDrawList& list = *drawing.CmdLists[l];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback || command.ElemCount == 0) continue;
            const SDL_Rect clip = clip_rect(command, drawing.DisplayPos);
            if (clip.w <= 0 || clip.h <= 0) continue;
            SDL_RenderSetClipRect(renderer_, &clip);

            // All of our drawing uses the font's texture: text from its glyphs, the rest from its white pixel.
            const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
            const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset;
            static_assert(sizeof(ImU32) == sizeof(SDL_Color));
            SDL_RenderGeometryRaw(renderer_, font_.get(), &vertices->pos.x, sizeof(ImDrawVert),
                                  reinterpret_cast<const SDL_Color*>(&vertices->col), sizeof(ImDrawVert),
                                  &vertices->uv.x, sizeof(ImDrawVert),
                                  list.VtxBuffer.Size - static_cast<int>(command.VtxOffset), indices,
                                  static_cast<int>(command.ElemCount), sizeof(ImDrawIdx));
        }
    }
    SDL_RenderSetClipRect(renderer_, nullptr);
    SDL_RenderSetScale(renderer_, 1, 1);
}

void ImguiRenderer::make_font_texture() {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    font_.reset(SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ABGR8888, SDL_TEXTUREACCESS_STATIC, width, height));
    if (!font_) throw DeviceError(std::string("the window's text could not be set up: ") + SDL_GetError());
    SDL_UpdateTexture(font_.get(), nullptr, pixels, 4 * width);
    SDL_SetTextureBlendMode(font_.get(), SDL_BLENDMODE_BLEND);
    SDL_SetTextureScaleMode(font_.get(), SDL_ScaleModeLinear);
}

}  // namespace sundog::viewer
