// SPDX-License-Identifier: Apache-2.0
#include "session/thin_items.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sundog {
namespace {

/// A camera at the origin that looks along z, 90 degrees wide and high, at 640 by 640 pixels.
Frame straight_frame() {
    Frame frame;
    frame.params.width = frame.params.height = 640;
    frame.params.camera_kind = kernel::CAMERA_PERSPECTIVE;
    frame.params.camera = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    return frame;
}

std::uint8_t mark_at(const std::vector<std::uint8_t>& finest, int x, int y) {
    return finest[static_cast<std::size_t>(y / 8 * 80 + x / 8)];
}

// Catches marks beside what they are for, and thick things that are marked.
TEST(ThinItems, MarksLieWhereThinThingsAre) {
    const Frame frame = straight_frame();
    // Ten units away 32 pixels are one unit. A post of 0.05 by 4 at the picture's left.
    const ThinItem post{{-5, 0, 10}, {0.025F, 0, 0}, {0, 2, 0}, {0, 0, 0.025F}};
    const std::vector<std::uint8_t> finest = finest_squares({post}, frame);
    ASSERT_EQ(80U * 80U, finest.size());
    EXPECT_EQ(1, mark_at(finest, 160, 320));
    EXPECT_EQ(1, mark_at(finest, 160, 260));
    EXPECT_EQ(8, mark_at(finest, 200, 320));
    EXPECT_EQ(8, mark_at(finest, 160, 420));
    const ThinItem ball{{0, 0, 10}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // 64 pixels wide
    for (const std::uint8_t mark : finest_squares({ball}, frame)) EXPECT_EQ(8, mark);
    const ThinItem pea{{0, 0, 10}, {0.15F, 0, 0}, {0, 0.15F, 0}, {0, 0, 0.15F}};  // 9.6 pixels
    EXPECT_EQ(4, mark_at(finest_squares({pea}, frame), 320, 320));
}

// Catches boxes whose projection is taken for their axis-aligned hull's, and things behind the eye.
TEST(ThinItems, SlantedAndHiddenThings) {
    const Frame frame = straight_frame();
    const float s = std::sqrt(0.5F);
    const ThinItem rod{{0, 0, 10}, {3 * s, 3 * s, 0}, {-0.02F * s, 0.02F * s, 0}, {0, 0, 0.02F}};
    const std::vector<std::uint8_t> finest = finest_squares({rod}, frame);
    EXPECT_EQ(1, mark_at(finest, 320 + 30, 320 - 31));
    EXPECT_EQ(8, mark_at(finest, 320 - 40, 320 - 40));  // inside its upright hull, but not on it
    const ThinItem behind{{0, 0, -10}, {0.02F, 0, 0}, {0, 3, 0}, {0, 0, 0.02F}};
    for (const std::uint8_t mark : finest_squares({behind}, frame)) EXPECT_EQ(8, mark);
}

// Catches parts of one mesh that share a box, and thin parts of one connected mesh.
TEST(ThinItems, MeshesAreTakenApart) {
    RenderScene scene;
    scene.geometries.push_back({kernel::GEOMETRY_TRIANGLES, 0, 4, kernel::NONE, 0, 0, 0});
    // Two far leaves, and an L of two long needles, one of them slanted.
    scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},    {9, 9, 9}, {10, 9, 9},  {9, 10, 9},
                       {0, 0, 5}, {8, 0, 5}, {8, 0.1F, 5}, {0, 8, 9}, {0.1F, 8, 9}};
    scene.triangles = {{0, 1, 2, 0}, {3, 4, 5, 0}, {6, 7, 8, 0}, {6, 9, 10, 0}};
    const std::vector<ThinItem> items = thin_items(scene);
    ASSERT_EQ(4U, items.size());
    EXPECT_NEAR(9.5, items[1].center.x, 0.3);
    for (const std::size_t needle : {2U, 3U}) {
        EXPECT_NEAR(4, length(items[needle].half_x), 0.6);
        EXPECT_LT(length(items[needle].half_y), 0.06);
        EXPECT_LT(length(items[needle].half_z), 0.06);
    }
}

}  // namespace
}  // namespace sundog
