// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/photon_map.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace sundog::cpu {
namespace {

/// Photons of a leaf, at most.
constexpr std::size_t kLeaf = 32;
/// Fewer are sorted by one thread.
constexpr std::size_t kSerial = 8192;
/// Photons off a surface's plane: further squares of the distance from it that count.
constexpr float kFlattening = 15;
constexpr std::size_t kMostLevels = 40;
/// Cosine between surfaces whose photons count for each other, at least.
constexpr float kLeastAlike = 0.5F;
/// Of how many photons the surroundings are looked at.
constexpr std::size_t kSamples = 256;
constexpr std::uint32_t kNone = 0xffffffffU;

float squared(float x) { return x * x; }

/// A photon that was found: ordered by the square of its distance, and then by its number. (The bits of floats from 0
/// up are ordered as they are.)
std::uint64_t key_of(float distance, std::size_t photon) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(distance)} << 32U | photon;
}
float distance_of(std::uint64_t key) { return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32U)); }

}  // namespace

PhotonMap::PhotonMap(std::vector<StoredPhoton> photons) : photons_(std::move(photons)) {
    while (photons_.size() > kLeaf << levels_) ++levels_;
    nodes_.resize((std::size_t{1} << levels_) - 1);
    build(0, 0, photons_.size(), 0);
    for (std::vector<float>* axis : {&places_.x, &places_.y, &places_.z}) axis->reserve(photons_.size() + kLeaf);
    for (const StoredPhoton& photon : photons_) {
        places_.x.push_back(photon.position.x);
        places_.y.push_back(photon.position.y);
        places_.z.push_back(photon.position.z);
    }
    for (std::vector<float>* axis : {&places_.x, &places_.y, &places_.z}) axis->resize(photons_.size() + kLeaf);
}

void PhotonMap::build(std::size_t node, std::size_t begin, std::size_t end, std::size_t level) {
    if (level == levels_) return;
    Bounds3 bounds;
    for (std::size_t i = begin; i < end; ++i) bounds.include(photons_[i].position);
    const Vec3 extent = bounds.extent();
    const std::uint32_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto along = [axis](const StoredPhoton& p) {
        return axis == 0 ? p.position.x : axis == 1 ? p.position.y : p.position.z;
    };
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return photons_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](const StoredPhoton& a, const StoredPhoton& b) { return along(a) < along(b); });
    nodes_[node] = {along(photons_[middle]), axis};
    const auto left = [&] { build(2 * node + 1, begin, middle, level + 1); };
    const auto right = [&] { build(2 * node + 2, middle, end, level + 1); };
    if (end - begin < kSerial) {
        left();
        right();
    } else {
        tbb::parallel_invoke(left, right);
    }
}

void PhotonMap::collect(const Search& search, float radius, Scratch& scratch) const {
    struct Waiting {
        std::size_t node, begin, end, level;
        std::array<float, 3> off;  ///< Squared along each axis: how far away the box of the node is at least.
        float distance;            ///< Squared, at least.
    };
    std::vector<std::uint64_t>& found = scratch.candidates;
    found.clear();
    const bool flat = !(search.normal == Vec3{});
    const float flattening = flat ? kFlattening : 0;
    const Vec3 p = search.point, n = search.normal;
    const auto most = static_cast<std::size_t>(search.most);
    const auto keep_nearest = [&] {
        if (found.size() <= most) return;
        std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(most - 1), found.end());
        found.resize(most);
    };
    // What lies `off` beyond a plane across an axis is at least so many times off^2 away: the least of
    // d^2 + k (d n)^2 on that plane, a hair less for what is rounded.
    const auto stretched = [&](float along) {
        return 0.9999F / (1 - flattening / (1 + flattening) * std::min(along * along, 1.0F));
    };
    const std::array<float, 3> point{p.x, p.y, p.z};
    const std::array<float, 3> stretch{stretched(n.x), stretched(n.y), stretched(n.z)};
    float limit = radius * radius;
    std::array<Waiting, kMostLevels> waiting;
    std::size_t waiting_count = 0;
    Waiting at{0, 0, photons_.size(), 0, {}, 0};
    for (;;) {
        while (at.level < levels_) {
            const Node& node = nodes_[at.node];
            const std::size_t middle = at.begin + (at.end - at.begin) / 2;
            const std::size_t left = 2 * at.node + 1;
            ++at.level;
            const float off = point[node.axis] - node.split;
            const float square = off * off;
            const float sum = at.off[0] + at.off[1] + at.off[2] - at.off[node.axis] + square;
            const float distance = std::max({at.distance, 0.9999F * sum, square * stretch[node.axis]});
            const bool is_left = off < 0;
            if (distance <= limit) {
                Waiting& far = waiting[waiting_count++];
                far.node = is_left ? left + 1 : left;
                far.begin = is_left ? middle : at.begin;
                far.end = is_left ? at.end : middle;
                far.level = at.level;
                far.off = at.off;
                far.off[node.axis] = square;
                far.distance = distance;
            }
            at.node = is_left ? left : left + 1;
            (is_left ? at.end : at.begin) = middle;
        }
        std::array<float, kLeaf> distance;
        for (std::size_t lane = 0; lane < kLeaf; ++lane) {
            const float x = places_.x[at.begin + lane] - p.x;
            const float y = places_.y[at.begin + lane] - p.y;
            const float z = places_.z[at.begin + lane] - p.z;
            distance[lane] = x * x + y * y + z * z + flattening * squared(x * n.x + y * n.y + z * n.z);
        }
        for (std::size_t lane = 0; lane < at.end - at.begin; ++lane) {
            const std::size_t i = at.begin + lane;
            if (distance[lane] > limit) continue;
            if (flat && dot(photons_[i].normal, n) < kLeastAlike) continue;
            found.push_back(key_of(distance[lane], i));
        }
        if (found.size() >= 2 * most) {
            keep_nearest();
            limit = std::min(limit, distance_of(found.back()));
        }
        do {
            if (waiting_count == 0) {
                keep_nearest();
                return;
            }
            at = waiting[--waiting_count];
        } while (at.distance > limit);
    }
}

PhotonMap::Found PhotonMap::find(const Search& search, Scratch& scratch) const {
    Found out;
    out.radius = search.radius;
    if (photons_.empty()) return out;
    const auto most = static_cast<std::size_t>(search.most);
    bool done = false;
    if (scratch.last_radius >= 0) {
        // About as far as where the last search was, and what lies in between.
        const float reach = (scratch.last_radius + length(search.point - scratch.last_point)) * 1.1F;
        if (reach < search.radius) {
            collect(search, reach, scratch);
            done = scratch.candidates.size() >= most;
        }
    }
    if (!done) collect(search, search.radius, scratch);
    const std::vector<std::uint64_t>& found = scratch.candidates;
    out.count = static_cast<int>(found.size());
    const bool full = found.size() >= most;
    const float last = found.empty() ? 0 : distance_of(*std::max_element(found.begin(), found.end()));
    if (full) out.radius = std::sqrt(last);
    scratch.last_point = search.point;
    scratch.last_radius = full ? out.radius : -1;
    // By their numbers, so that the sum's bits don't depend on where the search started.
    std::vector<std::uint32_t>& photons = scratch.photons;
    photons.clear();
    std::uint32_t halved = kNone;
    for (const std::uint64_t key : found) {
        const auto number = static_cast<std::uint32_t>(key);
        photons.push_back(number);
        if (full && distance_of(key) == last && found.size() > 1) halved = std::min(halved, number);
    }
    std::sort(photons.begin(), photons.end());
    for (const std::uint32_t number : photons) {
        const StoredPhoton& photon = photons_[number];
        const bool half = number == halved;
        out.power = out.power + photon.power * (half ? 0.5F : 1.0F);
        const Vec3& p = photon.power;
        out.toward = out.toward - photon.direction * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
    }
    return out;
}

float PhotonMap::typical_radius(int most) const {
    if (photons_.empty()) return 0;
    std::vector<float> radii;
    Scratch scratch;
    const std::size_t samples = std::min(kSamples, photons_.size());
    for (std::size_t i = 0; i < samples; ++i) {
        const StoredPhoton& photon = photons_[i * photons_.size() / samples];
        collect({photon.position, {}, most, 0}, 1e18F, scratch);
        const auto& found = scratch.candidates;
        const float last = found.empty() ? 0 : distance_of(*std::max_element(found.begin(), found.end()));
        radii.push_back(std::sqrt(last));
    }
    std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
    return radii[radii.size() / 2];
}

}  // namespace sundog::cpu
