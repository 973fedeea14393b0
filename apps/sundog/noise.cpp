// SPDX-License-Identifier: Apache-2.0
#include "noise.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "arguments.h"
#include "console.h"
#include "session/clean_film.h"

namespace sundog::app {

denoise::Method parse_denoiser(std::string_view text) {
    const std::string name = parse_choice("--denoiser", text, {"auto", "filter", "oidn"});
    if (name == "oidn") return denoise::Method::oidn;
    return name == "filter" ? denoise::Method::filter : denoise::Method::automatic;
}

std::string remove_noise(denoise::Denoiser& denoiser, Device& device, const Frame& frame, const StopFlag& stop,
                         RenderResult& result) {
    const auto start = std::chrono::steady_clock::now();
    const bool had_failed = !denoiser.failure().empty();
    const PictureGuides guides = trace_guides(device, frame, stop);
    auto clean = cleaned(result.film, result.variance, guides, denoiser, stop);
    if (!clean) return "interrupted before it was denoised";
    result.film = std::move(*clean);
    if (!had_failed && !denoiser.failure().empty())
        print_note(fmt::format("{}; {} takes the noise out instead", denoiser.failure(), denoiser.name()));
    return fmt::format("denoised by {} in {:.2f} s", denoiser.name(),
                       std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace sundog::app
