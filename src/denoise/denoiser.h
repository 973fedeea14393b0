// SPDX-License-Identifier: Apache-2.0
// Which of the two ways takes the noise out: Open Image Denoise where it is installed, else our filter.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "denoise/denoise.h"
#include "denoise/oidn.h"

namespace sundog::denoise {

/// What is asked for.
enum class Method {
    automatic,  ///< Open Image Denoise where it can be used, else the filter.
    filter,     ///< Ours: denoised().
    oidn        ///< Open Image Denoise or nothing.
};

/// Takes the noise out of pictures in the way that was chosen when it was made. To be used by one thread at a time.
class Denoiser {
public:
    /// `oidn`: the names under which the library is looked for. Errors: OidnError if it can't be used and the method
    /// asks for it.
    explicit Denoiser(Method method, std::span<const std::string> oidn = oidn_names());
    /// "Open Image Denoise 2.3.1", or "Sundog's filter".
    [[nodiscard]] std::string name() const;
    /// The picture without its noise; empty where `stop` was requested. Where Open Image Denoise fails, a picture that
    /// took long isn't lost: from then on the filter stands in. Errors: std::invalid_argument for planes of another
    /// size.
    std::vector<Vec3> denoised(const NoisyPicture& picture, const StopFlag& stop);
    /// Why Open Image Denoise failed on a picture; empty where it didn't.
    [[nodiscard]] const std::string& failure() const { return failure_; }

private:
    std::unique_ptr<OpenImageDenoise> oidn_;  // null: the filter is used
    std::string failure_;
};

}  // namespace sundog::denoise
