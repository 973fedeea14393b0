// SPDX-License-Identifier: Apache-2.0
// Where a picture needs more samples.
#pragma once

#include <cstdint>
#include <vector>

#include "device/device.h"

namespace sundog {

/// Whether two colours differ enough to matter (POV-Ray's reference, section 3.2.8.7 "Anti-Aliasing Options").
class ColorContrast {
public:
    /// threshold: sum of the differences of red, green and blue from which two colours differ. gamma: they are compared
    /// as their 1/gamma-th powers.
    ColorContrast(double threshold, double gamma);
    /// A linear colour, cut to [0, 1], as it is compared.
    [[nodiscard]] Vec3 compared(Vec3 linear) const;
    /// Of two of those.
    [[nodiscard]] bool differ(Vec3 a, Vec3 b) const;

private:
    double threshold_;
    float power_;
};

/// Sampling by contrast, as POV-Ray's first method does it.
struct AdaptiveSampling {
    double threshold = 0.3;  ///< As in ColorContrast.
    double gamma = 2.5;      ///< As in ColorContrast.
    /// That pixels get which differ from a neighbour, on a regular grid for a square number and by Sobol's sequence
    /// otherwise; others have one, in their middle.
    std::uint32_t samples = 9;
    bool by_object = false;  ///< Pixels that see different objects differ, too: the film needs AOV_OBJECT.
    /// Pixels differ, too, whose depths are further apart than this times the smaller one; 0: not. Needs AOV_DEPTH.
    float depth_ratio = 0;
    /// The one sample a pixel is made by grid refinement of this tolerance (RefinedWork), and so not for all of them;
    /// 0: for all. Not together with by_object or depth_ratio.
    float preview = 0;
    RefinementMethod preview_method = RefinementMethod::grid;
    float gain = 1;  ///< As in RefinedWork.
};

/// Pixels that differ from the one to their left or above them, and those.
struct Contrast {
    std::vector<std::uint8_t> pixels;  ///< One for each of the film's: 1 or 0.
    std::vector<PixelRect> regions;    ///< That hold them: marked_regions().
};
Contrast contrast_of(const Film& film, const AdaptiveSampling& sampling);

}  // namespace sundog
