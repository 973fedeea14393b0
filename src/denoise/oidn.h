// SPDX-License-Identifier: Apache-2.0
// Intel's Open Image Denoise: a trained network in place of our filter.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "denoise/denoise.h"
#include "denoise/oidn_library.h"

namespace sundog::denoise {

/// Open Image Denoise isn't there, or has failed.
class OidnError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The library with a device of it, ready for pictures. To be used by one thread at a time.
class OpenImageDenoise {
public:
    /// Errors: OidnError where no library of these names can be used.
    explicit OpenImageDenoise(std::span<const std::string> names = oidn_names());
    /// Such as "2.3.1".
    [[nodiscard]] const std::string& version() const { return version_; }
    /// The picture without its noise, by radiance, albedo and normals; variance and depth aren't looked at. Empty where
    /// `stop` was requested. The bits are the library's: another version or processor may make others. Errors:
    /// OidnError with the library's own message; std::invalid_argument for planes of another size.
    [[nodiscard]] std::vector<Vec3> denoised(const NoisyPicture& picture, const StopFlag& stop) const;

private:
    /// Throws the device's error, if it has one; `device` may be null.
    void check(OidnDevice* device) const;

    OidnLibrary library_;
    std::unique_ptr<OidnDevice, void (*)(OidnDevice*)> device_;
    std::string version_;
};

}  // namespace sundog::denoise
