// SPDX-License-Identifier: Apache-2.0
#include "test_devices.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace sundog::parity {
namespace {

int srgb8(float linear) {
    const float v = std::clamp(linear, 0.0F, 1.0F);
    const float encoded = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
    return static_cast<int>(std::lround(encoded * 255));
}

}  // namespace

int difference(Vec3 a, Vec3 b) {
    const auto channel = [](float p, float q) { return std::abs(srgb8(p) - srgb8(q)); };
    return std::max({channel(a.x, b.x), channel(a.y, b.y), channel(a.z, b.z)});
}

std::unique_ptr<Device> open_gpu(std::vector<std::string>& messages, std::string& why, VulkanOptions options) {
    const auto adapters = vulkan_adapters(why);
    for (std::size_t i = 0; i < adapters.size(); ++i) {
        if (!adapters[i].why_unusable.empty()) {
            why += adapters[i].info.name + ": " + adapters[i].why_unusable + ". ";
            continue;
        }
        options.on_validation_message = [&messages](std::string_view message) { messages.emplace_back(message); };
        return make_vulkan_device(i, options);
    }
    return nullptr;
}

Prepared prepare(const TestScene& test, int width, int height) {
    Prepared prepared;
    prepared.scene = compile(test.scene, {});
    FrameOptions options;
    options.width = width;
    options.height = height;
    options.time_s = test.time_s;
    prepared.frame = make_frame(test.scene, *prepared.scene, options);
    return prepared;
}

Film render(Device& device, const Frame& frame, std::uint32_t samples, std::uint32_t aovs) {
    Film film({0, 0, static_cast<int>(frame.params.width), static_cast<int>(frame.params.height)}, aovs);
    const StopFlag never;
    Frame with_aovs = frame;
    with_aovs.params.aovs = aovs;
    device.render(with_aovs, {film.bounds, 0, samples}, film, never);
    return film;
}

}  // namespace sundog::parity
