// SPDX-License-Identifier: Apache-2.0
#include "denoise/oidn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sundog::denoise {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(float), "planes are handed over as they are");

/// A plane within the range that the library takes; what isn't finite becomes 0.
std::vector<Vec3> within(std::span<const Vec3> plane, float least, float most) {
    const auto channel = [&](float value) { return std::clamp(std::isfinite(value) ? value : 0, least, most); };
    std::vector<Vec3> out;
    out.reserve(plane.size());
    for (const Vec3 v : plane) out.push_back({channel(v.x), channel(v.y), channel(v.z)});
    return out;
}

bool goes_on(void* stop, double /*fraction*/) { return !static_cast<const StopFlag*>(stop)->requested(); }

std::string text_of(int version) {  // 20301: 2.3.1
    return std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
           std::to_string(version % 100);
}

}  // namespace

OpenImageDenoise::OpenImageDenoise(std::span<const std::string> names)
    : library_(names), device_(nullptr, library_.functions().release_device) {
    const OidnFunctions& oidn = library_.functions();
    // A graphics card's device couldn't read our planes.
    device_.reset(oidn.new_device(kOidnCpu));
    if (!device_) {
        check(nullptr);
        throw OidnError("Open Image Denoise: there is no device");
    }
    oidn.commit_device(device_.get());
    check(device_.get());
    version_ = text_of(oidn.get_device_int(device_.get(), "version"));
    check(device_.get());
}

void OpenImageDenoise::check(OidnDevice* device) const {
    const char* message = nullptr;
    const int error = library_.functions().get_device_error(device, &message);
    if (error == kOidnNoError) return;
    throw OidnError("Open Image Denoise: " + (message ? std::string(message) : "error " + std::to_string(error)));
}

std::vector<Vec3> OpenImageDenoise::denoised(const NoisyPicture& picture, const StopFlag& stop) const {
    check_planes(picture);
    const OidnFunctions& oidn = library_.functions();
    std::vector<Vec3> radiance = within(picture.radiance, 0, std::numeric_limits<float>::max());
    std::vector<Vec3> albedo = within(picture.albedo, 0, 1);
    std::vector<Vec3> normal = within(picture.normal, -1, 1);
    std::vector<Vec3> out(radiance.size());

    const std::unique_ptr<OidnFilter, void (*)(OidnFilter*)> filter(oidn.new_filter(device_.get(), "RT"),
                                                                    oidn.release_filter);
    if (!filter) {
        check(device_.get());
        throw OidnError("Open Image Denoise: there is no filter");
    }
    const auto set_image = [&](const char* name, std::vector<Vec3>& plane) {
        oidn.set_shared_filter_image(filter.get(), name, plane.data(), kOidnFloat3,
                                     static_cast<std::size_t>(picture.width), static_cast<std::size_t>(picture.height),
                                     0, 0, 0);
    };
    set_image("color", radiance);
    if (!albedo.empty()) set_image("albedo", albedo);
    if (!albedo.empty() && !normal.empty()) set_image("normal", normal);  // It takes none without albedo.
    set_image("output", out);
    oidn.set_filter_bool(filter.get(), "hdr", true);
    // Albedo and normals are means over a regular grid, without noise.
    if (!albedo.empty()) oidn.set_filter_bool(filter.get(), "cleanAux", true);
    oidn.set_filter_monitor(filter.get(), goes_on, const_cast<StopFlag*>(&stop));
    oidn.commit_filter(filter.get());
    check(device_.get());
    oidn.execute_filter(filter.get());
    if (stop.requested()) {
        // What was cancelled is an error to the library, which the next picture mustn't find.
        const char* ignored = nullptr;
        oidn.get_device_error(device_.get(), &ignored);
        return {};
    }
    check(device_.get());
    return out;
}

}  // namespace sundog::denoise
