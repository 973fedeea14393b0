// SPDX-License-Identifier: Apache-2.0
// Films without their noise.
#pragma once

#include <optional>
#include <span>

#include "base/progress.h"
#include "denoise/denoiser.h"
#include "device/film.h"
#include "session/guides.h"

namespace sundog {

/// A film whose means are denoised; its pixels keep their weights. `variance`: of its means. None if it was stopped.
std::optional<Film> cleaned(const Film& film, std::span<const Vec3> variance, const PictureGuides& guides,
                            denoise::Denoiser& denoiser, const StopFlag& stop);

}  // namespace sundog
