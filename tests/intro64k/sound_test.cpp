// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "sound/synth.h"

namespace sundog::intro {
namespace {

/// The whole soundtrack, left and right in turn, with `tail` seconds after it.
std::vector<float> soundtrack(unsigned piece) {
    const auto synth = std::make_unique<Synth>();
    std::vector<float> samples(static_cast<std::size_t>(kSampleRate) * 2 * 102);
    for (std::size_t at = 0; at < samples.size(); at += 2UL * piece) {
        const auto pairs = static_cast<unsigned>((samples.size() - at) / 2);
        play(*synth, &samples[at], std::min(piece, pairs));
    }
    return samples;
}

double loudness(const std::vector<float>& samples, double from_s, double to_s) {
    double sum = 0;
    const auto first = static_cast<std::size_t>(from_s * kSampleRate) * 2;
    const auto last = static_cast<std::size_t>(to_s * kSampleRate) * 2;
    for (std::size_t i = first; i < last; ++i) sum += static_cast<double>(samples[i]) * static_cast<double>(samples[i]);
    return std::sqrt(sum / static_cast<double>(last - first));
}

// Catches silence, noise that drowns everything, numbers that are none, and a film that ends in the middle of a chord.
TEST(IntroSound, IsHeardInEveryScene) {
    const std::vector<float> samples = soundtrack(1024);
    for (const float sample : samples) ASSERT_TRUE(std::abs(sample) <= 1) << sample;
    for (int scene = 0; scene < 6; ++scene) {
        EXPECT_GT(loudness(samples, scene * 16 + 2, scene * 16 + 15), 0.02) << scene;
        EXPECT_LT(loudness(samples, scene * 16 + 2, scene * 16 + 15), 0.4) << scene;
    }
    EXPECT_LT(loudness(samples, 99.8, 100), 0.01);
    EXPECT_EQ(loudness(samples, 100.1, 102), 0);
}

// Catches sound that depends on how large the pieces are that a sound card asks for.
TEST(IntroSound, DoesNotDependOnTheDevice) { EXPECT_EQ(soundtrack(1024), soundtrack(441)); }

}  // namespace
}  // namespace sundog::intro
