// SPDX-License-Identifier: Apache-2.0
#include "device/film.h"

#include "kernel/shared.h"

namespace sundog {

Film::Film(PixelRect bounds_, std::uint32_t aovs_)
    : bounds(bounds_),
      aovs(aovs_),
      radiance(static_cast<std::size_t>(bounds_.width()) * static_cast<std::size_t>(bounds_.height())) {
    const std::size_t pixels = radiance.size();
    if (aovs & kernel::AOV_DEPTH) depth.resize(pixels);
    if (aovs & kernel::AOV_NORMAL) normal.resize(pixels);
    if (aovs & kernel::AOV_ALBEDO) albedo.resize(pixels);
    if (aovs & kernel::AOV_OBJECT) {
        object.resize(pixels, kernel::NONE);
        primitive.resize(pixels, kernel::NONE);
        material.resize(pixels, kernel::NONE);
    }
    if (aovs & kernel::AOV_COST) cost.resize(pixels);
}

}  // namespace sundog
