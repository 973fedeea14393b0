// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "import/pov/build_test_scene.h"
#include "import/pov/photon_file.h"

namespace sundog::pov {
namespace {

using scene::PhotonSwitch;

/// The error of `photons { ITEMS }` in global_settings, without the place and the source's line.
std::string global_error(const std::string& items) {
    std::string error = error_of("global_settings { photons { " + items + " } }");
    const std::size_t message = error.find("error: "), end = error.find('\n'), hint = error.find("hint: ");
    if (message == std::string::npos) return error;
    return error.substr(message + 7, end - message - 7) + (hint == std::string::npos ? "" : "; " + error.substr(hint));
}

scene::Photons global_photons(const std::string& items) {
    const BuiltScene built = build("global_settings { photons { " + items + " } }");
    EXPECT_TRUE(built.warnings.empty());
    return built.scene.photons.value_or(scene::Photons{});
}

// A setting read into another one, a default that isn't povray's.
TEST(BuildPhotons, GlobalSettingsAreRead) {
    const scene::Photons p = global_photons(
        "spacing 0.02 gather 10, 50 media 300, 2.5 jitter 0.3 max_trace_level 7 adc_bailout 0.02 autostop 0.25 "
        "expand_thresholds 0.5, 30 radius 0.1, 0.2, 0.3, 0.4");
    EXPECT_FLOAT_EQ(p.spacing, 0.02F);
    EXPECT_EQ(p.count, 0);
    EXPECT_EQ(p.gather_min, 10);
    EXPECT_EQ(p.gather_max, 50);
    EXPECT_EQ(p.media_steps, 300);
    EXPECT_FLOAT_EQ(p.media_factor, 2.5F);
    EXPECT_FLOAT_EQ(p.jitter, 0.3F);
    EXPECT_EQ(p.max_depth, 6);
    EXPECT_FLOAT_EQ(p.min_weight.value_or(0), 0.02F);
    EXPECT_FLOAT_EQ(p.autostop, 0.25F);
    EXPECT_FLOAT_EQ(p.expand_increase, 0.5F);
    EXPECT_EQ(p.expand_min, 30);
    EXPECT_FLOAT_EQ(p.radius, 0.1F);
    EXPECT_FLOAT_EQ(p.radius_factor, 0.2F);
    EXPECT_FLOAT_EQ(p.media_radius, 0.3F);
    EXPECT_FLOAT_EQ(p.media_radius_factor, 0.4F);
    const scene::Photons defaults = global_photons("count 2000");
    EXPECT_EQ(defaults.count, 2000);
    EXPECT_FLOAT_EQ(defaults.spacing, 0);
    EXPECT_EQ(defaults.gather_min, 20);
    EXPECT_EQ(defaults.gather_max, 100);
    EXPECT_EQ(defaults.media_steps, 0);
    EXPECT_FLOAT_EQ(defaults.jitter, 0.4F);
    EXPECT_FLOAT_EQ(defaults.autostop, 1);
    EXPECT_EQ(defaults.expand_min, 40);
    EXPECT_FALSE(defaults.max_depth || defaults.min_weight || defaults.loaded || defaults.store);
    EXPECT_FLOAT_EQ(global_photons("count 10 media 100").media_factor, 1);
    EXPECT_EQ(global_photons("spacing 3 count 10").count, 10) << "the last one counts";
}

// Each of the four numbers may be left out. Catches a comma that is taken for nothing.
TEST(BuildPhotons, RadiiMayBeLeftOut) {
    const auto radii = [](const std::string& items) {
        const scene::Photons p = global_photons("count 10 " + items + " autostop 0");
        EXPECT_FLOAT_EQ(p.autostop, 0);
        return std::array{p.radius, p.radius_factor, p.media_radius, p.media_radius_factor};
    };
    EXPECT_EQ(radii("radius"), (std::array{0.0F, 1.0F, 0.0F, 1.0F}));
    EXPECT_EQ(radii("radius 0.5"), (std::array{0.5F, 1.0F, 0.0F, 1.0F}));
    EXPECT_EQ(radii("radius , 0.5"), (std::array{0.0F, 0.5F, 0.0F, 1.0F}));
    EXPECT_EQ(radii("radius ,,0.5"), (std::array{0.0F, 1.0F, 0.5F, 1.0F}));
    EXPECT_EQ(radii("radius 2,,0.5, 3"), (std::array{2.0F, 1.0F, 0.5F, 3.0F}));
    EXPECT_EQ(radii("radius 0, 3, 0, 4"), (std::array{0.0F, 3.0F, 0.0F, 4.0F}));
}

TEST(BuildPhotons, ObjectsAreRead) {
    const BuiltScene built = build(R"(
        sphere { 0, 1 }
        sphere { 0, 1 photons { target } }
        sphere { 0, 1 photons { target 0.5 refraction on reflection off collect off pass_through } }
        sphere { 0, 1 no_shadow photons { target 0 refraction reflection pass_through off } }
        #declare Glass = sphere { 0, 1 photons { target refraction on } }
        object { Glass photons { collect off } }
        union { sphere { 0, 1 } sphere { 3, 1 photons { collect on } } photons { target collect off } }
        union { sphere { 0, 1 } sphere { 3, 1 } split_union off photons { target } }
        global_settings { photons { count 10 } })");
    const auto photons = [&](std::size_t i) { return *built.scene.objects.at(i).photons; };
    EXPECT_EQ(photons(0), scene::ObjectPhotons{});
    EXPECT_TRUE(photons(1).target && photons(1).collect);
    EXPECT_EQ(photons(1).refraction, PhotonSwitch::unset);
    EXPECT_FLOAT_EQ(photons(2).spacing, 0.5F);
    EXPECT_EQ(photons(2).refraction, PhotonSwitch::on);
    EXPECT_EQ(photons(2).reflection, PhotonSwitch::off);
    EXPECT_FALSE(photons(2).collect);
    EXPECT_EQ(photons(2).pass_through, true);
    EXPECT_FALSE(photons(3).target);
    EXPECT_EQ(photons(3).refraction, PhotonSwitch::on);
    EXPECT_EQ(photons(3).pass_through, false);
    EXPECT_TRUE(photons(4).target && !photons(4).collect) << "a declared object's are changed";
    EXPECT_TRUE(photons(5).target && !photons(5).collect) << "a union's are its parts'";
    EXPECT_TRUE(!photons(6).target && photons(6).collect) << "unless they have their own";
    EXPECT_NE(photons(7).whole, 0U);
    EXPECT_EQ(photons(7).whole, photons(8).whole);
    EXPECT_EQ(photons(5).whole, 0U);
    EXPECT_TRUE(built.warnings.empty());
}

TEST(BuildPhotons, LightsAreRead) {
    const BuiltScene built = build(R"(
        light_source { 0, 1 }
        light_source { 0, 1 photons { refraction on reflection off } }
        light_group { light_source { 0, 1 photons { area_light refraction off } } sphere { 0, 1 photons { target } } })");
    EXPECT_EQ(built.scene.lights[0].photons.refraction, PhotonSwitch::unset);
    EXPECT_FALSE(built.scene.lights[0].photons.area_light);
    EXPECT_EQ(built.scene.lights[1].photons.refraction, PhotonSwitch::on);
    EXPECT_EQ(built.scene.lights[1].photons.reflection, PhotonSwitch::off);
    EXPECT_EQ(built.scene.lights[2].photons.refraction, PhotonSwitch::off);
    EXPECT_TRUE(built.scene.lights[2].photons.area_light);
    EXPECT_NE(built.scene.lights[2].group, 0U);
    EXPECT_TRUE(built.scene.objects[0].photons->target);
    EXPECT_FALSE(built.scene.photons);
}

// Messages without what would have been right.
TEST(BuildPhotons, BadNumbersAreErrors) {
    EXPECT_EQ(global_error("spacing 0"), "a spacing out of range; hint: expected a number above 0");
    EXPECT_EQ(global_error("spacing -1"), "a spacing out of range; hint: expected a number above 0");
    EXPECT_EQ(global_error("autostop 1.5"), "an autostop out of range; hint: expected a number from 0 to 1");
    EXPECT_EQ(global_error("jitter -1"), "an amount of jitter out of range; hint: expected a number of at least 0");
    EXPECT_EQ(global_error("radius -1"), "a radius out of range; hint: expected a number of at least 0");
    EXPECT_EQ(global_error("adc_bailout -1"), "a weight out of range; hint: expected a number of at least 0");
    EXPECT_EQ(global_error("media 10, 0"), "a factor out of range; hint: expected a number above 0");
    EXPECT_EQ(global_error("gather 50, 20"),
              "fewer photons at most than at least; hint: expected a number of at least 50");
    EXPECT_NE(global_error("count 0").find("a number of photons"), std::string::npos);
    EXPECT_NE(global_error("gather 0, 20").find("the least number of photons"), std::string::npos);
    EXPECT_NE(global_error("max_trace_level 0").find("a level"), std::string::npos);
    EXPECT_NE(global_error("target").find("'target' has no place in photons { }"), std::string::npos);
    EXPECT_NE(error_of("sphere { 0, 1 photons { count 3 } }").find("'count' has no place in photons { }"),
              std::string::npos);
    EXPECT_NE(error_of("sphere { 0, 1 photons { target -1 } }").find("a negative spacing"), std::string::npos);
    EXPECT_NE(error_of("light_source { 0, 1 photons { collect off } }").find("'collect' has no place in photons { }"),
              std::string::npos);
}

TEST(BuildPhotons, MediaMayIgnoreThem) {
    const BuiltScene built = build("media { scattering { 1, rgb 1 } collect off } media { scattering { 1, rgb 1 } }");
    EXPECT_FALSE(built.scene.atmosphere[0].collects_photons);
    EXPECT_TRUE(built.scene.atmosphere[1].collects_photons);
}

StoredPhotons some_photons() {
    StoredPhotons photons;
    photons.surface = {{{1, 2, 3}, {0, 0, 1}, {0, 0, -1}, {4, 5, 6}}, {{7, 8, 9}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 2}}};
    photons.media = {{{-1, -2, -3}, {1, 0, 0}, {0, 0, 0}, {1e-20F, 1e20F, 0}}};
    return photons;
}

std::string why_unread(const std::string& bytes) {
    try {
        photons_of_bytes(bytes);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

// A file gives back what was put into it, on any machine; whatever else is in one is named.
TEST(PhotonFile, GivesBackPhotons) {
    const std::string bytes = photon_file_bytes(some_photons());
    EXPECT_EQ(bytes.substr(0, 21), "sundog photons 1\n2 1\n");
    EXPECT_EQ(bytes.size(), 21U + 3 * 48);
    EXPECT_EQ(bytes.substr(21, 8), std::string("\0\0\x80\x3f\0\0\0\x40", 8)) << "1 and 2, lowest byte first";
    const StoredPhotons back = photons_of_bytes(bytes);
    EXPECT_EQ(back.surface, some_photons().surface);
    EXPECT_EQ(back.media, some_photons().media);
    EXPECT_TRUE(photons_of_bytes("sundog photons 1\n0 0\n").surface.empty());
}

TEST(PhotonFile, OtherFilesAreErrors) {
    const std::string bytes = photon_file_bytes(some_photons());
    EXPECT_EQ(why_unread(""), "not a file of photons that Sundog has saved");
    EXPECT_EQ(why_unread("PHOT"), "not a file of photons that Sundog has saved");
    for (const char* counts : {"", "3", "3 4", "-1 2\n", "a b\n", "3,4\n", "99999999999 1\n", "1 2 3\n"})
        EXPECT_EQ(why_unread("sundog photons 1\n" + std::string(counts)), "it doesn't say how many photons it holds")
            << counts;
    EXPECT_EQ(why_unread(bytes.substr(0, bytes.size() - 1)), "it is not as long as its 3 photons");
    EXPECT_EQ(why_unread(bytes + "x"), "it is not as long as its 3 photons");
    EXPECT_EQ(why_unread("sundog photons 1\n4294967295 4294967295\n"), "it is not as long as its 8589934590 photons");
    StoredPhotons bad = some_photons();
    bad.surface[1].power.y = std::numeric_limits<float>::infinity();
    EXPECT_EQ(why_unread(photon_file_bytes(bad)), "photon 2 is no place, directions and power");
}

TEST(PhotonFile, ScenesNameWhatCannotBeRead) {
    EXPECT_NE(
        global_error("load_file \"nowhere.ph\"").find("can't find the file of photons 'nowhere.ph'; hint: sought"),
        std::string::npos);
    const std::filesystem::path bad = std::filesystem::temp_directory_path() / "sundog_photons_test.ph";
    std::ofstream(bad) << "something else";
    EXPECT_EQ(global_error("load_file \"sundog_photons_test.ph\""),
              "can't read the file of photons 'sundog_photons_test.ph'; hint: not a file of photons that Sundog has "
              "saved");
    std::ofstream(bad, std::ios::binary) << photon_file_bytes(some_photons());
    EXPECT_EQ(global_photons("load_file \"sundog_photons_test.ph\"").loaded->surface, some_photons().surface);
    std::filesystem::remove(bad);
    EXPECT_NE(global_error("save_file \"out.ph\"").find("can't write to 'out.ph'"), std::string::npos)
        << "no folder may be written to";
}

}  // namespace
}  // namespace sundog::pov
