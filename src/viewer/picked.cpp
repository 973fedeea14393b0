// SPDX-License-Identifier: Apache-2.0
#include "viewer/picked.h"

#include <fmt/format.h>

namespace sundog::viewer {
namespace {

std::string place_text(const SourceLocation& where) {
    if (!where.file) return {};
    return where.line > 0 ? fmt::format("{}:{}", *where.file, where.line) : *where.file;
}

}  // namespace

PickedPixel describe_pixel(const LoadedScene& loaded, const PixelInfo& info, int x, int y) {
    PickedPixel picked{x, y, info, info.geometry != kernel::NONE, {}, {}, {}, {}, {}};
    if (!picked.hit) return picked;

    const RenderScene& compiled = *loaded.compiled;
    if (info.geometry < compiled.geometry_names.size()) picked.object = compiled.geometry_names[info.geometry];
    if (info.geometry < compiled.geometry_objects.size()) {
        const std::uint32_t object = compiled.geometry_objects[info.geometry];
        if (object < loaded.scene.objects.size()) picked.object_place = place_text(loaded.scene.objects[object].where);
    }
    if (info.material < loaded.scene.materials.size()) {
        const scene::Material& material = loaded.scene.materials[info.material];
        picked.material = material.name;
        picked.material_place = place_text(material.where);
    }
    return picked;
}

}  // namespace sundog::viewer
