// SPDX-License-Identifier: Apache-2.0
// Removes noise from pictures of Monte Carlo sampling, guided by what the eye rays met.
#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"

namespace sundog::denoise {

/// A picture and what is known of it; each plane has width*height values, row by row, or none where it may be missing.
struct NoisyPicture {
    int width = 0, height = 0;
    std::span<const Vec3> radiance;  ///< Linear RGB: the mean of a pixel's samples.
    std::span<const Vec3> variance;  ///< Of that mean, channel by channel; 0 where there is no noise.
    std::span<const Vec3> albedo{};  ///< Diffuse colour of what is seen, 0 where there is none; may be missing.
    std::span<const Vec3> normal{};  ///< Unit, or shorter where a pixel sees several; 0 on a miss; may be missing.
    std::span<const float> depth{};  ///< Distance from the eye; infinite on a miss; may be missing.
};

/// What light is divided by where a surface has this albedo: that, or 1 where it says little about what light does
/// there; between, it fades in.
Vec3 divisor(Vec3 albedo);

/// Errors: std::invalid_argument for planes of another size than the picture's.
void check_planes(const NoisyPicture& picture);

/// The picture without its noise: where the variance is 0 it stays as it is. Light is divided by albedo, so that
/// textures stay sharp; weights of the pixels around one are those of non-local means by the variances (Rousselle,
/// Knaus and Zwicker 2012), limited by normals and depths (Rousselle, Manzi and Zwicker 2013); with them a plane in
/// position and normal is laid through the values (first-order regression: Bitterli and others 2016). A single pixel
/// that stands out by its noise alone is cut down to its neighbours before. Runs on all cores; the bits don't depend on
/// how many. Empty where `stop` was requested. Errors: std::invalid_argument for planes of another size.
std::vector<Vec3> denoised(const NoisyPicture& picture, const StopFlag& stop);

}  // namespace sundog::denoise
