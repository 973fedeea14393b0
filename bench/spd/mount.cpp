// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include "spd/builder.h"
#include "spd/spd.h"

namespace sundog::bench {
namespace {

constexpr int kSide = 64;

/// Heights on a square of (kSide + 1)^2 points by midpoint displacement (Fournier, Fussell and Carpenter, "Computer
/// Rendering of Stochastic Models", Communications of the ACM 1982).
class Heights {
public:
    Heights() : values_(static_cast<std::size_t>((kSide + 1) * (kSide + 1)), 0.0F) {
        float spread = 0.55F;
        at(kSide / 2, kSide / 2) = 0.9F;
        for (int step = kSide; step > 1; step /= 2, spread *= 0.55F) refine(step, spread);
    }
    [[nodiscard]] float operator()(int x, int y) const {
        return values_[static_cast<std::size_t>(y * (kSide + 1) + x)];
    }

private:
    float& at(int x, int y) { return values_[static_cast<std::size_t>(y * (kSide + 1) + x)]; }
    float moved(float height, float spread) { return height + spread * (random_.next() - 0.5F); }

    /// Sets the points between those that are `step` apart: the squares' edges, then their middles.
    void refine(int step, float spread) {
        const int half = step / 2;
        for (int y = 0; y <= kSide; y += step)
            for (int x = half; x < kSide; x += step) at(x, y) = moved((at(x - half, y) + at(x + half, y)) / 2, spread);
        for (int y = half; y < kSide; y += step)
            for (int x = 0; x <= kSide; x += step) at(x, y) = moved((at(x, y - half) + at(x, y + half)) / 2, spread);
        for (int y = half; y < kSide; y += step)
            for (int x = half; x < kSide; x += step) {
                if (step == kSide) continue;  // the summit stands
                at(x, y) = moved((at(x - half, y) + at(x + half, y) + at(x, y - half) + at(x, y + half)) / 4, spread);
            }
    }

    std::vector<float> values_;
    SteadyRandom random_;
};

}  // namespace

scene::Scene spd_mount() {
    SceneBuilder scene("mount");
    scene.eye({-1.6F, 1.6F, 1.7F}, {0, 0, 0});
    scene.light({-100, -100, 100}, 1);
    const std::uint32_t rock = scene.material({0.5F, 0.45F, 0.35F});
    const std::uint32_t glass = scene.material({0.1F, 0.1F, 0.1F}, 0.1F, true);
    const Heights heights;
    scene::Mesh mountain;
    const auto point = [&](int x, int y) {
        return Vec3{2.0F * static_cast<float>(x) / kSide - 1, 2.0F * static_cast<float>(y) / kSide - 1, heights(x, y)};
    };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            add_triangle(mountain, point(x, y), point(x + 1, y), point(x, y + 1), rock);
            add_triangle(mountain, point(x + 1, y), point(x + 1, y + 1), point(x, y + 1), rock);
        }
    scene.mesh(std::move(mountain));
    for (const Vec3 at :
         {Vec3{-0.8F, 0.8F, 1.21F}, Vec3{-0.66F, 0.66F, 0.93F}, Vec3{-0.75F, 0.99F, 0.93F}, Vec3{-0.99F, 0.75F, 0.93F}})
        scene.sphere(at, 0.17F, glass);
    return scene.take();
}

}  // namespace sundog::bench
