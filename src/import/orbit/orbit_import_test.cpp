// SPDX-License-Identifier: Apache-2.0
#include "import/orbit/orbit_import.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_folder.h"

namespace sundog::import {
namespace {

/// An old file: only the keys that the format has had from the start.
constexpr std::string_view kOld =
    "model     = a.obj   # a triangle\n"
    "focus     = 12\n"
    "rotX      = wave 1 -10 5\n"
    "rotZ      = linear 20\n"
    "distance  = 7\n"
    "origin    = 1 2 3\n"
    "light     = lamp wave\n"
    "lightPos  = 4 5 6\n"
    "lightSpeed = 0.1 0.2 0.3\n"
    "lightAmplitude=7 8 9\n";

class Orbit : public testing::Test {
protected:
    Orbit() { folder_.write("a.obj", "o tri\nv 0 0 0\nv 2 0 0\nv 0 2 4\nf 1 2 3\n"); }

    scene::Scene import_text(const std::string& text) {
        return import_orbit_scene(folder_.write("a.scene", text), warnings_.sink());
    }
    scene::Scene with(const std::string& more) { return import_text(std::string(kOld) + more); }
    template <class Read>
    static std::string error_of(const Read& read) {
        try {
            read();
        } catch (const InputError& error) {
            const Diagnostic& d = error.diagnostic();
            return std::to_string(d.where.line) + ':' + std::to_string(d.where.column) + ": " + d.message;
        }
        return "no error";
    }
    std::string error_with(const std::string& more) {
        return error_of([&] { with(more); });
    }
    /// The old file with one line replaced (or left out).
    std::string error_without(const std::string& key, const std::string& instead = "") {
        std::string text(kOld);
        const std::size_t at = text.find(key);
        text.replace(at, text.find('\n', at) - at, instead);
        return error_of([&] { import_text(text); });
    }

    TestFolder folder_;
    Warnings warnings_;
};

// Catches an old key that is read wrongly, and new keys whose defaults change old files.
TEST_F(Orbit, OldFilesMeanWhatTheyMeant) {
    const scene::Scene scene = with("");
    EXPECT_EQ(scene.camera.focus, 12.0F);
    EXPECT_EQ(scene.camera.rot_x_deg.kind, scene::Motion::Kind::wave);
    EXPECT_EQ(scene.camera.rot_x_deg.speed, 1.0F);
    EXPECT_EQ(scene.camera.rot_x_deg.base, -10.0F);
    EXPECT_EQ(scene.camera.rot_x_deg.amplitude, 5.0F);
    EXPECT_EQ(scene::value_at(scene.camera.rot_z_deg, 2), 40.0F);
    EXPECT_EQ(scene.camera.distance, 7.0F);
    EXPECT_EQ(scene.camera.origin, (Vec3{1, 2, 3}));
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].kind, scene::Light::Kind::lamp);
    EXPECT_TRUE(scene.lights[0].moving);
    EXPECT_TRUE(scene.lights[0].shadows);
    EXPECT_EQ(scene.lights[0].place, (Vec3{4, 5, 6}));
    EXPECT_EQ(scene.lights[0].speed, (Vec3{0.1F, 0.2F, 0.3F}));
    EXPECT_EQ(scene.lights[0].amplitude, (Vec3{7, 8, 9}));
    EXPECT_EQ(scene.lights[0].color, (Vec3{1, 1, 1}));
    EXPECT_FALSE(scene.objects.at(0).motion.has_value());
    EXPECT_FALSE(scene.settings.cull_backfaces);
    EXPECT_FALSE(scene.settings.width.has_value());
}

// Catches files whose keys stand in another order: a light's keys may come before it.
TEST_F(Orbit, TheOrderOfOldKeysMeansNothing) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < kOld.size(); at = kOld.find('\n', at) + 1)
        lines.emplace_back(kOld.substr(at, kOld.find('\n', at) + 1 - at));
    std::string backwards;
    for (auto it = lines.rbegin(); it != lines.rend(); ++it) backwards += *it;
    const scene::Scene scene = import_text(backwards);
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].place, (Vec3{4, 5, 6}));
}

// Catches our own keys being read into the wrong place.
TEST_F(Orbit, OwnKeys) {
    folder_.write("b.mtl", "newmtl red\nKd 1 0 0\nnewmtl deep blue\nKd 0 0 1\n");
    const scene::Scene scene = with(
        "lightColor = 1 0.5 0\nlight = sun const\nlightPos = 0 0 1\nlightShadow = false\n"
        "sky = 0.1 0.2 0.3\nambient = 0.4 0.5 0.6\ncullBackfaces = true\nwidth = 320\nmaxRayDepth = 0\n"
        "mtllib = b.mtl\nsphere = \"a ball\" red 1 2 3 0.5\nbox = crate \"deep blue\" -1 -1 -1 1 1 1\n"
        "plane = floor red 0 0 2 -1\n"
        "motion = tri rotZ linear 30\nmotion = tri move 1 2 3 4 5 6\n"
        "motion = \"a ball\" rotX wave 1 0 10\nmotion = \"a ball\" center 9 9 9\n");
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.lights[0].color, (Vec3{1, 0.5F, 0}));
    EXPECT_EQ(scene.lights[1].kind, scene::Light::Kind::sun);
    EXPECT_EQ(scene.lights[1].color, (Vec3{1, 1, 1}));
    EXPECT_FALSE(scene.lights[1].shadows);
    EXPECT_EQ(scene.sky, (Vec3{0.1F, 0.2F, 0.3F}));
    EXPECT_EQ(scene.ambient, (Vec3{0.4F, 0.5F, 0.6F}));
    EXPECT_TRUE(scene.settings.cull_backfaces);
    EXPECT_EQ(scene.settings.width, 320);
    EXPECT_EQ(scene.settings.max_depth, 0);
    ASSERT_EQ(scene.objects.size(), 4U);
    EXPECT_EQ(scene.objects[0].motion->center, (Vec3{1, 1, 2})) << "the middle of its bounding box";
    EXPECT_EQ(scene.objects[0].motion->move_amplitude, (Vec3{4, 5, 6}));
    EXPECT_EQ(scene.objects[1].name, "a ball");
    EXPECT_EQ(scene.objects[1].motion->center, (Vec3{9, 9, 9}));
    EXPECT_EQ(scene.materials.at(scene.objects[2].material).name, "deep blue");
    EXPECT_EQ(std::get<scene::Plane>(scene.objects[3].shape).normal, (Vec3{0, 0, 1}));
    EXPECT_TRUE(warnings_.texts.empty()) << warnings_.texts.front();
}

// Catches a missing library or material that ends the import or goes unseen.
TEST_F(Orbit, MissingMaterialsAreShown) {
    const scene::Scene scene = with("mtllib = lost.mtl\nsphere = ball gold 0 0 0 1\n");
    EXPECT_EQ(scene.materials.at(scene.objects.at(1).material).mtl->diffuse, (Vec3{1, 0, 1}));
    EXPECT_EQ(warnings_.texts,
              (std::vector<std::string>{"11: missing material library 'lost.mtl'", "12: missing material 'gold'"}));
}

// Catches errors that are not raised or point elsewhere.
TEST_F(Orbit, LocatesErrors) {
    EXPECT_EQ(error_without("focus"), "0:0: missing key 'focus'");
    EXPECT_EQ(error_without("model"), "0:0: missing key 'model'");
    EXPECT_EQ(error_without("lightPos"), "7:1: the light that starts here has no 'lightPos'");
    EXPECT_EQ(error_without("lightSpeed"), "7:1: the light that starts here has no 'lightSpeed'");
    EXPECT_EQ(error_without("light     "), "8:1: the light that starts here has no 'light'");
    EXPECT_EQ(error_without("focus", "focsu = 12"), "2:1: unknown key 'focsu'");
    EXPECT_EQ(error_without("focus", "focus 12"), "2:1: expected 'key = value', found no '='");
    EXPECT_EQ(error_without("focus", "focus = "), "2:9: the line ends too early");
    EXPECT_EQ(error_without("focus", "focus = 0"), "2:9: the number must be greater than 0");
    EXPECT_EQ(error_without("focus", "focus = nan"), "2:9: bad number 'nan'");
    EXPECT_EQ(error_without("focus", "focus = 12 13"), "2:12: unexpected '13' at the end of the line");
    EXPECT_EQ(error_without("rotX", "rotX = linear 3"), "3:8: 'linear' is not possible here");
    EXPECT_EQ(error_without("rotX", "rotX = wav 1 2 3"), "3:8: unknown motion 'wav'");
    EXPECT_EQ(error_without("model", "model = lost.obj"), "1:9: missing model 'lost.obj'");
    EXPECT_EQ(error_without("model", "model = a.stl"), "1:9: a model of unknown format: 'a.stl'");
    EXPECT_EQ(error_with("focus = 3\n"), "11:1: the key 'focus' is given twice");
    EXPECT_EQ(error_with("lightPos = 1 1 1\n"), "11:1: the key 'lightPos' is given twice");
    EXPECT_EQ(error_with("light = sun const\nlightPos = 0 0 0\n"), "11:1: the sun that starts here has no direction");
    EXPECT_EQ(error_with("width = 0\n"), "11:9: number out of range");
    EXPECT_EQ(error_with("width = 65536\n"), "11:9: number out of range");
    EXPECT_EQ(error_with("reflThreshold = 1.5\n"), "11:17: number out of range");
    EXPECT_EQ(error_with("sky = 1 1 -1\n"), "11:7: a colour can't be negative");
    EXPECT_EQ(error_with("shadow = maybe\n"), "11:10: expected true or false, found 'maybe'");
    EXPECT_EQ(error_with("sphere = a b 0 0 0 0\n"), "11:20: the radius must be greater than 0");
    EXPECT_EQ(error_with("plane = a b 0 0 0 1\n"), "11:13: the normal has no direction");
    EXPECT_EQ(error_with("box = a b 0 0 0 1 1 0\n"),
              "11:17: the upper corner must lie above the lower one in x, y and z");
    EXPECT_EQ(error_with("motion = try rotZ linear 1\n"), "11:10: no object is named 'try'");
    EXPECT_EQ(error_with("motion = tri spin 1\n"), "11:14: unknown motion 'spin'");
    EXPECT_EQ(error_with("motion = tri rotZ const 1\nmotion = tri rotZ const 2\n"),
              "12:10: the same motion of 'tri' is given twice");
}

// Catches settings of raytracer.conf that are mixed up or not checked.
TEST_F(Orbit, ReadsTheConfiguration) {
    const OrbitConfig config = import_orbit_config(
        folder_.write("raytracer.conf",
                      "defaultScene = my scene.scene\nwidth = 800\nheight=600\nfullscreen = true\n"
                      "freeze = 2.5\nmaxRayDepth = 7\nshadow = false\nreflThreshold = 0.02\nfarZ = 100\n"),
        {});
    EXPECT_EQ(config.default_scene, "my scene.scene");
    EXPECT_EQ(config.settings.width, 800);
    EXPECT_EQ(config.settings.height, 600);
    EXPECT_EQ(config.settings.fullscreen, true);
    EXPECT_EQ(config.settings.freeze_s, 2.5F);
    EXPECT_EQ(config.settings.max_depth, 7);
    EXPECT_EQ(config.settings.shadows, false);
    EXPECT_EQ(config.settings.min_weight, 0.02F);
    EXPECT_EQ(config.settings.far_z, 100.0F);
    const auto error = [&](const std::string& text) {
        return error_of([&] { import_orbit_config(folder_.write("bad.conf", text), {}); });
    };
    EXPECT_EQ(error("heigth = 3\n"), "1:1: unknown key 'heigth'");
    EXPECT_EQ(error("focus = 3\n"), "1:1: unknown key 'focus'");
    EXPECT_EQ(error("width = 1\nwidth = 1\n"), "2:1: the key 'width' is given twice");
    EXPECT_EQ(error("maxRayDepth = 2.5\n"), "1:15: bad whole number '2.5'");
}

}  // namespace
}  // namespace sundog::import
