// SPDX-License-Identifier: Apache-2.0
// For tests: a device whose every pixel is known.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include "device/device.h"
#include "viewer/loaded_scene.h"
#include "viewer/picture_maker.h"

namespace sundog::viewer {

/// Too large for a first, quick picture, so that only refining renders it whole.
inline constexpr PixelSize kLarge{1280, 960};

/// What the test and the device share.
struct FakeDeviceControl {
    std::atomic<int> renders{0};       ///< Calls of render().
    std::atomic<int> full_renders{0};  ///< Of them, of kLarge pixels' width.
    std::atomic<bool> endless{false};  ///< render() of kLarge only returns when stopped.
    std::atomic<bool> broken{false};   ///< render() throws.
    std::atomic<bool> refines{false};  ///< can_refine() says so; refine() renders all the same.
};

/// Sample s of a pixel is (eye.x, s, 0), of object 7; pixels of odd columns cost a ray.
class FakeDevice : public Device {
public:
    FakeDevice(std::string kind, std::shared_ptr<FakeDeviceControl> control)
        : info_{std::move(kind), "fake", "", false}, control_(std::move(control)) {}

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] std::vector<std::string> unsupported(const RenderScene&) const override { return {}; }
    void load(std::shared_ptr<const RenderScene>) override {}
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

    RenderStats render(const Frame& frame, const RenderWork& work, Film& film, const StopFlag& stop) override {
        if (control_->broken) throw DeviceError("the fake device is broken");
        ++control_->renders;
        const bool full = frame.params.width == kLarge.width;
        if (full) ++control_->full_renders;
        for (int y = work.region.y0; y < work.region.y1; ++y) {
            for (int x = work.region.x0; x < work.region.x1; ++x) {
                auto& sum = film.radiance[film.index(x, y)];
                if (work.first_sample == 0) sum = {};
                sum[0] += frame.params.camera.eye.x;
                sum[1] += static_cast<float>(work.first_sample);
                sum[3] += 1;
                if (film.aovs & kernel::AOV_OBJECT) film.object[film.index(x, y)] = 7;
                if (film.aovs & kernel::AOV_COST) film.cost[film.index(x, y)] = static_cast<float>(x % 2);
            }
        }
        while (full && control_->endless && !stop.requested()) {
        }
        return {.rays = 100, .complete = !(full && control_->endless)};
    }

    [[nodiscard]] bool can_refine(const Frame&) const override { return control_->refines; }

private:
    DeviceInfo info_;
    std::shared_ptr<FakeDeviceControl> control_;
};

/// An empty scene, compiled.
std::shared_ptr<const LoadedScene> empty_scene();

/// A request for 64x48 pixels seen from (eye_x, 0, 0).
ViewRequest fake_request(std::shared_ptr<const LoadedScene> scene, float eye_x, PixelSize size = {64, 48});

/// "cpu" and "gpu" are fake devices; anything else can't be opened.
DeviceOpener fake_opener(std::shared_ptr<FakeDeviceControl> control);

}  // namespace sundog::viewer
