// SPDX-License-Identifier: Apache-2.0
// What is used of the C interface of Intel's Open Image Denoise, found at run time: nothing of it is needed to build.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace sundog::denoise {

/// The library's own, behind pointers.
struct OidnDevice;
struct OidnFilter;

inline constexpr int kOidnCpu = 1;      ///< A kind of device: one that reads this process's memory.
inline constexpr int kOidnFloat3 = 3;   ///< A format of pixels.
inline constexpr int kOidnNoError = 0;  ///< What oidnGetDeviceError() returns where all is well.

/// Asked now and then while a filter runs; false: it is to stop.
using OidnMonitor = bool (*)(void* user, double fraction);

/// Its functions, as its documentation tells. Version 2 gave get_device_int and set_filter_bool other names and left
/// the rest as it was since 1.0.
struct OidnFunctions {
    OidnDevice* (*new_device)(int kind) = nullptr;
    void (*commit_device)(OidnDevice*) = nullptr;
    void (*release_device)(OidnDevice*) = nullptr;
    int (*get_device_int)(OidnDevice*, const char* name) = nullptr;
    /// The first error since the last call; without a device, why none was made.
    int (*get_device_error)(OidnDevice*, const char** message) = nullptr;
    OidnFilter* (*new_filter)(OidnDevice*, const char* kind) = nullptr;
    void (*release_filter)(OidnFilter*) = nullptr;
    /// Strides in bytes, of a pixel and of a row; 0: without gaps.
    void (*set_shared_filter_image)(OidnFilter*, const char* name, void* pixels, int format, std::size_t width,
                                    std::size_t height, std::size_t offset, std::size_t pixel_stride,
                                    std::size_t row_stride) = nullptr;
    void (*set_filter_bool)(OidnFilter*, const char* name, bool value) = nullptr;
    void (*set_filter_monitor)(OidnFilter*, OidnMonitor, void* user) = nullptr;
    void (*commit_filter)(OidnFilter*) = nullptr;
    void (*execute_filter)(OidnFilter*) = nullptr;
};

/// The names under which it is looked for, the newest version first. Of version 1 the library was numbered 0 until 1.4.
std::span<const std::string> oidn_names();

/// The loaded library.
class OidnLibrary {
public:
    /// Loads the first one that has all functions; `names` as dlopen takes them. Errors: OidnError with all that was
    /// looked for and why it won't do.
    explicit OidnLibrary(std::span<const std::string> names);
    [[nodiscard]] const OidnFunctions& functions() const { return functions_; }

private:
    std::unique_ptr<void, void (*)(void*)> handle_;
    OidnFunctions functions_;
};

}  // namespace sundog::denoise
