// SPDX-License-Identifier: Apache-2.0
// The picture under way without its noise.
#pragma once

#include <cstdint>
#include <optional>

#include "denoise/denoiser.h"
#include "device/device.h"
#include "session/guides.h"
#include "session/pixel_errors.h"

namespace sundog::viewer {

/// Keeps account of a film's passes and makes clean films of them.
class CleanPicture {
public:
    explicit CleanPicture(denoise::Method method) : method_(method) {}
    /// The next pass is another picture's first.
    void forget();
    /// The film has got a pass more, of every pixel.
    void add_pass(const Film& film);
    /// Cleans the film as it is, which has `samples` a pixel and had at least two passes. False if it was stopped; the
    /// clean film before stays then.
    bool clean(Device& device, const Frame& frame, const Film& film, std::uint32_t samples, const StopFlag& stop);
    /// The last clean film, and how many samples a pixel it had; null and 0 before there is one.
    [[nodiscard]] const Film* film() const { return clean_ ? &*clean_ : nullptr; }
    [[nodiscard]] std::uint32_t samples() const { return samples_; }

private:
    denoise::Method method_;
    std::optional<denoise::Denoiser> denoiser_;  // made when it is first needed
    std::optional<PixelErrors> errors_;
    std::optional<PictureGuides> guides_;
    std::optional<Film> clean_;
    std::uint32_t samples_ = 0;
};

}  // namespace sundog::viewer
