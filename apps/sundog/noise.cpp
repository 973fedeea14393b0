// SPDX-License-Identifier: Apache-2.0
#include "noise.h"

#include <chrono>
#include <utility>

#include "session/clean_film.h"

namespace sundog::app {

double remove_noise(Device& device, const Frame& frame, const StopFlag& stop, RenderResult& result) {
    const auto start = std::chrono::steady_clock::now();
    const PictureGuides guides = trace_guides(device, frame, stop);
    if (auto clean = cleaned(result.film, result.variance, guides, stop)) result.film = std::move(*clean);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace sundog::app
