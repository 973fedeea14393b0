// SPDX-License-Identifier: Apache-2.0
// Irradiance that is cached and interpolated against long path tracing. It is biased by design, so parts of pictures
// are held to a share of the reference.
#include <gtest/gtest.h>

#include "base/test_folder.h"
#include "estimate.h"
#include "import/gltf/gltf_test_file.h"
#include "import/import.h"
#include "scene/indirect_light.h"

namespace sundog {
namespace {

using namespace test;

class CachedRadiosity : public testing::Test {
protected:
    void compare(scene::Scene s, const std::vector<Region>& regions, std::uint32_t samples, float share) const {
        FrameOptions options = size(32, 24);
        options.max_depth = 12;
        s.radiosity.reset();
        const PathMeans reference(*device_, s, options, samples, regions);
        const Film ambient = render_on(*device_, s, options, 16).film;
        s.radiosity = scene::radiosity_for(400);
        reference.expect_near(render_on(*device_, s, options, 16).film, regions, share);
        reference.expect_off(ambient, regions, share, "ambient light alone");
    }

    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

// The gallery's box: an orbit scene of an OBJ model, with a mirror and a glass ball in it. Catches bounces that are
// lost or counted twice, in mirrors too, and light of the sky or of surfaces that shine that isn't gathered.
TEST_F(CachedRadiosity, CornellBox) {
    const std::vector<Region> regions{{"all", 0, 32, 0, 24},
                                      {"ceiling", 8, 24, 2, 4},
                                      {"floor", 12, 20, 20, 22},
                                      {"red wall", 6, 8, 8, 16},
                                      {"green wall", 24, 26, 8, 16}};
    compare(import::import_scene(std::filesystem::path(SUNDOG_SCENES) / "cornell/cornell.scene", {}), regions, 64,
            0.05F);
}

/// A room open to the eye's side, 2 wide, high and deep (Y up): floor, ceiling and far wall white, others red and
/// green; matt without any gloss. A lamp of 10 candela in it.
std::string room_gltf() {
    const std::vector<std::vector<float>> quads{{-1, 0, 0, 1, 0, 0, 1, 0, -2, -1, 0, -2},
                                                {-1, 2, 0, -1, 2, -2, 1, 2, -2, 1, 2, 0},
                                                {-1, 0, -2, 1, 0, -2, 1, 2, -2, -1, 2, -2},
                                                {-1, 0, 0, -1, 0, -2, -1, 2, -2, -1, 2, 0},
                                                {1, 0, 0, 1, 2, 0, 1, 2, -2, 1, 0, -2}};
    std::string data, views, accessors, primitives;
    for (std::size_t i = 0; i < quads.size(); ++i) {
        views += R"({"buffer": 0, "byteLength": 48, "byteOffset": )" + std::to_string(data.size()) + "}, ";
        accessors +=
            R"({"componentType": 5126, "count": 4, "type": "VEC3", "bufferView": )" + std::to_string(i) + "}, ";
        primitives += std::string(i > 0 ? ", " : "") + R"({"attributes": {"POSITION": )" + std::to_string(i) +
                      R"(}, "indices": 5, "material": )" + std::to_string(i < 3 ? 0 : i - 2) + "}";
        data += import::gltf::bytes_of(quads[i]);
    }
    const std::string offset = std::to_string(data.size());
    data += import::gltf::bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
    const auto material = [](const std::string& color) {
        return R"({"doubleSided": true, "extensions": {"KHR_materials_specular": {"specularFactor": 0}},
            "pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [)" +
               color + ", 1]}}";
    };
    return R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_specular"],
        "buffers": [{"byteLength": )" +
           std::to_string(data.size()) + R"(, "uri": "data:;base64,)" + import::gltf::base64(data) +
           R"("}], "bufferViews": [)" + views + R"({"buffer": 0, "byteLength": 12, "byteOffset": )" + offset +
           R"(}], "accessors": [)" + accessors +
           R"({"componentType": 5123, "count": 6, "type": "SCALAR", "bufferView": 5}], "materials": [)" +
           material("0.7, 0.7, 0.7") + ", " + material("0.6, 0.1, 0.1") + ", " + material("0.1, 0.5, 0.1") +
           R"(], "meshes": [{"primitives": [)" + primitives + R"(]}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 10}]}},
        "nodes": [{"mesh": 0}, {"translation": [0.3, 1.4, -0.9],
            "extensions": {"KHR_lights_punctual": {"light": 0}}}], "scenes": [{"nodes": [0, 1]}], "scene": 0})";
}

// A glTF room with a lamp that fades. Catches light of such lamps, or of principled surfaces, that is gathered by
// another measure than it arrives directly.
TEST_F(CachedRadiosity, GltfRoom) {
    const TestFolder folder;
    scene::Scene s = import::import_scene(folder.write("room.gltf", room_gltf()), {});
    ASSERT_EQ(s.lights.size(), 1U);
    // From 2 before its open side, all of which is seen; importers turn Y up to Z up.
    s.projection_camera.reset();
    s.camera = {};
    s.camera.origin = {0, -2, 1};
    s.camera.focus = 24;
    const std::vector<Region> regions{{"all", 4, 28, 0, 24},
                                      {"ceiling", 12, 20, 1, 4},
                                      {"floor", 12, 20, 20, 23},
                                      {"red wall", 5, 8, 8, 16},
                                      {"green wall", 24, 27, 8, 16}};
    compare(std::move(s), regions, 64, 0.05F);
}

}  // namespace
}  // namespace sundog
