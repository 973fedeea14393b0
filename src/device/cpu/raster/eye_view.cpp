// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/raster/eye_view.h"

#include <cmath>

#include "base/vec.h"

namespace sundog::cpu::raster {
namespace {

Vec3 host(const kernel::vec3& v) { return {v.x, v.y, v.z}; }
kernel::vec3 stored(const Vec3& v) { return {v.x, v.y, v.z}; }
float sum_of_sizes(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

EyeView eye_view_of(const kernel::FrameParams& frame) {
    const Vec3 center = host(frame.camera.center), right = host(frame.camera.right), up = host(frame.camera.up);
    const auto width = static_cast<float>(frame.width), height = static_cast<float>(frame.height);
    const float volume = dot(center, cross(right, up));
    EyeView view{};
    view.eye = frame.camera.eye;
    view.base = stored(center - right + up);
    view.across = stored(right * (2 / width));
    view.down = stored(up * (-2 / height));
    view.forward = stored(cross(right, up) * (1 / volume));
    view.right = stored(cross(up, center) * (1 / volume));
    view.up = stored(cross(center, right) * (1 / volume));
    view.spread = sum_of_sizes(center) + sum_of_sizes(right) + sum_of_sizes(up);
    view.volume = std::abs(volume) * 4 / (width * height);
    view.width = width;
    view.height = height;
    const float end = length(center) / frame.far_z;
    view.end_low = end * (1 - kRounding);
    view.end_high = end * (1 + kRounding);
    return view;
}

}  // namespace sundog::cpu::raster
