// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "output/white_balance.h"

namespace sundog::viewer {
namespace {

constexpr ImGuiWindowFlags kOverlay = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
const ImVec4 kFaint{0.62F, 0.65F, 0.70F, 1};
const ImVec4 kAccent{0.98F, 0.76F, 0.36F, 1};
const ImVec4 kAlarm{1.00F, 0.52F, 0.45F, 1};

float margin() { return ImGui::GetFontSize() * 0.7F; }

void text(const std::string& words) { ImGui::TextUnformatted(words.c_str()); }

void colored(const ImVec4& color, const std::string& words) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    text(words);
    ImGui::PopStyleColor();
}

void tooltip(const std::string& words) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", words.c_str());
}

// A monospaced block, broken where it is too long.
void code(const std::string& words) {
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::PushTextWrapPos(0);
    text(words);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

void device_menu(const Status& status, Controls& controls) {
    const bool open = ImGui::BeginCombo("Device", controls.device == "gpu" ? "GPU" : "CPU");
    if (!open) tooltip(status.device_name);
    if (!open) return;
    for (const DeviceChoice& device : status.devices) {
        const bool usable = device.why_unusable.empty();
        const auto flags = usable ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
        if (ImGui::Selectable(device.label.c_str(), device.choice == controls.device, flags)) {
            controls.device = device.choice;
        }
        if (!usable) {
            ImGui::Indent();
            colored(kFaint, device.why_unusable);
            ImGui::Unindent();
        }
    }
    ImGui::EndCombo();
}

void picture_line(const Status& status) {
    if (status.samples == 0) {  // a driver may take seconds to compile for a scene
        colored(kAccent, "preparing the first picture");
        return;
    }
    const std::string size = fmt::format("{} \u00d7 {}", status.size.width, status.size.height);
    if (status.pictures_per_s > 0) {
        colored(kFaint,
                fmt::format("{:.0f} fps \u00b7 {}rays/s", status.pictures_per_s, short_count(status.rays_per_s)));
    } else {
        colored(kFaint, fmt::format("{} sample{} \u00b7 {}rays/s", status.samples, status.samples == 1 ? "" : "s",
                                    short_count(status.rays_per_s)));
    }
    const bool reduced = status.size != status.full_size;
    colored(reduced ? kAccent : kFaint, size);
    if (reduced) {
        tooltip(fmt::format("Reduced from {} \u00d7 {} to hold the frame rate; sharpens at rest.",
                            status.full_size.width, status.full_size.height));
    }
    if (!status.own_camera) {
        ImGui::SameLine();
        colored(kFaint, "\u00b7 own camera");
        tooltip("Home: back to the scene's");
    }
}

void exposure_controls(Exposure& exposure) {
    ImGui::SliderFloat("Exposure", &exposure.ev, -8, 8, "%+.1f EV");
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) exposure.ev = 0;
    tooltip("Each step doubles the light; right click: 0");
    output::ToneMapping& tone = exposure.tone;
    constexpr std::array kCurves{"linear", "Reinhard", "ACES", "AgX", "gamma 2.2"};
    static_assert(kCurves.size() == output::kToneCurveNames.size());
    int curve = static_cast<int>(tone.curve);
    if (ImGui::Combo("Tones", &curve, kCurves.data(), static_cast<int>(kCurves.size())))
        tone.curve = static_cast<output::ToneCurve>(curve);
    tooltip("How radiance becomes what the screen shows");
    if (tone.curve == output::ToneCurve::reinhard) {
        ImGui::SliderFloat("White", &tone.white_point, 1, 64, "%.1f", ImGuiSliderFlags_Logarithmic);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) tone.white_point = output::ToneMapping{}.white_point;
        tooltip("The luminance that becomes white; right click: 4");
    }
    float temperature_k = tone.white_balance_k.value_or(output::kNeutralKelvin);
    if (ImGui::SliderFloat("Warmth", &temperature_k, 2000, 12000, "%.0f K", ImGuiSliderFlags_Logarithmic))
        tone.white_balance_k = temperature_k;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) tone.white_balance_k.reset();
    tooltip("The colour temperature of the light that is to look white; right click: 6504 K, as it is");
}

/// How light is found, and the lens through which it is seen.
void light_controls(const Status& status, Controls& controls) {
    constexpr std::array<const char*, 3> kIntegrators{"mirrors and shadows", "all light (paths)",
                                                      "how open (occlusion)"};
    auto integrator = static_cast<int>(controls.integrator);
    if (ImGui::Combo("Light", &integrator, kIntegrators.data(), static_cast<int>(kIntegrators.size())))
        controls.integrator = static_cast<std::uint32_t>(integrator);
    tooltip("Whitted's ray tracing, path tracing or ambient occlusion; the last two on the CPU (L)");
    const float widest = status.scene_size * 0.05F;
    ImGui::SliderFloat("Lens", &controls.lens_radius, 0, widest, "%.3g");
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) controls.lens_radius = 0;
    tooltip("Radius of the lens: what is out of focus is blurred; right click: none");
    if (controls.lens_radius > 0) {
        ImGui::SliderFloat("Focus", &controls.focus_distance, status.scene_size * 0.01F, status.scene_size * 4, "%.4g",
                           ImGuiSliderFlags_Logarithmic);
        tooltip("Distance to what is sharp; Ctrl + click on it offers 'Focus here'");
    }
}

void main_panel(const Status& status, Controls& controls) {
    ImGui::SetNextWindowPos({margin(), margin()});
    ImGui::Begin("##main", nullptr, kOverlay);
    text(status.scene_name);
    if (status.loading) {
        ImGui::SameLine();
        colored(kAccent, "reading");
    }
    ImGui::SameLine();
    colored(kFaint, "  F1 help");
    picture_line(status);
    ImGui::Separator();
    ImGui::PushItemWidth(ImGui::GetFontSize() * 9);
    device_menu(status, controls);
    int max_depth = controls.max_depth.value_or(status.scene_max_depth);
    const int deepest = std::max(32, status.scene_max_depth);
    if (ImGui::SliderInt("Depth", &max_depth, 0, deepest)) controls.max_depth = std::max(max_depth, 0);
    tooltip("Mirror and refraction rays on a path at most");
    light_controls(status, controls);
    exposure_controls(controls.exposure);
    bool shadows = controls.shadows.value_or(status.scene_shadows);
    if (ImGui::Checkbox("Shadows", &shadows)) controls.shadows = shadows;
    ImGui::SameLine();
    ImGui::Checkbox("Rays", &controls.show_rays);
    tooltip("Traced pixels white, where the CPU interpolates the others (R)");
    ImGui::SameLine();
    ImGui::Checkbox("Denoise", &controls.denoise);
    tooltip("Take the noise out of the picture at rest, from 4 samples on");
    ImGui::PopItemWidth();
    if (!status.warnings.empty()) {
        ImGui::SameLine();
        colored(kAccent,
                fmt::format("   {} warning{}", status.warnings.size(), status.warnings.size() == 1 ? "" : "s"));
        if (ImGui::IsItemHovered()) {
            ImGui::BeginTooltip();
            const std::size_t shown = std::min<std::size_t>(status.warnings.size(), 8);
            for (std::size_t i = 0; i < shown; ++i) code(status.warnings[i]);
            if (shown < status.warnings.size()) text(fmt::format("and {} more", status.warnings.size() - shown));
            ImGui::EndTooltip();
        }
    }
    ImGui::End();
}

// Drawn rather than written, since fonts rarely carry these signs.
bool play_button(bool playing) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Button("##play", {side, side});
    ImDrawList& drawing = *ImGui::GetWindowDrawList();
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
    const auto point = [&](float x, float y) { return ImVec2{at.x + x * side, at.y + y * side}; };
    if (playing) {
        drawing.AddRectFilled(point(0.30F, 0.27F), point(0.44F, 0.73F), ink);
        drawing.AddRectFilled(point(0.56F, 0.27F), point(0.70F, 0.73F), ink);
    } else {
        drawing.AddTriangleFilled(point(0.34F, 0.25F), point(0.34F, 0.75F), point(0.75F, 0.50F), ink);
    }
    tooltip(playing ? "Pause (space)" : "Play (space)");
    return pressed;
}

void time_line(Playback& playback) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(screen.x - 2 * margin(), ImGui::GetFontSize() * 40);
    ImGui::SetNextWindowPos({screen.x / 2, screen.y - margin()}, ImGuiCond_Always, {0.5F, 1});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("##time", nullptr, kOverlay & ~ImGuiWindowFlags_AlwaysAutoResize);
    if (play_button(playback.playing())) playback.toggle();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    float time_s = playback.time_s();
    if (ImGui::SliderFloat("##scrub", &time_s, 0, playback.range_s(), "%.2f s")) {
        playback.set_playing(false);
        playback.scrub(time_s);
    }
    ImGui::End();
}

// The end of a path tells more than its beginning.
std::string shortened(const std::string& place) {
    constexpr std::size_t kLongest = 36;
    if (place.size() <= kLongest) return place;
    const std::size_t slash = place.find('/', place.size() - kLongest + 3);
    return "..." + place.substr(slash != std::string::npos ? slash : place.size() - kLongest + 3);
}

void row(const char* name, const std::string& value, const std::string& place = {}) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    colored(kFaint, name);
    ImGui::TableNextColumn();
    text(value);
    if (place.empty()) return;
    colored(kFaint, shortened(place));
    tooltip(place);
}

void pixel_rows(const PickedPixel& pixel) {
    const Vec3 color = pixel.info.radiance;
    row("Colour", fmt::format("{:.4f}  {:.4f}  {:.4f}", color.x, color.y, color.z));
    if (!pixel.hit) {
        row("Object", "none: the sky");
        return;
    }
    const Vec3 n = pixel.info.normal;
    row("Object", pixel.object, pixel.object_place);
    row("Material", pixel.material, pixel.material_place);
    row("Depth", fmt::format("{:.5g}", pixel.info.depth));
    row("Normal", fmt::format("{:+.3f}  {:+.3f}  {:+.3f}", n.x, n.y, n.z));
}

void pixel_panel(std::optional<PickedPixel>& picked, Controls& controls) {
    if (!picked) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - margin(), margin()}, ImGuiCond_Always, {1, 0});
    ImGui::Begin("##pixel", nullptr, kOverlay);
    text(fmt::format("Pixel {}, {}", picked->x, picked->y));
    if (ImGui::BeginTable("##values", 2)) {
        pixel_rows(*picked);
        ImGui::EndTable();
    }
    if (ImGui::Button("Copy command")) {
        ImGui::SetClipboardText(picked->replay.c_str());
        controls.copied = true;
    }
    tooltip(picked->replay);
    ImGui::SameLine();
    if (picked->hit) {
        if (ImGui::Button("Focus here")) {
            controls.focus_distance = picked->info.axis_depth;
            if (!(controls.lens_radius > 0)) controls.lens_radius = picked->info.axis_depth * 0.02F;
        }
        tooltip("Make this sharp, through a lens");
        ImGui::SameLine();
    }
    const bool close = ImGui::Button("Close");
    ImGui::End();
    if (close) picked.reset();
}

// Messages stand in the lower part, over the time line.
void error_panel(const std::string& error, bool has_picture) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float above_time_line = ImGui::GetFrameHeight() + 4 * margin();
    ImGui::SetNextWindowPos({screen.x / 2, screen.y - above_time_line}, ImGuiCond_Always, {0.5F, 1});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {screen.x - 2 * margin(), screen.y / 2});
    ImGui::SetNextWindowSize({std::min(screen.x - 2 * margin(), ImGui::GetFontSize() * 52), 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4{0.20F, 0.05F, 0.05F, 0.93F});
    ImGui::PushStyleColor(ImGuiCol_Border, ImVec4{0.80F, 0.30F, 0.25F, 0.8F});
    ImGui::Begin("##error", nullptr, kOverlay & ~ImGuiWindowFlags_AlwaysAutoResize);
    if (has_picture) colored(kAlarm, "Still showing the last good picture");
    code(error);
    ImGui::End();
    ImGui::PopStyleColor(2);
}

void note_panel(const std::string& note) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, margin()}, ImGuiCond_Always, {0.5F, 0});
    ImGui::Begin("##note", nullptr, kOverlay | ImGuiWindowFlags_NoInputs);
    text(note);
    ImGui::End();
}

void help_overlay() {
    struct Line {
        const char* keys;
        const char* meaning;
    };
    constexpr std::array kLines = {Line{"Left drag", "orbit"},
                                   Line{"Middle or Shift + left drag", "pan"},
                                   Line{"Wheel", "zoom"},
                                   Line{"Right drag", "look around"},
                                   Line{"W A S D, Q E", "fly, down and up; Shift: faster"},
                                   Line{"Home", "back to the scene's own camera"},
                                   Line{"Space", "play, pause"},
                                   Line{"Left, Right", "a frame (1/25 s) back, on"},
                                   Line{"Ctrl + click or P", "what is at this pixel"},
                                   Line{"R", "traced pixels white"},
                                   Line{"L", "all light: paths, and back"},
                                   Line{"Ctrl + S", "save the picture"},
                                   Line{"Tab", "hide or show the panels"},
                                   Line{"F11", "full screen"},
                                   Line{"F1", "this help"},
                                   Line{"Escape", "quit"}};
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.96F);
    ImGui::Begin("##help", nullptr, kOverlay | ImGuiWindowFlags_NoInputs);
    if (ImGui::BeginTable("##keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const Line& line : kLines) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            colored(kAccent, line.keys);
            ImGui::TableNextColumn();
            text(line.meaning);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace

std::string short_count(double count) {
    if (count >= 1e9) return fmt::format("{:.2f} G", count / 1e9);
    if (count >= 1e6) return fmt::format("{:.1f} M", count / 1e6);
    if (count >= 1e3) return fmt::format("{:.0f} k", count / 1e3);
    return fmt::format("{:.0f} ", count);
}

void set_style(float font_px) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.ScaleAllSizes(font_px / 15);
    style.WindowRounding = style.FrameRounding = style.PopupRounding = style.GrabRounding = font_px * 0.3F;
    style.WindowBorderSize = 1;
    style.WindowMinSize = {1, 1};
    style.WindowPadding = {font_px * 0.7F, font_px * 0.55F};
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_WindowBg] = {0.07F, 0.08F, 0.10F, 0.82F};
    colors[ImGuiCol_PopupBg] = {0.09F, 0.10F, 0.12F, 0.97F};
    colors[ImGuiCol_Border] = {1, 1, 1, 0.09F};
    colors[ImGuiCol_Separator] = {1, 1, 1, 0.12F};
    colors[ImGuiCol_FrameBg] = {1, 1, 1, 0.08F};
    colors[ImGuiCol_FrameBgHovered] = {1, 1, 1, 0.14F};
    colors[ImGuiCol_FrameBgActive] = {1, 1, 1, 0.19F};
    colors[ImGuiCol_Button] = {1, 1, 1, 0.10F};
    colors[ImGuiCol_ButtonHovered] = {1, 1, 1, 0.18F};
    colors[ImGuiCol_ButtonActive] = {1, 1, 1, 0.26F};
    colors[ImGuiCol_Header] = {1, 1, 1, 0.10F};
    colors[ImGuiCol_HeaderHovered] = {1, 1, 1, 0.16F};
    colors[ImGuiCol_HeaderActive] = {1, 1, 1, 0.22F};
    colors[ImGuiCol_SliderGrab] = {0.98F, 0.76F, 0.36F, 0.85F};
    colors[ImGuiCol_SliderGrabActive] = kAccent;
    colors[ImGuiCol_CheckMark] = kAccent;
}

void draw_panels(Status& status, Controls& controls, Playback& playback) {
    if (controls.show_panels) {
        main_panel(status, controls);
        pixel_panel(status.picked, controls);
        if (status.animated) time_line(playback);
    }
    if (!status.error.empty()) error_panel(status.error, status.samples > 0);
    if (!status.note.empty()) note_panel(status.note);
    if (controls.show_help) help_overlay();
}

}  // namespace sundog::viewer
