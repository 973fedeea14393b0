// SPDX-License-Identifier: Apache-2.0
#include "viewer/rate_meter.h"

#include <gtest/gtest.h>

namespace sundog::viewer {
namespace {

// Catches rates that count the wrong thing: 60 pictures a second of 1000 rays in 5 ms each.
TEST(RateMeter, CountsPicturesAndRays) {
    RateMeter meter;
    double now_s = 100;
    for (int i = 0; i < 90; ++i, now_s += 1.0 / 60) meter.add(now_s, 1000, 0.005);
    EXPECT_NEAR(meter.pictures_per_s(now_s), 60, 1);
    EXPECT_NEAR(meter.rays_per_s(), 200000, 1);
}

// Catches a frame rate that stays up after the last picture, or counts the rest as one slow picture.
TEST(RateMeter, ARestEndsTheRate) {
    RateMeter meter;
    double now_s = 0;
    for (int i = 0; i < 60; ++i, now_s += 1.0 / 30) meter.add(now_s, 1000, 0.005);
    EXPECT_EQ(meter.pictures_per_s(now_s + 1), 0);
    now_s += 10;
    for (int i = 0; i < 60; ++i, now_s += 1.0 / 30) meter.add(now_s, 1000, 0.005);
    EXPECT_NEAR(meter.pictures_per_s(now_s), 30, 1);
}

}  // namespace
}  // namespace sundog::viewer
