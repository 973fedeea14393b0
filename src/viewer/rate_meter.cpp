// SPDX-License-Identifier: Apache-2.0
#include "viewer/rate_meter.h"

namespace sundog::viewer {

void RateMeter::add(double now_s, std::uint64_t rays, double render_s) {
    if (last_s_ < 0 || now_s - last_s_ > kWindow_s) {  // after a rest: begin anew
        begin_s_ = now_s;
        pictures_ = 0;
        rays_ = render_s_ = pictures_per_s_ = 0;
    } else {
        ++pictures_;
    }
    last_s_ = now_s;
    rays_ += static_cast<double>(rays);
    render_s_ += render_s;
    const bool first_figures = rays_per_s_ == 0 && render_s_ > 0;
    if (first_figures) rays_per_s_ = rays_ / render_s_;
    if (now_s - begin_s_ < kWindow_s) return;
    pictures_per_s_ = pictures_ / (now_s - begin_s_);
    if (render_s_ > 0) rays_per_s_ = rays_ / render_s_;
    begin_s_ = now_s;
    pictures_ = 0;
    rays_ = render_s_ = 0;
}

double RateMeter::pictures_per_s(double now_s) const {
    return last_s_ >= 0 && now_s - last_s_ <= kWindow_s ? pictures_per_s_ : 0;
}

}  // namespace sundog::viewer
