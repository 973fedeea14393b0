// SPDX-License-Identifier: Apache-2.0
// How sure the pixels of a picture under way are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "device/film.h"

namespace sundog {

/// Mean and spread of blocks of samples, for each pixel of a film.
class PixelErrors {
public:
    /// `gain`: what radiance is shown times.
    PixelErrors(const PixelRect& bounds, float gain);

    /// What the film has gained since the last call is one block more for each of `pixels` (numbers of the film's; none
    /// for those that gained nothing).
    void add_blocks(const Film& film, std::span<const std::uint32_t> pixels);
    /// Half the width of the 95% confidence interval of a pixel's worst channel, in square roots of radiance as it is
    /// shown; infinite while there are too few blocks to tell. A pixel that surely is white or brighter has none.
    [[nodiscard]] float error(std::size_t pixel) const { return errors_[pixel]; }
    /// The largest error of a pixel and its eight neighbours.
    [[nodiscard]] float error_around(std::size_t pixel) const;
    /// Variance of each pixel's mean, by the spread of its blocks; the mean's square where there are fewer than two.
    [[nodiscard]] std::vector<Vec3> variances() const;
    [[nodiscard]] std::uint32_t blocks(std::size_t pixel) const { return pixels_[pixel].blocks; }

private:
    struct Pixel {
        std::array<float, 3> mean{}, squares{};  // of blocks; sums of squared differences from the mean
        std::array<float, 4> film{};             // its sums at the last call
        std::uint32_t blocks = 0;
    };
    [[nodiscard]] float error_of(const Pixel& pixel) const;

    std::size_t width_, height_;
    float gain_;
    std::vector<Pixel> pixels_;
    std::vector<float> errors_;
};

}  // namespace sundog
