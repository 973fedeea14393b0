// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

#include <gtest/gtest.h>

#include "usage_error.h"

namespace sundog::app {
namespace {

// Catches sums that are not divided by the samples, and exposure that is not in stops.
TEST(Picture, MeanTimesExposure) {
    Film film({0, 0, 2, 1});
    film.radiance[0] = {2, 4, 8, 4};
    const output::Image image = image_of(film, 1);
    EXPECT_EQ(image.at(0, 0), (Vec3{1, 2, 4}));
    EXPECT_EQ(image.at(1, 0), (Vec3{0, 0, 0})) << "a pixel without samples is black";
}

// Catches an overlay that paints other pixels than those with a cost, or that exposure turns gray.
TEST(Picture, TracedPixelsAreWhite) {
    Film film({4, 2, 6, 4}, kernel::AOV_COST);
    film.radiance.assign(4, {0.25F, 0.25F, 0.25F, 1});
    film.cost[film.index(5, 2)] = 3;
    film.cost[film.index(4, 3)] = 1;
    output::Image image = image_of(film, -1);
    paint_traced(film, image);
    const Vec3 dark{0.125F, 0.125F, 0.125F}, white{1, 1, 1};
    EXPECT_EQ(image.at(0, 0), dark);
    EXPECT_EQ(image.at(1, 0), white);
    EXPECT_EQ(image.at(0, 1), white);
    EXPECT_EQ(image.at(1, 1), dark);
}

// Catches layers whose values don't fill the picture, and "nothing" shown as object number 4294967295.
TEST(Picture, Layers) {
    const AovChoice all = parse_aovs("all");
    Film film({0, 0, 2, 1}, all.planes);
    film.radiance[1] = {0, 0, 0, 3};
    film.object[0] = 5;
    const auto layers = layers_of(film, all);
    ASSERT_EQ(layers.size(), 6U);
    for (const output::Layer& layer : layers) EXPECT_EQ(layer.values.size(), 2 * layer.channels.size()) << layer.name;
    for (const output::Layer& layer : layers) {
        if (layer.name == "object") {
            EXPECT_EQ(layer.values[0], 5);
            EXPECT_EQ(layer.values[3], -1);
        }
        if (layer.name == "samples") {
            EXPECT_EQ(layer.values[1], 3);
        }
    }
}

// Catches a picture that is larger than the machine's memory being tried, and an ordinary one being refused.
TEST(Picture, RefusesWhatDoesNotFitIntoMemory) {
    EXPECT_NO_THROW(check_picture_memory({640, 480}, parse_aovs("all")));
    const std::size_t of_largest = picture_memory({kLargestSide, kLargestSide}, parse_aovs("all"));
    if (of_largest > usable_memory()) {
        EXPECT_THROW(check_picture_memory({kLargestSide, kLargestSide}, parse_aovs("all")), UsageError);
    }
}

}  // namespace
}  // namespace sundog::app
