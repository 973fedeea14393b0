// SPDX-License-Identifier: Apache-2.0
// Films as pictures, to be compared.
#pragma once

#include "device/film.h"
#include "output/image.h"

namespace sundog::bench {

/// The mean radiance of each pixel.
inline output::Image image_of(const Film& film) {
    output::Image image(film.bounds.width(), film.bounds.height());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.at(x, y) = film.mean(x, y);
    return image;
}

}  // namespace sundog::bench
