// SPDX-License-Identifier: Apache-2.0
#include "viewer/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace sundog::viewer {
namespace {

constexpr std::size_t kNumbers = 12;

std::array<float, kNumbers> numbers_of(const kernel::Camera& c) {
    return {c.eye.x,   c.eye.y,   c.eye.z,   c.center.x, c.center.y, c.center.z,
            c.right.x, c.right.y, c.right.z, c.up.x,     c.up.y,     c.up.z};
}

bool spans_a_view(const std::array<float, kNumbers>& n) {
    const Affine3 view{{n[6], n[7], n[8]}, {n[9], n[10], n[11]}, {n[3], n[4], n[5]}, {}};
    return std::isfinite(determinant(view)) && determinant(view) != 0;
}

}  // namespace

std::string camera_argument(const kernel::Camera& camera) {
    return fmt::format("{}", fmt::join(numbers_of(camera), ","));
}

std::optional<kernel::Camera> parse_camera_argument(std::string_view text) {
    std::array<float, kNumbers> n{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < kNumbers; ++i) {
        if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
        const auto [after, error] = std::from_chars(at, end, n[i]);
        if (error != std::errc{} || !std::isfinite(n[i])) return std::nullopt;
        at = after;
    }
    if (at != end || !spans_a_view(n)) return std::nullopt;
    return kernel::Camera{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, {n[9], n[10], n[11]}};
}

std::string shell_quoted(std::string_view word) {
    constexpr std::string_view kHarmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
    if (!word.empty() && word.find_first_not_of(kHarmless) == std::string_view::npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) {
        if (c == '\'') quoted += "'\\''";
        else quoted += c;
    }
    return quoted + "'";
}

std::string replay_command(const std::filesystem::path& scene_file, std::string_view device,
                           const FrameOptions& options, int pixel_x, int pixel_y) {
    std::string command = "sundog render " + shell_quoted(scene_file.string());
    if (device != "auto") command += fmt::format(" --device {}", device);
    command += fmt::format(" --time {}", options.time_s);
    if (options.camera) command += " --camera " + camera_argument(*options.camera);
    if (options.max_depth) command += fmt::format(" --max-depth {}", *options.max_depth);
    if (options.min_weight) command += fmt::format(" --min-weight {}", *options.min_weight);
    if (options.shadows) command += fmt::format(" --shadows {}", *options.shadows ? "on" : "off");
    if (options.integrator != kernel::INTEGRATOR_WHITTED)
        command += options.integrator == kernel::INTEGRATOR_PATH ? " --integrator path" : " --integrator occlusion";
    if (options.lens_radius > 0)
        command += fmt::format(" --aperture {} --focus {}", options.lens_radius, options.focus_distance);
    if (options.width && options.height) command += fmt::format(" --size {}x{}", *options.width, *options.height);
    return command + fmt::format(" --pixel {},{}", pixel_x, pixel_y);
}

}  // namespace sundog::viewer
