// SPDX-License-Identifier: Apache-2.0
#include "viewer/fake_device.h"

#include "base/diagnostics.h"
#include "compile/compile.h"

namespace sundog::viewer {

std::shared_ptr<const LoadedScene> empty_scene() {
    auto loaded = std::make_shared<LoadedScene>();
    loaded->scene.materials.emplace_back();
    loaded->compiled = compile(loaded->scene, {});
    return loaded;
}

ViewRequest fake_request(std::shared_ptr<const LoadedScene> scene, float eye_x, PixelSize size) {
    ViewRequest request{std::move(scene), "cpu", {}, {}, false, false};
    request.options.width = size.width;
    request.options.height = size.height;
    request.options.camera = kernel::Camera{{eye_x, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    return request;
}

DeviceOpener fake_opener(std::shared_ptr<FakeDeviceControl> control) {
    return [control = std::move(control)](const std::string& choice) -> std::unique_ptr<Device> {
        if (choice != "cpu" && choice != "gpu") throw DeviceError("there is no " + choice);
        return std::make_unique<FakeDevice>(choice, control);
    };
}

}  // namespace sundog::viewer
