// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/photon_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "device/cpu/photon_pattern.h"

namespace sundog::cpu {
namespace {

std::vector<StoredPhoton> random_photons(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<StoredPhoton> photons(count);
    for (StoredPhoton& p : photons) {
        // Dense in one corner, as caustics are; some at one place.
        const float dense = unit(random);
        p.position = Vec3{unit(random), unit(random), unit(random) * 0.1F} * (dense * dense);
        if (unit(random) < 0.05F) p.position = {0.5F, 0.5F, 0};
        p.direction = {0, 0, -1};
        p.normal = unit(random) < 0.8F ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
        p.power = {unit(random), 1, 2};
    }
    return photons;
}

/// The same by looking at all of them.
PhotonMap::Found slow_find(const std::vector<StoredPhoton>& photons, const PhotonMap::Search& search) {
    std::vector<std::pair<float, const StoredPhoton*>> near;
    for (const StoredPhoton& p : photons) {
        const Vec3 d = p.position - search.point;
        const bool flat = !(search.normal == Vec3{});
        const float off = dot(d, search.normal);
        const float distance = dot(d, d) + (flat ? 15 * off * off : 0);
        if (distance <= search.radius * search.radius && (!flat || dot(p.normal, search.normal) >= 0.5F))
            near.emplace_back(distance, &p);
    }
    std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    PhotonMap::Found found;
    const auto most = static_cast<std::size_t>(search.most);
    const bool full = near.size() >= most;
    near.resize(std::min(near.size(), most));
    found.count = static_cast<int>(near.size());
    found.radius = full ? std::sqrt(near.back().first) : search.radius;
    return found;
}

// Catches branches of the tree that are left out, and a search that depends on the one before.
TEST(PhotonMap, FindsTheNearest) {
    for (const std::size_t count : {1U, 7U, 9U, 1000U, 20000U}) {
        const std::vector<StoredPhoton> photons = random_photons(count);
        const PhotonMap map(photons);
        std::mt19937 random(3);
        std::uniform_real_distribution<float> unit(0, 1);
        PhotonMap::Scratch warm;
        for (int i = 0; i < 100; ++i) {
            PhotonMap::Search search;
            search.point = {unit(random), unit(random), unit(random) * 0.1F};
            if (i % 2 == 0) search.normal = {0, 0, 1};
            search.most = 1 + static_cast<int>(unit(random) * 60);
            search.radius = 0.01F + 0.3F * unit(random);
            PhotonMap::Scratch cold;
            const PhotonMap::Found found = map.find(search, cold);
            const PhotonMap::Found wanted = slow_find(photons, search);
            EXPECT_EQ(found.count, wanted.count);
            EXPECT_FLOAT_EQ(found.radius, wanted.radius);
            const PhotonMap::Found again = map.find(search, warm);
            EXPECT_TRUE(again.count == found.count && again.power == found.power && again.radius == found.radius);
        }
    }
}

TEST(PhotonMap, AnEmptyOneFindsNothing) {
    PhotonMap::Scratch scratch;
    EXPECT_EQ(PhotonMap().find({{0, 0, 0}, {}, 100, 5}, scratch).count, 0);
    EXPECT_EQ(PhotonMap().typical_radius(100), 0);
}

// On an even grid a disc of n photons has the area n; catches a radius of the wrong power.
TEST(PhotonMap, TypicalRadiiAreThoseOfTheDensity) {
    std::vector<StoredPhoton> photons;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            photons.push_back({{static_cast<float>(x), static_cast<float>(y), 0}, {0, 0, -1}, {0, 0, 1}, {1, 1, 1}});
    EXPECT_NEAR(PhotonMap(photons).typical_radius(100), std::sqrt(100 / std::numbers::pi), 0.5);
}

double sum_of_power(const PhotonPattern& pattern) {
    double sum = 0;
    for (std::uint32_t ring = 0; ring < pattern.ring_count(); ++ring)
        for (std::uint32_t i = 0; i < pattern.count_in(ring); ++i)
            sum += static_cast<double>(pattern.photon(ring, i).power.x);
    return sum;
}

// A pattern's photons share the cap's solid angle, or the disc's area; they are as many as the spacing says.
TEST(PhotonPattern, SharesAddUp) {
    constexpr double kPi = std::numbers::pi;
    PhotonPattern cap = PhotonPattern::from_point({1, 2, 3}, {1, 2, 7}, 2);
    cap.set_spacing(0.05, 0.4, 1);
    const double angle = 2 * kPi * (1 - std::cos(std::asin(0.5)));
    EXPECT_NEAR(sum_of_power(cap), angle, 1e-4);
    EXPECT_NEAR(cap.area(), angle * 16, 1e-9);
    EXPECT_NEAR(static_cast<double>(cap.count()), angle * 16 / 0.0025, 0.03 * angle * 16 / 0.0025);

    PhotonPattern sphere = PhotonPattern::from_point({0, 0, 0}, {0, 0, 1}, 2);
    sphere.set_spacing(0.1, 0.4, 1);
    EXPECT_NEAR(sum_of_power(sphere), 4 * kPi, 1e-3);

    PhotonPattern disc = PhotonPattern::parallel({0, 0, -1}, 5, {0, 0, 0}, 3);
    disc.set_spacing(0.1, 0.4, 1);
    EXPECT_NEAR(sum_of_power(disc), 9 * kPi, 1e-3);
    for (std::uint32_t ring = 0; ring < disc.ring_count(); ++ring) {
        const BatchPhoton p = disc.photon(ring, 0);
        EXPECT_NEAR(p.origin.z, 5, 1e-5F);
        EXPECT_LE(std::hypot(p.origin.x, p.origin.y), 3.05F);
    }
}

// All directions lie in the cap, jitter aside, and no two patterns of different seeds are the same.
TEST(PhotonPattern, PhotonsStayInTheCap) {
    PhotonPattern cap = PhotonPattern::from_point({0, 0, 0}, {4, 0, 0}, 1);
    cap.set_spacing(0.1, 0.4, 1);
    PhotonPattern other = cap;
    other.set_spacing(0.1, 0.4, 2);
    bool differs = false;
    for (std::uint32_t ring = 0; ring < cap.ring_count(); ++ring) {
        for (std::uint32_t i = 0; i < cap.count_in(ring); ++i) {
            const Vec3 d = cap.photon(ring, i).direction;
            EXPECT_NEAR(length(d), 1, 1e-5F);
            EXPECT_GT(d.x, std::cos(std::asin(0.25F) + 0.02F));
            differs = differs || !(d == other.photon(ring, i).direction);
        }
    }
    EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace sundog::cpu
