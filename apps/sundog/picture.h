// SPDX-License-Identifier: Apache-2.0
// From the film to pictures and their further layers, and what they may cost.
#pragma once

#include <cstddef>
#include <vector>

#include "arguments.h"
#include "device/film.h"
#include "output/image.h"

namespace sundog::app {

/// The mean radiance times 2^exposure_ev.
output::Image image_of(const Film& film, float exposure_ev);

/// Paints the pixels white that rays were traced through: those whose cost, which the film must have, isn't 0.
void paint_traced(const Film& film, output::Image& image);

/// The planes that were asked for. Numbers of objects, primitives and materials are -1 where there is none.
std::vector<output::Layer> layers_of(const Film& film, const AovChoice& aovs);

/// Bytes that rendering and writing a picture of this size takes, about.
std::size_t picture_memory(Size size, const AovChoice& aovs, bool denoise = false);

/// Bytes that this process may use: the machine's memory, or less where a control group or limit says so.
std::size_t usable_memory();

/// Errors: UsageError if the picture would take more memory than there is.
void check_picture_memory(Size size, const AovChoice& aovs, bool denoise = false);

}  // namespace sundog::app
