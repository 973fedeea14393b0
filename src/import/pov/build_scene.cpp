// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_scene.h"

#include <array>
#include <string>

#include "import/pov/build_atmosphere.h"
#include "import/pov/build_camera.h"
#include "import/pov/build_materials.h"
#include "import/pov/build_media.h"
#include "import/pov/build_radiosity.h"

namespace sundog::pov {

void SceneBuilder::add(Block&& block) {
    version_ = block.version;
    try {
        read(block);
    } catch (const FunctionError& error) {
        context_.fail(error.where, error.what());
    }
}

void SceneBuilder::read(const Block& block) {
    if (is_object(block.keyword)) {
        writer_.add(objects_.read(block));
        return;
    }
    switch (block.keyword) {
        case Keyword::camera:
            context_.scene.projection_camera = read_camera(objects_, block).camera;
            return;
        case Keyword::background:
            read_background(context_, block);
            return;
        case Keyword::fog:
            read_fog(context_, block);
            return;
        case Keyword::sky_sphere:
            read_sky_sphere(context_, block);
            return;
        case Keyword::global_settings:
            read_global_settings(context_, block);
            return;
        case Keyword::rainbow:
            read_rainbow(context_, block);
            return;
        case Keyword::media:
            context_.scene.atmosphere.push_back(read_medium(context_, block));
            return;
        default:
            break;
    }
    static constexpr std::array<std::string_view, 12> kValid{
        "camera", "light_source", "background", "fog", "sky_sphere", "global_settings",
        "object", "union",        "sphere",     "box", "plane",      "mesh"};
    const std::string_view name = spelling(block.keyword);
    context_.fail(block.where, std::string(name) + " { } has no place outside other blocks", suggest(name, kValid));
}

void SceneBuilder::finish() {
    scene::Scene& scene = context_.scene;
    if (!scene.projection_camera) scene.projection_camera = CameraParts{}.camera;
    if (scene.materials.empty()) {
        static_cast<void>(MaterialTable(scene).of(textures_.default_texture(Block{}), {}, {}));
    }
    constexpr double kLinear = 1, kAsStored = 0;
    scene.settings.working_gamma =
        static_cast<float>(context_.color_space.assumed_gamma.value_or(version_ < 370 ? kAsStored : kLinear));
    constexpr float kAdcBailout = 1.0F / 255;  // POV-Ray's default
    constexpr int kMaxTraceLevel = 5;
    if (!scene.settings.min_weight) scene.settings.min_weight = kAdcBailout;
    use_radiosity_file(context_);
    if (!scene.settings.max_depth) scene.settings.max_depth = kMaxTraceLevel - 1;
}

}  // namespace sundog::pov
