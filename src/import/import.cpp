// SPDX-License-Identifier: Apache-2.0
#include "import/import.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "base/paths.h"
#include "base/text_file.h"
#include "import/gltf/gltf_import.h"
#include "import/obj/obj_import.h"
#include "import/orbit/orbit_import.h"
#include "import/orbit/orbit_keys.h"
#include "import/pov/pov_import.h"
#include "scene/bounds.h"
#include "scene/files.h"

namespace sundog::import {
namespace {

std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

/// Turns Y up into Z up: what faced +Z (the front, by custom) then faces -Y, where the orbit camera starts.
void stand_up(scene::Scene& scene) {
    const auto turned = [](Vec3 v) { return Vec3{v.x, -v.z, v.y}; };
    for (scene::Object& object : scene.objects) {
        auto& mesh = *std::get<Boxed<scene::Mesh>>(object.shape);
        for (Vec3& p : mesh.positions) p = turned(p);
        for (Vec3& n : mesh.normals) n = turned(n);
    }
}

/// An orbit around all there is.
void add_camera(scene::Scene& scene) {
    constexpr float kMargin = 1.1F;
    constexpr float kFocus = 24;  // 53 degrees high
    const Bounds3 bounds = scene::bounds_of(scene);
    const float extent = bounds.empty() ? 0 : length(bounds.extent() * 0.5F);
    const float radius = std::isfinite(extent) && extent > 0 ? extent : 1;
    const float half_height = std::atan(12 / kFocus);
    scene.camera.focus = kFocus;
    scene.camera.origin = bounds.empty() ? Vec3{} : bounds.lower * 0.5F + bounds.upper * 0.5F;
    scene.camera.distance = kMargin * radius / std::sin(half_height);
    scene.camera.rot_x_deg.base = -20;
    scene.camera.rot_z_deg = {scene::Motion::Kind::linear, 0, 20, 0};
}

/// A sun and some light from everywhere.
void add_daylight(scene::Scene& scene) {
    scene::Light sun;
    sun.kind = scene::Light::Kind::sun;
    sun.place = {-0.5F, -0.8F, 1.2F};
    scene.lights.push_back(sun);
    scene.ambient = {0.15F, 0.15F, 0.15F};
    scene.sky = {0.50F, 0.56F, 0.64F};
}

scene::Scene import_model(const std::filesystem::path& file, const WarningSink& warn) {
    scene::Scene scene;
    scene.name = file.stem().string();
    import_obj(file, scene, warn);
    if (scene.materials.empty()) scene.materials.emplace_back().name = "default";
    stand_up(scene);
    add_camera(scene);
    add_daylight(scene);
    return scene;
}

/// True if something is there to give light: a surface that shines all over, for pictures of screens and lamps on
/// things light nothing. Surfaces that are all unlit need none.
bool has_light(const scene::Scene& scene) {
    const auto shines = [](const scene::Material& m) {
        return m.principled && m.principled->emission_map.texture == scene::kNone &&
               !(m.principled->emission == Vec3{});
    };
    const auto unlit = [](const scene::Material& m) { return m.principled && m.principled->unlit; };
    return !scene.lights.empty() || scene.environment ||
           std::any_of(scene.materials.begin(), scene.materials.end(), shines) ||
           std::all_of(scene.materials.begin(), scene.materials.end(), unlit);
}

scene::Scene import_gltf_model(const std::filesystem::path& file, const WarningSink& warn, const Choices& choices) {
    scene::Scene scene = gltf::import_gltf(file, warn, choices.variant);
    if (!scene.projection_camera) add_camera(scene);
    if (!has_light(scene)) add_daylight(scene);
    return scene;
}

/// For a picture of the usual size; whoever knows more about it calls pov::import_pov() itself.
scene::Scene import_pov_scene(const std::filesystem::path& file, const WarningSink& warn) {
    pov::PovOptions options;
    options.library_paths = pov::installed_library_paths();
    return pov::import_pov(file, options, warn);
}

scene::Scene import_default_scene(const std::filesystem::path& file, const WarningSink& warn) {
    const OrbitConfig config = import_orbit_config(file, warn);
    const auto fail = [&](std::string message, std::string hint) {
        fail_file(std::make_shared<const std::string>(file.string()), std::move(message), std::move(hint));
    };
    if (config.default_scene.empty()) fail("missing key 'defaultScene'", "add defaultScene = a scene file");
    const std::filesystem::path scene_file = resolve_path(file, config.default_scene);
    const std::string ending = ending_of(scene_file);
    if (ending != ".scene" && ending != ".obj")
        fail("the defaultScene is of unknown format: '" + config.default_scene + "'", "expected a .scene or .obj file");
    if (!is_file(scene_file))
        fail("missing defaultScene '" + config.default_scene + "'", "looked for " + scene_file.string());
    scene::Scene scene = ending == ".obj" ? import_model(scene_file, warn) : import_orbit_scene(scene_file, warn);
    fill_open_settings(scene.settings, config.settings);
    scene::add_file(scene, file);
    return scene;
}

}  // namespace

scene::Scene import_scene(const std::filesystem::path& file, const WarningSink& warn, const Choices& choices) {
    const std::string ending = ending_of(file);
    if (!choices.variant.empty() && ending != ".gltf" && ending != ".glb")
        fail_file(std::make_shared<const std::string>(file.string()),
                  "there is no variant '" + choices.variant + "': only glTF files have variants");
    if (ending == ".conf") return import_default_scene(file, warn);
    if (ending == ".obj") return import_model(file, warn);
    if (ending == ".gltf" || ending == ".glb") return import_gltf_model(file, warn, choices);
    if (ending == ".pov") return import_pov_scene(file, warn);
    if (ending != ".scene") {
        fail_file(std::make_shared<const std::string>(file.string()), "a scene of unknown format",
                  "expected a .scene, .obj, .gltf, .glb, .pov or .conf file");
    }
    const std::filesystem::path config_file = file.parent_path() / "raytracer.conf";
    if (!is_file(config_file)) return import_orbit_scene(file, warn);
    scene::Scene scene = import_orbit_scene(file, warn);
    fill_open_settings(scene.settings, import_orbit_config(config_file, warn).settings);
    scene::add_file(scene, config_file);
    return scene;
}

}  // namespace sundog::import
