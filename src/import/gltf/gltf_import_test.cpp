// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/gltf_import.h"

#include <gtest/gtest.h>

#include "import/gltf/gltf_test_file.h"
#include "scene/bounds.h"
#include "scene/deformation.h"
#include "scene/validate.h"

namespace sundog::import::gltf {
namespace {

scene::Scene gallery(const char* name) {
    const std::filesystem::path file = std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / "gltf" / name;
    scene::Scene scene = import_gltf(file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); });
    scene::validate(scene);
    return scene;
}

const scene::Mesh& mesh_of(const scene::Object& object) { return *std::get<Boxed<scene::Mesh>>(object.shape); }

void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-4F) {
    EXPECT_LT(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

// Catches Y that stays up, positions that are mixed up, and materials that get lost.
TEST(GltfImport, Triangle) {
    const scene::Scene scene = import_text(triangle_gltf());
    ASSERT_EQ(scene.objects.size(), 1U);
    const scene::Mesh& mesh = mesh_of(scene.objects[0]);
    ASSERT_EQ(mesh.positions.size(), 3U);
    EXPECT_EQ(mesh.positions[2], (Vec3{0, 0, 1}));
    ASSERT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.triangles[0].position[1], 1U);
    EXPECT_EQ(mesh.triangles[0].normal[0], scene::kNone);
    EXPECT_EQ(scene.materials[0].principled->base_color, (Vec3{1, 0, 0}));
    EXPECT_EQ(scene.materials[0].name, "red");
    EXPECT_EQ(scene.materials[0].where.line, 7U);
    EXPECT_EQ(scene.objects[0].where.line, 9U);
    EXPECT_FALSE(scene::is_animated(scene));
}

// Catches strips whose triangles all face one way in the list but not in space, and fans around the wrong vertex.
TEST(GltfImport, StripsAndFans) {
    const auto corners = [](const char* mode) {
        std::string text =
            replaced(triangle_gltf(), "\"indices\": 1", std::string("\"mode\": ") + mode + ", \"indices\": 1");
        text = replaced(text, base64(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2})),
                        base64(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2, 0})));
        text = replaced(text, "\"byteLength\": 42", "\"byteLength\": 44");
        text = replaced(text, "\"byteLength\": 6", "\"byteLength\": 8");
        text = replaced(text, "\"count\": 3, \"type\": \"SCALAR\"", "\"count\": 4, \"type\": \"SCALAR\"");
        std::string all;
        const scene::Scene scene = import_text(text);
        for (const scene::Mesh::Triangle& t : mesh_of(scene.objects[0]).triangles)
            for (const std::uint32_t p : t.position) all += static_cast<char>('0' + p);
        return all;
    };
    EXPECT_EQ(corners("4"), "012");
    EXPECT_EQ(corners("5"), "012102");
    EXPECT_EQ(corners("6"), "120200");
}

// Catches maps that mirror and leave the triangles inside out, and parents that don't carry their children.
TEST(GltfImport, NodesAreFlattened) {
    const std::string text =
        replaced(triangle_gltf(), "{\"mesh\": 0}",
                 R"({"translation": [0, 5, 0], "children": [1]}, {"mesh": 0, "name": "here", "scale": [-2, 1, 1]})");
    const scene::Scene scene = import_text(text);
    ASSERT_EQ(scene.objects.size(), 1U);
    EXPECT_EQ(scene.objects[0].name, "here");
    const scene::Mesh& mesh = mesh_of(scene.objects[0]);
    expect_near(mesh.positions[1], {-2, 0, 5});
    EXPECT_EQ(mesh.triangles[0].position[1], 2U);
}

// Catches transforms of textures that go astray between glTF's v, which points down, and ours.
TEST(GltfImport, TextureTransforms) {
    const scene::Scene scene = gallery("textured.glb");
    const scene::TextureUse& turned = scene.materials[0].principled->base_color_map;
    const auto at = [&](float u, float v_down) {
        const float v = 1 - v_down;
        return Vec3{u * turned.scale.x + v * turned.shear.x + turned.offset.x,
                    1 - (v * turned.scale.y + u * turned.shear.y + turned.offset.y), 0};
    };
    // Offset (0, 1), a quarter turn, scale 2: u' = 2v, v' = 1 - 2u.
    expect_near(at(0, 0), {0, 1, 0});
    expect_near(at(1, 0), {0, -1, 0});
    expect_near(at(0, 1), {2, 1, 0});
    EXPECT_TRUE(turned.nearest);
    const scene::TextureUse& mirrored = scene.materials[1].principled->base_color_map;
    EXPECT_EQ(mirrored.wrap_u, scene::TextureUse::Wrap::mirror);
    EXPECT_EQ(mirrored.wrap_v, scene::TextureUse::Wrap::clamp);
    EXPECT_FALSE(mirrored.nearest);
    ASSERT_EQ(scene.textures.size(), 2U);
    EXPECT_EQ(scene.textures[0].width, 8U);
}

// Catches factors, modes and extensions of materials that don't arrive.
TEST(GltfImport, Materials) {
    const scene::Scene spheres = gallery("spheres.gltf");
    ASSERT_EQ(spheres.materials.size(), 11U);
    EXPECT_EQ(spheres.materials[1].principled->metallic, 1);
    EXPECT_EQ(spheres.materials[1].principled->roughness, 0.25F);
    EXPECT_EQ(spheres.materials[6].principled->metallic, 0);
    const scene::Scene alpha = gallery("alpha.gltf");
    using Alpha = scene::PrincipledSurface::Alpha;
    EXPECT_EQ(alpha.materials[0].principled->alpha_mode, Alpha::opaque);
    EXPECT_EQ(alpha.materials[1].principled->alpha_mode, Alpha::mask);
    EXPECT_EQ(alpha.materials[2].principled->alpha_mode, Alpha::blend);
    EXPECT_EQ(alpha.materials[3].principled->alpha, 0.5F);
    const scene::Scene glass = gallery("glass.gltf");
    EXPECT_EQ(glass.materials[0].principled->transmission, 1);
    EXPECT_EQ(glass.materials[0].principled->ior, 1.45F);
    EXPECT_EQ(glass.materials[0].principled->attenuation_color, (Vec3{0.6F, 0.95F, 0.8F}));
    EXPECT_TRUE(glass.materials[1].principled->double_sided);
    EXPECT_EQ(glass.materials[2].principled->clearcoat, 1);
    const scene::Scene normal = gallery("normal.gltf");
    EXPECT_NE(normal.materials[0].principled->normal_map.texture, scene::kNone);
    EXPECT_FALSE(normal.textures[0].srgb);
}

// Catches lights in the wrong unit or place, and emission without its strength.
TEST(GltfImport, LightsAndCamera) {
    const scene::Scene scene = gallery("lights.gltf");
    ASSERT_EQ(scene.lights.size(), 3U);
    const scene::Light& point = scene.lights[0];
    EXPECT_EQ(point.kind, scene::Light::Kind::lamp);
    expect_near(point.place, {-1.5F, -0.6F, 1.1F});
    expect_near(point.color, Vec3{1, 0.5F, 0.2F} * (3 / kPi));
    EXPECT_EQ(point.fade_power, 2);
    const scene::Light& spot = scene.lights[1];
    EXPECT_EQ(spot.kind, scene::Light::Kind::spotlight);
    EXPECT_NEAR(spot.falloff, 20.0535F, 1e-3F);
    expect_near(normalize(spot.point_at - spot.place), {0, 0.30902F, -0.95106F}, 1e-3F);
    const scene::Light& sun = scene.lights[2];
    EXPECT_EQ(sun.kind, scene::Light::Kind::sun);
    EXPECT_GT(sun.place.z, 0);
    expect_near(sun.color, Vec3{1, 1, 1} * (0.6F / kPi));
    expect_near(scene.materials[2].principled->emission, {3, 1.5F, 0.6F});
    EXPECT_TRUE(scene.materials[3].principled->unlit);
    ASSERT_TRUE(scene.projection_camera.has_value());
    expect_near(to_float(scene.projection_camera->location), {0, -4.6F, 2.2F});
    EXPECT_EQ(scene.settings.width, 853);
    EXPECT_TRUE(scene.projection_camera->fits_picture);
}

// Catches instances that are left out or all put in one place.
TEST(GltfImport, Instances) {
    const scene::Scene scene = gallery("instances.gltf");
    ASSERT_EQ(scene.objects.size(), 60U);
    const Bounds3 first = scene::bounds_of(scene.objects[0]);
    expect_near(first.center(), {2, 0, 0});
    EXPECT_NEAR(first.extent().z, 0.24F, 1e-4F);
    expect_near(scene::bounds_of(scene.objects[15]).center(), {0, -2, -0.5F});
}

// Catches integers that are not normalised, strides that are not kept, and sparse elements that are left out.
TEST(GltfImport, QuantizedAndSparse) {
    const scene::Scene scene = gallery("quantized.gltf");
    const Bounds3 bounds = scene::bounds_of(scene);
    expect_near(bounds.lower, {-1.2207F, -1.2207F, -1.2207F}, 1e-3F);
    EXPECT_NEAR(bounds.upper.z, 1.5F * 1.2207F, 1e-3F);
    const scene::Mesh& mesh = mesh_of(scene.objects[0]);
    EXPECT_NEAR(length(mesh.normals[40]), 1, 1e-5F);
    EXPECT_EQ(mesh.texcoords.front(), (Vec2{0, 1}));
}

// Catches animations that don't play, or play in the file's space.
TEST(GltfImport, Animations) {
    const scene::Scene scene = gallery("animated.gltf");
    ASSERT_EQ(scene.objects.size(), 4U);
    EXPECT_TRUE(scene::is_animated(scene));
    const auto center_at = [&](const char* name, float time_s) {
        for (const scene::Object& object : scene.objects)
            if (object.name == name) return transform_point(scene::transform_at(object, time_s), {0, 0, 0});
        return Vec3{};
    };
    EXPECT_FALSE(scene::moves(scene.objects[0]));
    expect_near(center_at("rod", 0), {0.8F, 0, 0.5F});
    expect_near(center_at("rod", 0.5F), {0, 0.8F, 0.5F});
    expect_near(center_at("rod", 0.25F), {0.56569F, 0.56569F, 0.5F});
    expect_near(center_at("hand", 1), {-1.6F, 0, 0.9F});
    expect_near(center_at("ball", 0.49F), {-1.5F, -0.5F, 0.25F});
    expect_near(center_at("ball", 0.5F), {-1.5F, -0.5F, 1});
    expect_near(center_at("ball", 2.5F), {-1.5F, -0.5F, 1});
}

// Catches skins that leave their place, and morph targets without weights.
TEST(GltfImport, SkinsAndMorphTargets) {
    scene::Scene scene = gallery("bent.gltf");
    ASSERT_EQ(scene.objects.size(), 3U);
    ASSERT_TRUE(scene::is_deforming(scene));
    const auto box = [&](const char* name) {
        for (const scene::Object& object : scene.objects)
            if (object.name == name) return scene::bounds_of(object);
        return Bounds3{};
    };
    expect_near(box("bar").upper, {0.2F, 0.2F, 2});
    expect_near(box("puff").upper, {0.4F, 0.4F, 0.4F});
    scene::deform(scene, 1);
    // Bent by 80 degrees to the left, around (0, 0, 1): its top comes down.
    EXPECT_LT(box("bar").upper.z, 1.45F);
    EXPECT_LT(box("bar").lower.x, -0.9F);
    EXPECT_NEAR(box("puff").upper.x, 0.55F, 1e-3F);
}

// Catches colours of bytes that are not normalised, alpha that is lost, and meshes without texture coordinates whose
// colours belong to other vertices.
TEST(GltfImport, ColorsOfVertices) {
    const scene::Scene scene = gallery("colors.gltf");
    const scene::Mesh& ball = mesh_of(scene.objects.at(0));
    ASSERT_EQ(ball.attributes.size(), ball.texcoords.size());
    expect_near(ball.attributes[0].color, {1, 0.25F, 0.25F}, 1e-4F);
    const scene::Mesh& block = mesh_of(scene.objects.at(1));
    EXPECT_LE(block.attributes[0].color.x, 1);
    EXPECT_EQ(block.attributes[0].alpha, 1);
    const scene::Mesh& pane = mesh_of(scene.objects.at(4));
    EXPECT_EQ(pane.attributes[0].alpha, 0);
    EXPECT_EQ(pane.attributes[1].alpha, 1);
    std::string text = replaced(triangle_gltf(), R"("POSITION": 0)", R"("POSITION": 0, "COLOR_0": 0)");
    const scene::Scene bare = import_text(text);
    const scene::Mesh& mesh = mesh_of(bare.objects.at(0));
    ASSERT_EQ(mesh.attributes.size(), 3U);
    EXPECT_EQ(mesh.triangles[0].texcoord[1], 1U);
    EXPECT_EQ(mesh.attributes[1].color, (Vec3{1, 0, 0}));
}

// Catches maps that go by another set than their `texCoord`, or their transform's, names.
TEST(GltfImport, TwoSetsOfTextureCoordinates) {
    const scene::Scene scene = gallery("uv_sets.gltf");
    const scene::PrincipledSurface& s = *scene.materials.at(0).principled;
    EXPECT_EQ(s.base_color_map.uv_set, 0);
    EXPECT_EQ(s.emission_map.uv_set, 1);
    EXPECT_EQ(s.occlusion_map.uv_set, 1);
    const scene::Mesh& wall = mesh_of(scene.objects.at(0));
    EXPECT_EQ(wall.texcoords[1].x, 3);
    EXPECT_EQ(wall.attributes.at(1).second_texcoord, (Vec2{1, 0}));
}

// Catches tangents that stay behind when their mesh is turned, and hands that a mirror image doesn't change.
TEST(GltfImport, Tangents) {
    const scene::Scene scene = gallery("tangents.gltf");
    EXPECT_TRUE(mesh_of(scene.objects.at(0)).attributes.empty());
    const auto first = [&](std::size_t object) { return mesh_of(scene.objects.at(object)).attributes.at(0); };
    expect_near(first(1).tangent, {1, 0, 0});
    expect_near(first(2).tangent, {0, 0, -1});  // The file's Y is up.
    EXPECT_EQ(first(3).handedness, -1);
    expect_near(first(4).tangent, {-1, 0, 0});
    EXPECT_EQ(first(4).handedness, 1);
    expect_near(first(5).tangent, {-1, 0, 0});
    EXPECT_EQ(first(5).handedness, -1);
}

// Catches variants that are numbered wrongly or given to primitives that have none, and unknown names without help.
TEST(GltfImport, Variants) {
    const std::filesystem::path file = std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes/gltf/variants.gltf";
    const auto color_of = [&](const char* variant, std::size_t object) {
        const scene::Scene scene = import_gltf(file, {}, variant);
        return scene.materials.at(mesh_of(scene.objects.at(object)).triangles[0].material).principled->base_color;
    };
    expect_near(color_of("", 0), {0.8F, 0.8F, 0.8F});
    expect_near(color_of("red", 0), {0.8F, 0.1F, 0.1F});
    expect_near(color_of("red", 1), {0.9F, 0.7F, 0.35F});
    expect_near(color_of("squared", 1), {0.8F, 0.8F, 0.8F});  // Names no material for the box.
    EXPECT_EQ(import_gltf(file, {}).variants, (std::vector<std::string>{"brass", "red", "squared"}));
    try {
        (void)import_gltf(file, {}, "bras");
        FAIL() << "an unknown variant is taken";
    } catch (const InputError& error) {
        EXPECT_NE(error.diagnostic().hint.find("'brass'"), std::string::npos) << error.diagnostic().hint;
        EXPECT_NE(error.diagnostic().hint.find("'squared'"), std::string::npos) << error.diagnostic().hint;
    }
}

}  // namespace
}  // namespace sundog::import::gltf
