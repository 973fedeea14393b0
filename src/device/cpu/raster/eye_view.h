// SPDX-License-Identifier: Apache-2.0
// The eye of a perspective picture, as rasterising wants it.
#pragma once

#include "kernel/shared.h"

namespace sundog::cpu::raster {

/// How far rounding may move what is computed of a triangle, relative to the products that it is made of: 64 units in
/// the last place. About 40 can be counted in Embree's test, in the making of the kernel's rays and in what is done
/// here (each sum and product one, the direction of a ray ten).
inline constexpr float kRounding = 64 * 5.9604645e-8F;

/// Where pixels look. The ray through (x, y), in pixels from the picture's left upper corner, goes from `eye` along
/// base + across*x + down*y; lengths along rays are measured in that vector's, so that their inverse is linear in x and
/// y, too.
struct EyeView {
    kernel::vec3 eye;
    kernel::vec3 base, across, down;
    /// v is dot(v, forward) times the way to the window's middle, and so many times half its width and half its height
    /// to the right and up.
    kernel::vec3 forward, right, up;
    float spread;         ///< No ray's vector, nor what it is the sum of, is longer.
    float volume;         ///< Of base, across and down.
    float width, height;  ///< In pixels.
    /// The inverse length at which rays end, with rounding: what is certainly beyond is under the first, what is
    /// certainly before it over the second.
    float end_low, end_high;
};

/// Of a frame whose camera is a pinhole's.
EyeView eye_view_of(const kernel::FrameParams& frame);

}  // namespace sundog::cpu::raster
