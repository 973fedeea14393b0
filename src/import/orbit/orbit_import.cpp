// SPDX-License-Identifier: Apache-2.0
#include "import/orbit/orbit_import.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <deque>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/paths.h"
#include "import/obj/obj_import.h"
#include "import/orbit/object_motion.h"
#include "import/orbit/orbit_keys.h"
#include "import/orbit/orbit_values.h"
#include "scene/files.h"
#include "scene/stand_in.h"

namespace sundog::import {
namespace {

using scene::Index;

constexpr std::array<std::string_view, 28> kSceneKeys = {
    "model",         "focus",      "rotX",           "rotZ",        "distance",    "origin",        "light",
    "lightPos",      "lightSpeed", "lightAmplitude", "lightColor",  "lightShadow", "sky",           "ambient",
    "cullBackfaces", "mtllib",     "sphere",         "box",         "plane",       "motion",        "width",
    "height",        "fullscreen", "freeze",         "maxRayDepth", "shadow",      "reflThreshold", "farZ"};

constexpr std::string_view kLightForm = "light = lamp or sun, then const or wave";

/// A key that a .scene must have, and how it is written.
struct MandatoryKey {
    std::string_view key, form;
};
constexpr std::array<MandatoryKey, 5> kMandatory = {{
    {"focus", "focus = <length; 12 sees 90 degrees high>"},
    {"rotX", "rotX = const <degrees>"},
    {"rotZ", "rotZ = const <degrees>, or linear <degrees per second>"},
    {"distance", "distance = <how far the eye stands from origin>"},
    {"origin", "origin = <x y z>"},
}};

/// A light being read: `light` and the keys that belong to it.
struct LightBlock {
    explicit LightBlock(const LineCursor& first_line) : begin(first_line) {}
    LineCursor begin;  ///< The line `light = …`, or the block's first line until that comes.
    const char* begin_at = nullptr;
    scene::Light light;
    KeyBook keys;
};

/// A shape's line, whose material can only be looked up when all libraries are read.
struct PendingMaterial {
    std::size_t object;
    std::string_view name;
    LineCursor line;
};

/// A file that the scene names.
struct NamedFile {
    std::string_view name;
    LineCursor line;
};

class SceneReader {
public:
    SceneReader(const std::filesystem::path& file, const WarningSink& warn)
        : file_(file), source_(read_text_file(file)), warn_(warn) {
        scene_.name = file.stem().string();
        scene::add_file(scene_, file);
    }

    scene::Scene run() {
        OrbitLineReader lines(source_);
        while (std::optional<OrbitLine> line = lines.next(kSceneKeys)) read_line(line->key, line->value);
        check_complete();
        finish_lights();
        std::vector<scene::Object> shapes = std::move(scene_.objects);
        scene_.objects.clear();
        for (const NamedFile& model : models_) load_model(model);
        for (const NamedFile& library : libraries_) load_library(library);
        const std::size_t first_shape = scene_.objects.size();
        std::move(shapes.begin(), shapes.end(), std::back_inserter(scene_.objects));
        for (const PendingMaterial& pending : shape_materials_)
            scene_.objects[first_shape + pending.object].material = material_named(pending);
        for (const MotionLine& motion : motions_) apply_motion(motion, scene_.objects);
        set_motion_centers(scene_.objects, motions_);
        if (scene_.materials.empty()) scene_.materials.emplace_back().name = "default";
        return std::move(scene_);
    }

private:
    void warn(const Diagnostic& diagnostic) const {
        if (warn_) warn_(diagnostic);
    }

    void read_line(std::string_view key, LineCursor& value) {
        if (key == "model") return named_file(value, "model = an .obj file", models_);
        if (key == "mtllib") return named_file(value, "mtllib = an .mtl file", libraries_);
        if (key == "sphere" || key == "box" || key == "plane") return shape(key, value);
        if (key == "motion") return motion_line(value);
        if (key.starts_with("light")) return light_line(key, value);
        const bool known = std::find(kSceneKeys.begin(), kSceneKeys.end(), key) != kSceneKeys.end();
        if (!known) value.fail(key.data(), "unknown key " + in_quotes(key), suggest(key, kSceneKeys));
        keys_.enter(key, value);
        if (!read_setting(key, value, scene_.settings)) camera_or_surroundings(key, value);
    }

    void camera_or_surroundings(std::string_view key, LineCursor& value) {
        scene::OrbitCamera& camera = scene_.camera;
        if (camera.where.line == 0) camera.where = value.location(key.data());
        if (key == "focus") camera.focus = read_positive(value, "focus = a number greater than 0");
        else if (key == "rotX")
            camera.rot_x_deg = read_motion(value, "rotX = const <deg>, or wave <speed> <deg> <amplitude>", false);
        else if (key == "rotZ")
            camera.rot_z_deg =
                read_motion(value, "rotZ = const <deg>, wave <speed> <deg> <amplitude> or linear <speed>", true);
        else if (key == "distance") camera.distance = read_float(value, "distance = a number");
        else if (key == "origin") camera.origin = read_vec3(value, "origin = x y z");
        else if (key == "sky") scene_.sky = read_color(value, "sky = r g b, numbers of 0 or more");
        else if (key == "ambient") scene_.ambient = read_color(value, "ambient = r g b, numbers of 0 or more");
        else scene_.settings.cull_backfaces = read_bool(value, "cullBackfaces = true or false");
    }

    void motion_line(LineCursor& value) {
        MotionLine motion = read_motion_line(value);
        if (!motions_seen_.emplace(motion.object, motion.kind).second)
            value.fail(motion.object.data(), "the same motion of " + in_quotes(motion.object) + " is given twice");
        motions_.push_back(motion);
    }

    static void named_file(LineCursor& value, std::string_view form, std::vector<NamedFile>& files) {
        const LineCursor line = value;
        files.push_back({value.rest(form), line});
    }

    void light_line(std::string_view key, LineCursor& value) {
        if (std::find(kSceneKeys.begin(), kSceneKeys.end(), key) == kSceneKeys.end())
            value.fail(key.data(), "unknown key " + in_quotes(key), suggest(key, kSceneKeys));
        // The keys of the first light may come before its `light`: the order of lines means nothing in old files.
        const bool begins = lights_.empty() || (key == "light" && lights_.back().keys.has("light"));
        if (begins) lights_.emplace_back(value).begin_at = key.data();
        LightBlock& block = lights_.back();
        block.keys.enter(key, value);
        scene::Light& light = block.light;
        if (key == "lightPos") light.place = read_vec3(value, "lightPos = x y z");
        else if (key == "lightSpeed") light.speed = read_vec3(value, "lightSpeed = x y z");
        else if (key == "lightAmplitude") light.amplitude = read_vec3(value, "lightAmplitude = x y z");
        else if (key == "lightColor") light.color = read_color(value, "lightColor = r g b, numbers of 0 or more");
        else if (key == "lightShadow") light.shadows = read_bool(value, "lightShadow = true or false");
        else light_kind(block, key, value);
    }

    static void light_kind(LightBlock& block, std::string_view key, LineCursor& value) {
        constexpr std::array<std::string_view, 2> kKinds = {"lamp", "sun"};
        constexpr std::array<std::string_view, 2> kMotions = {"const", "wave"};
        block.begin = value;
        block.begin_at = key.data();
        block.light.where = value.location(key.data());
        const char* at = value.here();
        const std::string_view kind = value.token(kLightForm);
        if (kind != "lamp" && kind != "sun") value.fail(at, "unknown light " + in_quotes(kind), suggest(kind, kKinds));
        block.light.kind = kind == "sun" ? scene::Light::Kind::sun : scene::Light::Kind::lamp;
        at = value.here();
        const std::string_view motion = value.token(kLightForm);
        if (motion != "const" && motion != "wave")
            value.fail(at, "unknown motion " + in_quotes(motion), suggest(motion, kMotions));
        block.light.moving = motion == "wave";
        value.expect_end(kLightForm);
    }

    void finish_lights() {
        for (LightBlock& block : lights_) {
            const auto need = [&](std::string_view key, std::string_view form) {
                if (!block.keys.has(key))
                    block.begin.fail(block.begin_at, "the light that starts here has no " + in_quotes(key),
                                     "add " + std::string(form));
            };
            need("light", kLightForm);
            need("lightPos", "lightPos = x y z");
            if (block.light.moving) {
                need("lightSpeed", "lightSpeed = x y z: it is needed with wave");
                need("lightAmplitude", "lightAmplitude = x y z: it is needed with wave");
            }
            if (block.light.kind == scene::Light::Kind::sun && !block.light.moving && block.light.place == Vec3{})
                block.begin.fail(block.begin_at, "the sun that starts here has no direction",
                                 "lightPos is the direction to the sun and can't be 0 0 0");
            scene_.lights.push_back(std::move(block.light));
        }
    }

    void check_complete() const {
        const auto missing = [&](std::string_view key, std::string hint) {
            fail_file(source_.name, "missing key " + in_quotes(key), std::move(hint));
        };
        if (models_.empty() && scene_.objects.empty())
            missing("model", "add model = an .obj file (or a sphere, box or plane)");
        for (const MandatoryKey& mandatory : kMandatory)
            if (!keys_.has(mandatory.key)) missing(mandatory.key, "add " + std::string(mandatory.form));
        if (lights_.empty()) missing("light", "add " + std::string(kLightForm) + ", and lightPos = x y z");
    }

    void shape(std::string_view kind, LineCursor& value) {
        scene::Object object;
        object.where = value.location(kind.data());
        const LineCursor line = value;
        const std::string_view form = kind == "sphere" ? "sphere = name material x y z radius"
                                      : kind == "box" ? "box = name material x y z x y z, lower corner and upper corner"
                                                      : "plane = name material nx ny nz offset";
        object.name = value.name(form);
        const std::string_view material = value.name(form);
        const char* const at = value.here();
        const Vec3 first = take_vec3(value, form);
        if (kind == "sphere") {
            const char* const radius_at = value.here();
            const scene::Sphere sphere{first, value.number(form)};
            if (!(sphere.radius > 0)) value.fail(radius_at, "the radius must be greater than 0");
            object.shape = sphere;
        } else if (kind == "box") {
            const char* const upper_at = value.here();
            const scene::Box box{first, take_vec3(value, form)};
            if (!(box.lower.x < box.upper.x && box.lower.y < box.upper.y && box.lower.z < box.upper.z))
                value.fail(upper_at, "the upper corner must lie above the lower one in x, y and z");
            object.shape = box;
        } else {
            const Vec3 normal = normalize(first);
            if (std::abs(length(normal) - 1) > 1e-3F)
                value.fail(at, "the normal has no direction", "expected 0 0 1 or the like");
            object.shape = scene::Plane{normal, value.number(form)};
        }
        value.expect_end(form);
        shape_materials_.push_back({scene_.objects.size(), material, line});
        scene_.objects.push_back(std::move(object));
    }

    void load_model(const NamedFile& model) {
        const std::filesystem::path path = resolve_path(file_, model.name);
        std::string ending = path.extension().string();
        for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        if (ending != ".obj")
            model.line.fail(model.name.data(), "a model of unknown format: " + in_quotes(model.name),
                            "expected an .obj file");
        if (!is_file(path))
            model.line.fail(model.name.data(), "missing model " + in_quotes(model.name), "looked for " + path.string());
        import_obj(path, scene_, warn_);
    }

    void load_library(const NamedFile& library) {
        const std::filesystem::path path = find_file(file_, library.name);
        if (path.empty()) {
            warn(library.line.warning(library.name.data(), "missing material library " + in_quotes(library.name),
                                      "its materials are shown in magenta"));
            return;
        }
        if (!scene::has_file(scene_, path)) import_mtl(path, scene_, warn_);
    }

    Index material_named(const PendingMaterial& pending) {
        const auto find = [&] {
            return std::find_if(scene_.materials.begin(), scene_.materials.end(),
                                [&](const scene::Material& m) { return m.name == pending.name; });
        };
        auto it = find();
        if (it == scene_.materials.end()) {
            // A hostile file may ask for very many: bound the search for near names.
            constexpr std::size_t kMostSearched = 1000;
            std::vector<std::string_view> names;
            for (const scene::Material& m : scene_.materials)
                if (names.size() < kMostSearched) names.push_back(m.name);
            const bool has_near = !nearest_names(pending.name, names, 1).empty();
            warn(pending.line.warning(pending.name.data(), "missing material " + in_quotes(pending.name),
                                      has_near ? suggest(pending.name, names) : "it is shown in magenta"));
            scene_.materials.push_back(
                scene::missing_material(std::string(pending.name), pending.line.location(pending.name.data())));
            it = scene_.materials.end() - 1;
        }
        return static_cast<Index>(it - scene_.materials.begin());
    }

    const std::filesystem::path& file_;
    SourceText source_;
    const WarningSink& warn_;
    scene::Scene scene_;
    KeyBook keys_;
    std::vector<NamedFile> models_, libraries_;
    std::deque<LightBlock> lights_;
    std::vector<PendingMaterial> shape_materials_;
    std::vector<MotionLine> motions_;
    std::set<std::pair<std::string_view, MotionLine::Kind>> motions_seen_;
};

}  // namespace

OrbitConfig import_orbit_config(const std::filesystem::path& file, const WarningSink&) {
    constexpr std::array<std::string_view, 1> kDefaultScene = {"defaultScene"};
    std::vector<std::string_view> valid(kDefaultScene.begin(), kDefaultScene.end());
    valid.insert(valid.end(), kSettingKeys.begin(), kSettingKeys.end());
    const SourceText source = read_text_file(file);
    OrbitConfig config;
    KeyBook keys;
    OrbitLineReader lines(source);
    while (std::optional<OrbitLine> line = lines.next(valid)) {
        keys.enter(line->key, line->value);
        if (line->key == "defaultScene") config.default_scene = line->value.rest("defaultScene = a scene file");
        else if (!read_setting(line->key, line->value, config.settings))
            line->value.fail(line->key.data(), "unknown key " + in_quotes(line->key), suggest(line->key, valid));
    }
    return config;
}

scene::Scene import_orbit_scene(const std::filesystem::path& file, const WarningSink& warn) {
    return SceneReader(file, warn).run();
}

}  // namespace sundog::import
