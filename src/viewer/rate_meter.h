// SPDX-License-Identifier: Apache-2.0
// Pictures and rays per second, calm enough to read.
#pragma once

#include <cstdint>

namespace sundog::viewer {

/// Averages over half a second.
class RateMeter {
public:
    /// A picture came at now_s (seconds of any clock); its rays took render_s.
    void add(double now_s, std::uint64_t rays, double render_s);
    /// Pictures a second; 0 if none came for half a second.
    [[nodiscard]] double pictures_per_s(double now_s) const;
    /// Rays for each second spent rendering.
    [[nodiscard]] double rays_per_s() const { return rays_per_s_; }

private:
    static constexpr double kWindow_s = 0.5;
    double begin_s_ = 0, last_s_ = -1;
    int pictures_ = 0;
    double rays_ = 0, render_s_ = 0;
    double pictures_per_s_ = 0, rays_per_s_ = 0;
};

}  // namespace sundog::viewer
