// SPDX-License-Identifier: Apache-2.0
#include "denoise/denoiser.h"

namespace sundog::denoise {

Denoiser::Denoiser(Method method, std::span<const std::string> oidn) {
    if (method == Method::filter) return;
    try {
        oidn_ = std::make_unique<OpenImageDenoise>(oidn);
    } catch (const OidnError&) {
        if (method == Method::oidn) throw;
    }
}

std::string Denoiser::name() const { return oidn_ ? "Open Image Denoise " + oidn_->version() : "Sundog's filter"; }

std::vector<Vec3> Denoiser::denoised(const NoisyPicture& picture, const StopFlag& stop) {
    if (oidn_) try {
            return oidn_->denoised(picture, stop);
        } catch (const OidnError& error) {
            failure_ = error.what();
            oidn_.reset();
        }
    return denoise::denoised(picture, stop);
}

}  // namespace sundog::denoise
