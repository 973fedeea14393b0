// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/hemisphere.h"

#include <algorithm>
#include <cmath>

namespace sundog::cpu {
namespace {

/// Rays are followed by so many at a time on the widest processors: the last packet is filled up.
constexpr int kPacket = 16;

Vec3 around_z(float turn) { return {std::cos(turn), std::sin(turn), 0}; }

void add(std::array<Vec3, 3>& gradient, Vec3 direction, Vec3 change) {
    gradient[0] += direction * change.x;
    gradient[1] += direction * change.y;
    gradient[2] += direction * change.z;
}

}  // namespace

Hemisphere::Frame::Frame(Vec3 normal) : z(normal) {
    // Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017
    const float sign = std::copysign(1.0F, z.z);
    const float a = -1 / (sign + z.z);
    const float b = z.x * z.y * a;
    x = {1 + sign * z.x * z.x * a, sign * b, -sign * z.x};
    y = {b, sign + z.y * z.y * a, -z.y};
}

Hemisphere::Hemisphere(int count)
    : rings_(std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<float>(count) / kPi))))) {
    const int packets = (std::max(count, 1) + kPacket - 1) / kPacket;
    sectors_ = packets * kPacket / rings_;
    for (int sector = 0; sector < sectors_; ++sector) {
        const float turn = 2 * kPi * (static_cast<float>(sector) + 0.5F) / static_cast<float>(sectors_);
        for (int ring = 0; ring < rings_; ++ring) {
            const float square = (static_cast<float>(ring) + 0.5F) / static_cast<float>(rings_);
            Vec3 d = around_z(turn) * std::sqrt(square);
            d.z = std::sqrt(1 - square);
            directions_.push_back(d);
        }
    }
}

void Hemisphere::integrate(std::span<const BatchAnswer> answers, const Frame& axes, IrradianceSample& sample) const {
    const auto at = [&](int ring, int sector) -> const BatchAnswer& {
        return answers[static_cast<std::size_t>(sector * rings_ + ring)];
    };
    const auto sectors = static_cast<float>(sectors_);
    const auto rings = static_cast<float>(rings_);
    const auto share = 1 / (rings * sectors);
    double nearness = 0;
    Vec3 sum;
    std::array<Vec3, 3> by_move{};
    std::array<Vec3, 3> by_turn{};
    for (int k = 0; k < sectors_; ++k) {
        const int before = k == 0 ? sectors_ - 1 : k - 1;
        const float turn = 2 * kPi * (static_cast<float>(k) + 0.5F) / sectors;
        const Vec3 outwards = around_z(turn);
        const Vec3 along = around_z(turn + kPi / 2);
        const Vec3 across = around_z(2 * kPi * static_cast<float>(k) / sectors + kPi / 2);
        for (int j = 0; j < rings_; ++j) {
            const BatchAnswer& here = at(j, k);
            sum += here.radiance;
            nearness += 1.0 / std::max(static_cast<double>(here.distance), 1e-30);
            const float square = (static_cast<float>(j) + 0.5F) / rings;
            add(by_turn, along, here.radiance * (share * std::sqrt(square / (1 - square))));
            const float inner = static_cast<float>(j) / rings;  // squares of the sines at the ring's borders
            const float outer = static_cast<float>(j + 1) / rings;
            if (j > 0) {
                const BatchAnswer& inwards = at(j - 1, k);
                const float nearest = std::max(std::min(here.distance, inwards.distance), 1e-30F);
                add(by_move, outwards,
                    (here.radiance - inwards.radiance) * (2 / sectors * std::sqrt(inner) * (1 - inner) / nearest));
            }
            const BatchAnswer& beside = at(j, before);
            const float nearest = std::max(std::min(here.distance, beside.distance), 1e-30F);
            add(by_move, across,
                (here.radiance - beside.radiance) * ((std::sqrt(outer) - std::sqrt(inner)) / (kPi * nearest)));
        }
    }
    sample.light = sum * share;
    sample.reach = static_cast<float>(std::min(1 / (nearness * static_cast<double>(share)), 1e30));
    for (std::size_t i = 0; i < 3; ++i) {
        sample.by_move[i] = axes.to_world(by_move[i]);
        sample.by_turn[i] = axes.to_world(by_turn[i]);
    }
}

}  // namespace sundog::cpu
