// SPDX-License-Identifier: Apache-2.0
#include "device/choose/choose.h"

#include <algorithm>
#include <optional>

#include "base/diagnostics.h"
#include "device/choose/gpu_nodes.h"
#include "device/cpu/cpu_device.h"
#include "device/vulkan/vulkan_device.h"

namespace sundog {
namespace {

/// The adapters, and which of them to use: the first usable hardware one, else (if wanted) the first usable one.
struct Gpus {
    std::string why_none;  // before the adapters: listing them fills it
    std::vector<VulkanAdapter> adapters;

    Gpus() : adapters(vulkan_adapters(why_none)) {}
    [[nodiscard]] std::optional<std::size_t> best(bool software_too) const {
        const auto first = [this](bool software) -> std::optional<std::size_t> {
            for (std::size_t i = 0; i < adapters.size(); ++i)
                if (adapters[i].why_unusable.empty() && adapters[i].info.software == software) return i;
            return std::nullopt;
        };
        const auto hardware = first(false);
        return hardware || !software_too ? hardware : first(true);
    }
    /// Why best(true) is empty.
    [[nodiscard]] std::string why_unusable() const {
        if (adapters.empty()) return why_none;
        std::string why;
        for (const VulkanAdapter& adapter : adapters)
            why += (why.empty() ? "" : "; ") + adapter.info.name + ": " + adapter.why_unusable;
        return why;
    }
};

}  // namespace

std::vector<DeviceListing> list_devices() {
    const Gpus gpus;
    const auto best = gpus.best(false);
    std::vector<DeviceListing> listings;
    listings.push_back({make_cpu_device({})->info(), !best, ""});
    for (std::size_t i = 0; i < gpus.adapters.size(); ++i)
        listings.push_back({gpus.adapters[i].info, best == i, gpus.adapters[i].why_unusable});
    if (gpus.adapters.empty()) listings.push_back({{"gpu", "none", "", false}, false, gpus.why_none});
    return listings;
}

std::unique_ptr<Device> open_device(std::string_view choice, int threads, Acceleration acceleration,
                                    PrimaryHits primary) {
    const bool asked_for = choice == "gpu";
    if (asked_for || (choice != "cpu" && may_have_hardware_gpu())) {
        const Gpus gpus;
        if (const auto best = gpus.best(asked_for)) return make_vulkan_device(*best);
        if (asked_for) throw DeviceError("no GPU can be used here: " + gpus.why_unusable());
    }
    CpuOptions options;
    options.threads = threads;
    options.acceleration = acceleration;
    options.primary = primary;
    return make_cpu_device(options);
}

}  // namespace sundog
