// SPDX-License-Identifier: Apache-2.0
#include "indirect_options.h"

#include <gtest/gtest.h>

#include "kernel/shared.h"

namespace sundog::app {
namespace {

/// A scene that asks for both in its own way.
scene::Scene asking() {
    scene::Scene s;
    s.photons.emplace();
    s.photons->spacing = 0.1F;
    s.photons->radius = 3;
    s.photons->loaded = std::make_shared<const StoredPhotons>();
    s.radiosity.emplace();
    s.radiosity->count = 50;
    s.radiosity->recursion_limit = 1;
    s.radiosity->brightness = 2;
    return s;
}

// Catches scenes whose own settings are changed unasked.
TEST(IndirectOptions, WithoutThemScenesKeepWhatTheySay) {
    scene::Scene s = asking();
    IndirectArguments{}.apply(s);
    EXPECT_EQ(s.photons->spacing, 0.1F);
    EXPECT_FALSE(s.photons->find_targets);
    EXPECT_EQ(s.radiosity->count, 50);
    scene::Scene plain;
    IndirectArguments{}.apply(plain);
    EXPECT_FALSE(plain.photons || plain.radiosity);
}

// Catches a number that a scene's spacing or file of photons overrules, and other settings that get lost.
TEST(IndirectOptions, TheyOverruleTheScene) {
    scene::Scene s = asking();
    IndirectArguments a;
    a.photons = 1000;
    a.radiosity = 80;
    a.apply(s);
    EXPECT_EQ(s.photons->count, 1000);
    EXPECT_EQ(s.photons->spacing, 0);
    EXPECT_EQ(s.photons->loaded, nullptr);
    EXPECT_TRUE(s.photons->find_targets);
    EXPECT_EQ(s.photons->radius, 3);
    EXPECT_EQ(s.radiosity->count, 80);
    EXPECT_EQ(s.radiosity->recursion_limit, 1);
    EXPECT_EQ(s.radiosity->brightness, 2);
    a.radiosity_bounces = 7;
    a.radiosity_error = 0.25F;
    a.apply(s);
    EXPECT_EQ(s.radiosity->recursion_limit, 7);
    EXPECT_EQ(s.radiosity->error_bound, 0.25F);
}

// Catches a 0 that leaves on what the scene asks for, and one that is refused with paths.
TEST(IndirectOptions, NoneIsOff) {
    scene::Scene s = asking();
    IndirectArguments a;
    a.photons = a.radiosity = 0;
    a.check(kernel::INTEGRATOR_PATH, "gpu");
    EXPECT_EQ(a.device_for("auto"), "auto");
    a.apply(s);
    EXPECT_FALSE(s.photons || s.radiosity);
    a.photons = 1;
    EXPECT_EQ(a.device_for("auto"), "cpu");
}

}  // namespace
}  // namespace sundog::app
