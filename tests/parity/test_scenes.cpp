// SPDX-License-Identifier: Apache-2.0
#include "test_scenes.h"

#include <cmath>

namespace sundog::parity {
namespace {

using scene::Index;
using scene::Scene;

Index add(Scene& scene, const scene::Material& material) {
    scene.materials.push_back(material);
    return static_cast<Index>(scene.materials.size() - 1);
}

scene::Material matt(Vec3 color) {
    scene::Material material;
    material.mtl->diffuse = color;
    return material;
}

scene::Material shiny(Vec3 color, float shininess, bool phong) {
    scene::Material material = matt(color);
    material.mtl->specular = {0.6F, 0.6F, 0.5F};
    material.mtl->shininess = shininess;
    material.mtl->phong_highlight = phong;
    return material;
}

scene::Material mirror(Vec3 reflectance) {
    scene::Material material = matt({0.1F, 0.1F, 0.1F});
    material.mtl->specular = reflectance;
    material.mtl->shininess = 200;
    material.mtl->illum = 3;
    return material;
}

scene::Material glass(float ior) {
    scene::Material material = matt({0, 0, 0});
    material.mtl->specular = {1, 1, 1};
    material.mtl->shininess = 100;
    material.mtl->transmission_filter = {0.9F, 1, 0.9F};
    material.mtl->opacity = 0.1F;
    material.mtl->ior = ior;
    material.mtl->illum = 7;
    return material;
}

/// A wavy square sheet around `center`, smooth-shaded where asked for, with texture coordinates.
scene::Mesh sheet(Vec3 center, float half_size, float wave, int cells, Index material, bool smooth) {
    scene::Mesh mesh;
    const auto place = [&](int i) { return 2 * static_cast<float>(i) / static_cast<float>(cells) - 1; };
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const float x = place(i);
            const float y = place(j);
            mesh.positions.push_back(center +
                                     Vec3{x * half_size, y * half_size, wave * std::sin(5 * x) * std::cos(4 * y)});
            const float dx = wave * 5 * std::cos(5 * x) * std::cos(4 * y) / half_size;
            const float dy = -wave * 4 * std::sin(5 * x) * std::sin(4 * y) / half_size;
            mesh.normals.push_back(normalize(Vec3{-dx, -dy, 1}));
            mesh.texcoords.push_back({(x + 1) / 2, (y + 1) / 2});
        }
    }
    const auto corner = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        scene::Mesh::Triangle t{{a, b, c}, {a, b, c}, {a, b, c}, material};
        if (!smooth) t.normal[0] = t.normal[1] = t.normal[2] = scene::kNone;
        mesh.triangles.push_back(t);
    };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            triangle(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
            triangle(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
    }
    return mesh;
}

template <class Shape>
void put(Scene& scene, const std::string& name, Shape shape, Index material) {
    scene.objects.push_back({name, {}, std::move(shape), material, {}});
}

/// A camera that looks down at the origin, and a lamp and a sun.
Scene stage() {
    Scene scene;
    scene.camera.focus = 18;
    scene.camera.distance = 6;
    scene.camera.rot_x_deg.base = -30;
    scene.camera.rot_z_deg.base = 25;
    scene.ambient = {0.2F, 0.2F, 0.2F};
    scene.sky = {0.3F, 0.4F, 0.6F};
    scene::Light lamp;
    lamp.place = {2, -3, 5};
    lamp.color = {0.7F, 0.7F, 0.6F};
    scene::Light sun;
    sun.kind = scene::Light::Kind::sun;
    sun.place = {-1, -0.3F, 1.5F};
    sun.color = {0.3F, 0.3F, 0.4F};
    scene.lights = {lamp, sun};
    return scene;
}

scene::Texture stripes(bool srgb) {
    scene::Texture texture;
    texture.width = 16;
    texture.height = 8;
    texture.srgb = srgb;
    for (std::uint32_t y = 0; y < texture.height; ++y) {
        for (std::uint32_t x = 0; x < texture.width; ++x) {
            const std::uint32_t alpha = (x / 4 + y / 2) % 2 ? 255 : 60;
            texture.rgba8.push_back(alpha << 24U | (y * 30) << 16U | (x * 16) << 8U | (x % 3 * 100 + 50));
        }
    }
    return texture;
}

Scene matt_triangles() {
    Scene scene = stage();
    const Index red = add(scene, matt({0.8F, 0.2F, 0.1F}));
    const Index blue = add(scene, shiny({0.1F, 0.2F, 0.8F}, 40, false));
    put(scene, "floor", sheet({0, 0, -1}, 3, 0, 1, red, false), red);
    put(scene, "waves", sheet({0, 0, 0}, 1.5F, 0.2F, 24, blue, true), blue);
    return scene;
}

Scene culled() {
    Scene scene = matt_triangles();
    scene.settings.cull_backfaces = true;
    scene.camera.rot_x_deg.base = 15;
    return scene;
}

Scene analytic_shapes() {
    Scene scene = stage();
    put(scene, "ground", scene::Plane{{0, 0, 1}, -1}, add(scene, matt({0.5F, 0.5F, 0.5F})));
    put(scene, "wall", scene::Plane{normalize(Vec3{0.3F, -1, 0.1F}), -4},
        add(scene, shiny({0.3F, 0.6F, 0.3F}, 10, true)));
    put(scene, "ball", scene::Sphere{{-1, 0, 0}, 1}, add(scene, shiny({0.8F, 0.7F, 0.1F}, 60, true)));
    put(scene, "crate", scene::Box{{0.5F, -0.5F, -0.98F}, {1.5F, 0.5F, 0.3F}}, add(scene, matt({0.7F, 0.3F, 0.6F})));
    for (int i = 0; i < 20; ++i) {
        const float angle = static_cast<float>(i) * 0.314F;
        put(scene, "bead", scene::Sphere{{2 * std::cos(angle), 2 * std::sin(angle), -0.8F}, 0.2F},
            add(scene, matt({0.4F, static_cast<float>(i) / 20, 0.5F})));
    }
    return scene;
}

Scene mirrors() {
    Scene scene = analytic_shapes();
    scene.materials[2] = mirror({0.8F, 0.8F, 0.7F});
    scene.materials[3] = mirror({0.5F, 0.6F, 0.9F});
    scene.settings.max_depth = 6;
    return scene;
}

Scene glass_and_shadows() {
    Scene scene = analytic_shapes();
    scene.materials[2] = glass(1.5F);
    scene.materials[3] = glass(1.2F);
    const Index pane = add(scene, glass(1));
    put(scene, "pane", sheet({0, -1.5F, 0.5F}, 0.7F, 0.1F, 6, pane, true), pane);
    scene.settings.max_depth = 8;
    return scene;
}

scene::PigmentEntry entry(float at, scene::PigmentColor color) { return {at, color, nullptr}; }

std::shared_ptr<scene::Pigment> pattern(scene::Pigment::Kind pigment_kind, scene::Pattern::Kind kind,
                                        std::vector<scene::PigmentEntry> entries) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->kind = pigment_kind;
    pigment->pattern.kind = kind;
    pigment->entries = std::move(entries);
    return pigment;
}

scene::Material layers(std::vector<scene::TextureLayer> list, scene::Interior interior = {}) {
    scene::Material material;
    auto texture = std::make_shared<scene::LayeredTexture>();
    texture->layers = std::move(list);
    material.patterned->texture = texture;
    material.patterned->interior = std::make_shared<const scene::Interior>(std::move(interior));
    return material;
}

/// A slope found by differences and one by formula, chosen by squares.
std::shared_ptr<const scene::Normal> bent_normal() {
    using Kind = scene::Pattern::Kind;
    auto normal = std::make_shared<scene::Normal>();
    for (std::size_t i = 0; i < 2; ++i) {
        scene::PatternNormal& part = normal->parts.emplace_back();
        part.kind = i == 0 ? scene::PatternNormal::Kind::pattern : scene::PatternNormal::Kind::ripples;
        if (i == 0)
            part.height = pattern(scene::Pigment::Kind::mapped, Kind::onion,
                                  {entry(0, {0, 0, 0, 0, 0}), entry(1, {1, 1, 1, 0, 0})});
        part.pattern.pattern_from_texture.x = {2, 0.5, 0};
        part.pattern.turbulence = {0.1, 0, 0};
        part.weight =
            pattern(scene::Pigment::Kind::choice, Kind::checker,
                    {entry(0, {i == 0 ? 1.0F : 0.0F, 0, 0, 0, 0}), entry(0, {i == 1 ? 1.0F : 0.0F, 0, 0, 0, 0})});
    }
    return normal;
}

/// Patterns with and without noise, layers, glass that fades, shaped lights, fog and sky.
Scene procedural() {
    using scene::Pattern;
    using scene::Pigment;
    Scene scene = analytic_shapes();
    scene.textures = {stripes(true)};
    scene::Finish finish;
    finish.specular = 0.5F;
    finish.brilliance = 1.5F;
    finish.reflection_max = {0.4F, 0.4F, 0.4F};
    const auto stone = pattern(Pigment::Kind::mapped, Pattern::Kind::granite,
                               {entry(0, {0.2F, 0.1F, 0.1F, 0, 0}), entry(1, {0.9F, 0.8F, 0.7F, 0, 0})});
    const auto waves = pattern(Pigment::Kind::mapped, Pattern::Kind::wood,
                               {entry(0, {0.6F, 0.3F, 0.1F, 0, 0}), entry(0.8F, {0.8F, 0.6F, 0.3F, 0, 0})});
    waves->pattern.turbulence = {0.2, 0.2, 0.2};
    const auto bricks =
        pattern(Pigment::Kind::choice, Pattern::Kind::brick, {entry(0, {0.7F, 0.7F, 0.7F, 0, 0}), {0, {}, stone}});
    bricks->pattern.brick_size = {0.8, 0.4, 0.4};
    bricks->pattern.mortar = 0.05;
    const auto veil = pattern(Pigment::Kind::mapped, Pattern::Kind::gradient,
                              {entry(0, {1, 1, 1, 0, 1}), entry(1, {0.2F, 0.3F, 0.9F, 0.3F, 0.2F})});
    const auto glass_color = pattern(Pigment::Kind::choice, Pattern::Kind::checker,
                                     {entry(0, {0.9F, 1, 0.9F, 0.9F, 0}), entry(0, {1, 0.8F, 0.8F, 0.8F, 0})});
    const auto picture = std::make_shared<Pigment>();
    picture->kind = Pigment::Kind::image;
    picture->image.smooth = true;
    scene.materials[0] = layers({{bricks, finish, bent_normal()}});
    scene.materials[1] = layers({{waves, finish}, {veil, {}, bent_normal()}});
    scene::Interior interior;
    interior.ior = 1.4F;
    interior.fade_distance = 1;
    interior.fade_power = 2;
    interior.fade_color = {0.1F, 0.3F, 0.1F};
    scene.materials[2] = layers({{glass_color, finish}}, interior);
    scene.materials[3] = layers({{picture, finish}});
    const auto tiles = pattern(Pigment::Kind::mapped, Pattern::Kind::tiling,
                               {entry(0, {0.1F, 0.2F, 0.5F, 0, 0}), entry(1, {0.9F, 0.8F, 0.6F, 0, 0})});
    tiles->pattern.tiling = 16;
    tiles->pattern.pattern_from_texture = {{8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {}};
    put(scene, "tiled bead", scene::Sphere{{0.1F, -0.9F, 0.5F}, 0.3F}, add(scene, layers({{tiles, finish}})));
    // One texture, and a colour for each surface.
    const scene::Material plain = layers({{std::make_shared<Pigment>(), finish}});
    for (const scene::PigmentColor& color :
         {scene::PigmentColor{0.9F, 0.3F, 0.1F, 0, 0}, {0.3F, 0.9F, 0.9F, 0.7F, 0}}) {
        const Index index = add(scene, plain);
        scene.materials[index].patterned->color = color;
        put(scene, "bead", scene::Sphere{{color.r - 0.5F, -0.9F, color.g - 0.8F}, 0.25F}, index);
    }
    scene.lights[0].kind = scene::Light::Kind::spotlight;
    scene.lights[0].point_at = {0, 0, -0.5F};
    scene.lights[0].area = scene::LightArea{{0.5F, 0, 0}, {0, 0.5F, 0}, 3, 2, -1, false, true, true};
    scene.lights[1].fade_distance = 2;
    scene.lights[1].fade_power = 1;
    scene::Fog fog;
    fog.ground = true;
    fog.distance = 6;
    fog.altitude = 0.5F;
    fog.offset = -0.5F;
    fog.up = {0, 0, 1};
    fog.color = {0.6F, 0.6F, 0.7F, 0.2F, 0.1F};
    scene.fogs.push_back(fog);
    scene::SkySphere sky;
    sky.pigments.push_back(pattern(Pigment::Kind::mapped, Pattern::Kind::bozo,
                                   {entry(0.3F, {0.2F, 0.3F, 0.8F, 0, 0}), entry(0.7F, {1, 1, 1, 0, 0})}));
    scene.sky_spheres.push_back(sky);
    scene.objects[2].seen_in_reflections = false;
    scene.settings.max_depth = 5;
    return scene;
}

Scene textured() {
    Scene scene = stage();
    scene.textures = {stripes(true), stripes(false)};
    scene::Material cloth = matt({1, 1, 1});
    cloth.mtl->map_diffuse.texture = 0;
    cloth.mtl->map_diffuse.scale = {3, 2};
    scene::Material bumpy = shiny({0.6F, 0.6F, 0.2F}, 30, false);
    bumpy.mtl->map_bump.texture = 1;
    bumpy.mtl->map_bump.strength = 0.3F;
    bumpy.mtl->map_specular.texture = 0;
    scene::Material cutout = matt({0.3F, 0.8F, 0.4F});
    cutout.mtl->map_opacity.texture = 1;
    cutout.mtl->map_opacity.channel = 3;
    scene::Material board = matt({0.9F, 0.9F, 0.9F});
    board.mtl->checker = scene::Checker{1, 1, {0.1F, 0.1F, 0.3F}};
    const Index cloth_index = add(scene, cloth);
    const Index bumpy_index = add(scene, bumpy);
    const Index cutout_index = add(scene, cutout);
    const Index board_index = add(scene, board);
    put(scene, "board", scene::Plane{{0, 0, 1}, -1}, board_index);
    put(scene, "cloth", sheet({-1, 0, 0}, 0.9F, 0.15F, 12, cloth_index, true), cloth_index);
    put(scene, "bumpy", sheet({1, 0, -0.2F}, 0.9F, 0, 2, bumpy_index, true), bumpy_index);
    put(scene, "cutout", sheet({0, -1.2F, 0.8F}, 0.6F, 0, 1, cutout_index, false), cutout_index);
    put(scene, "globe", scene::Sphere{{0, 1.6F, 0}, 0.8F}, cloth_index);
    put(scene, "crate", scene::Box{{1.8F, 0.8F, -1}, {2.6F, 1.6F, -0.2F}}, cloth_index);
    return scene;
}

Scene moving() {
    Scene scene = mirrors();
    const auto turn = [&](std::size_t object, Vec3 center, float degrees, Vec3 amplitude) {
        scene::ObjectMotion motion;
        motion.center = center;
        motion.rot_z_deg = {scene::Motion::Kind::linear, 0, degrees, 0};
        motion.rot_x_deg.base = 20;
        motion.move_speed = {1, 2, 3};
        motion.move_amplitude = amplitude;
        scene.objects[object].motion = motion;
    };
    turn(1, {0, 4, 0}, 3, {0, 0, 0});
    turn(2, {-1, 0, 0}, 40, {0.2F, 0.2F, 0.4F});
    turn(3, {1, 0, 0}, 50, {0, 0, 0.3F});
    const Index cloth = add(scene, matt({0.7F, 0.7F, 0.2F}));
    put(scene, "flag", sheet({0, -1.5F, 0.5F}, 0.6F, 0.1F, 10, cloth, true), cloth);
    turn(scene.objects.size() - 1, {0, -1.5F, 0.5F}, 30, {0.1F, 0, 0});
    return scene;
}

Scene far_clipped() {
    Scene scene = analytic_shapes();
    scene.settings.far_z = 6;
    return scene;
}

/// Ten thousand times the same triangle, and one in front of them.
Scene identical_triangles() {
    Scene scene = stage();
    const Index grey = add(scene, matt({0.6F, 0.6F, 0.6F}));
    const Index red = add(scene, matt({0.9F, 0.1F, 0.1F}));
    scene::Mesh mesh = sheet({0, 0, 0}, 1, 0, 1, grey, false);
    mesh.triangles.resize(1);
    mesh.triangles.resize(10000, mesh.triangles[0]);
    put(scene, "pile", mesh, grey);
    put(scene, "cover", sheet({0.3F, -0.3F, 0.2F}, 0.4F, 0, 1, red, false), red);
    return scene;
}

Scene nothing() {
    Scene scene = stage();
    add(scene, matt({1, 1, 1}));
    return scene;
}

}  // namespace

std::vector<TestScene> test_scenes() {
    return {{"matt triangles", matt_triangles()},
            {"back faces culled", culled()},
            {"analytic shapes", analytic_shapes()},
            {"mirrors", mirrors()},
            {"glass", glass_and_shadows()},
            {"textures", textured()},
            {"procedural", procedural()},
            {"moving objects", moving(), 0.7F},
            {"far clip", far_clipped()},
            {"identical triangles", identical_triangles()},
            {"nothing but sky", nothing()}};
}

}  // namespace sundog::parity
