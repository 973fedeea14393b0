// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/photon_map.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sundog::cpu {
namespace {

/// Photons of a leaf, at most.
constexpr std::size_t kLeaf = 8;
/// Fewer are sorted by one thread.
constexpr std::size_t kSerial = 8192;
/// Photons off a surface's plane: further squares of the distance from it that count.
constexpr float kFlattening = 15;
constexpr std::size_t kMostLevels = 40;
/// Cosine between surfaces whose photons count for each other, at least.
constexpr float kLeastAlike = 0.5F;
/// Of how many photons the surroundings are looked at.
constexpr std::size_t kSamples = 256;

float squared(float x) { return x * x; }

}  // namespace

PhotonMap::PhotonMap(std::vector<StoredPhoton> photons) : photons_(std::move(photons)) {
    while (photons_.size() > kLeaf << levels_) ++levels_;
    nodes_.resize((std::size_t{1} << levels_) - 1);
    build(0, 0, photons_.size(), 0);
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
        float distance;  ///< Squared, at least.
    };
    std::vector<Scratch::Candidate>& found = scratch.candidates;
    found.clear();
    const bool flat = !(search.normal == Vec3{});
    const auto most = static_cast<std::size_t>(search.most);
    const auto nearer = [](const Scratch::Candidate& a, const Scratch::Candidate& b) {
        return a.distance < b.distance || (a.distance == b.distance && a.photon < b.photon);
    };
    const auto keep_nearest = [&] {
        if (found.size() <= most) return;
        std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(most - 1), found.end(), nearer);
        found.resize(most);
    };
    float limit = radius * radius;
    std::array<Waiting, kMostLevels> waiting;
    std::size_t waiting_count = 0;
    Waiting at{0, 0, photons_.size(), 0, 0};
    for (;;) {
        while (at.level < levels_) {
            const Node& node = nodes_[at.node];
            const Vec3& p = search.point;
            const float off = (node.axis == 0 ? p.x : node.axis == 1 ? p.y : p.z) - node.split;
            const std::size_t middle = at.begin + (at.end - at.begin) / 2;
            Waiting left{2 * at.node + 1, at.begin, middle, at.level + 1, at.distance};
            Waiting right{2 * at.node + 2, middle, at.end, at.level + 1, at.distance};
            Waiting& far = off < 0 ? right : left;
            far.distance = std::max(at.distance, off * off);
            if (far.distance <= limit) waiting[waiting_count++] = far;
            at = off < 0 ? left : right;
        }
        for (std::size_t i = at.begin; i < at.end; ++i) {
            const StoredPhoton& photon = photons_[i];
            const Vec3 d = photon.position - search.point;
            float distance = dot(d, d);
            if (distance > limit) continue;
            if (flat) {
                distance += kFlattening * squared(dot(d, search.normal));
                if (distance > limit || dot(photon.normal, search.normal) < kLeastAlike) continue;
            }
            found.push_back({distance, static_cast<std::uint32_t>(i)});
        }
        if (found.size() >= 2 * most) {
            keep_nearest();
            limit = std::min(limit, std::max_element(found.begin(), found.end(), nearer)->distance);
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
    std::vector<Scratch::Candidate>& found = scratch.candidates;
    out.count = static_cast<int>(found.size());
    const bool full = found.size() >= most;
    float last = 0;
    for (const Scratch::Candidate& c : found) last = std::max(last, c.distance);
    if (full) out.radius = std::sqrt(last);
    scratch.last_point = search.point;
    scratch.last_radius = full ? out.radius : -1;
    // By their numbers, so that the sum's bits don't depend on where the search started.
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.photon < b.photon; });
    bool halved = false;
    for (const Scratch::Candidate& c : found) {
        const StoredPhoton& photon = photons_[c.photon];
        const bool half = full && !halved && c.distance == last && found.size() > 1;
        halved = halved || half;
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
        float last = 0;
        for (const Scratch::Candidate& c : scratch.candidates) last = std::max(last, c.distance);
        radii.push_back(std::sqrt(last));
    }
    std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
    return radii[radii.size() / 2];
}

}  // namespace sundog::cpu
