// SPDX-License-Identifier: Apache-2.0
// How far two pictures are apart.
#pragma once

#include "output/image.h"

namespace sundog::output {

/// Distances between two pictures of equal size, as they are stored: in 8-bit sRGB.
struct Comparison {
    double rmse = 0;     ///< Root of the mean square of all channels' differences, white being 1.
    double psnr_db = 0;  ///< Infinite for equal pictures.
    double ssim = 1;     ///< Mean SSIM of luma (Wang et al. 2004), 11x11 Gaussian, sigma 1.5.
    double flip = 0;     ///< Mean LDR-FLIP (Andersson et al. 2020), 67 pixels per degree.
    int max_difference_8bit = 0;
    double different_fraction = 0;  ///< Share of pixels with a channel more than 2/255 apart.
};

// Errors of all three: std::invalid_argument if the sizes differ or are zero.

Comparison compare(const Image& a, const Image& b);
/// |a - b| per channel of sRGB values, times `gain`, as a linear image to be written.
Image difference_image(const Image& a, const Image& b, float gain = 1);
/// The FLIP error of each pixel in colours from black (equal) by violet and red to pale yellow (1), as a linear image.
Image flip_image(const Image& a, const Image& b);

}  // namespace sundog::output
