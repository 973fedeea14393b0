// SPDX-License-Identifier: Apache-2.0
#include "viewer/picked.h"

#include <gtest/gtest.h>

namespace sundog::viewer {
namespace {

LoadedScene two_objects() {
    LoadedScene loaded;
    const auto obj = std::make_shared<const std::string>("room.obj");
    const auto mtl = std::make_shared<const std::string>("room.mtl");
    for (const char* name : {"floor", "ball"}) {
        scene::Object object;
        object.name = name;
        object.where = {obj, static_cast<std::uint32_t>(loaded.scene.objects.size() + 10), 1};
        loaded.scene.objects.push_back(object);
    }
    scene::Material glass;
    glass.name = "glass";
    glass.where = {mtl, 33, 1};
    loaded.scene.materials = {glass};
    auto compiled = std::make_shared<RenderScene>();
    compiled->geometry_names = {"ball", "floor"};  // compiled in another order than written
    compiled->geometry_objects = {1, 0};
    loaded.compiled = compiled;
    return loaded;
}

// Catches the wrong object's place (the geometry's index used as the object's), and a material without its line.
TEST(Picked, NamesObjectAndMaterialWithTheirLines) {
    PixelInfo info;
    info.geometry = 0;
    info.material = 0;
    const PickedPixel picked = describe_pixel(two_objects(), info, 4, 5);
    EXPECT_TRUE(picked.hit);
    EXPECT_EQ(picked.object, "ball");
    EXPECT_EQ(picked.object_place, "room.obj:11");
    EXPECT_EQ(picked.material, "glass");
    EXPECT_EQ(picked.material_place, "room.mtl:33");
    EXPECT_EQ(picked.x, 4);
    EXPECT_EQ(picked.y, 5);
}

// Catches a look-up with the index of nothing.
TEST(Picked, TheSkyHasNoObject) {
    const PickedPixel picked = describe_pixel(two_objects(), PixelInfo{}, 0, 0);
    EXPECT_FALSE(picked.hit);
    EXPECT_EQ(picked.object, "");
}

}  // namespace
}  // namespace sundog::viewer
