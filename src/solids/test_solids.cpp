// SPDX-License-Identifier: Apache-2.0
#include "solids/test_solids.h"

#include <cmath>

namespace sundog::solids::tests {

SolidPointer inverted(const SolidPointer& solid) {
    auto copy = std::make_shared<scene::Solid>(*solid);
    copy->inverted = !copy->inverted;
    return copy;
}
SolidPointer moved(const SolidPointer& solid, const Affine3d& by) {
    auto copy = std::make_shared<scene::Solid>(*solid);
    copy->parent_from_shape = by * copy->parent_from_shape;
    return copy;
}
SolidPointer group(scene::SolidGroup::Kind kind, std::vector<SolidPointer> children) {
    return pointer_to(scene::SolidGroup{kind, std::move(children)});
}
SolidPointer united(std::vector<SolidPointer> children) {
    return group(scene::SolidGroup::Kind::combined, std::move(children));
}
SolidPointer merged(std::vector<SolidPointer> children) {
    return group(scene::SolidGroup::Kind::merged, std::move(children));
}
SolidPointer intersected(std::vector<SolidPointer> children) {
    return group(scene::SolidGroup::Kind::common, std::move(children));
}
SolidPointer difference(std::vector<SolidPointer> children) {
    for (std::size_t i = 1; i < children.size(); ++i) children[i] = inverted(children[i]);
    return intersected(std::move(children));
}

Affine3d turned(Vec3d axis, double angle, Vec3d move) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto column = [&](Vec3d e) { return e * c + cross(axis, e) * s + axis * (dot(axis, e) * (1 - c)); };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1}), move};
}
Affine3d scaled(Vec3d f) { return {{f.x, 0, 0}, {0, f.y, 0}, {0, 0, f.z}, {}}; }

std::vector<Hit> all_hits(const CompiledSolid& solid, const Ray& ray, Range range) {
    std::vector<Hit> hits;
    while (hits.size() < 1000) {
        const std::optional<Hit> hit = solid.nearest(ray, range);
        if (!hit) break;
        hits.push_back(*hit);
        range.lower = hit->t + 1e-9 * (1 + std::abs(hit->t));
    }
    return hits;
}

void expect_solid_properties(const scene::Solid& solid, unsigned seed, const Expectations& e) {
    const auto compiled = compile_solid(solid, 7);
    RandomRays random(seed);
    int met = 0;
    int wrong = 0;
    for (int i = 0; i < e.rays; ++i) {
        const Ray ray = random.ray(e.reach);
        const double speed = length(ray.direction);
        bool is_inside = compiled->inside(ray.origin);
        double last_t = 0;
        const std::vector<Hit> hits = all_hits(*compiled, ray);
        EXPECT_EQ(!hits.empty(), compiled->any(ray, {}));
        for (const Hit& hit : hits) {
            ++met;
            EXPECT_NEAR(1, length(hit.normal), 1e-9);
            EXPECT_EQ(7U, hit.material);
            EXPECT_TRUE(contains(padded(compiled->bounds()), ray.at(hit.t))) << "ray " << i << " t " << hit.t;
            if (e.alternates) {
                // Halfway between two surfaces the state must be what their number says.
                const bool between = compiled->inside(ray.at(0.5 * (last_t + hit.t)));
                if ((hit.t - last_t) * speed > 4 * e.surface_error && between != is_inside) ++wrong;
                if ((dot(hit.normal, ray.direction) < 0) == is_inside) ++wrong;
                const double step = e.surface_error / speed;
                if (hit.t - last_t > 4 * step && compiled->inside(ray.at(hit.t - 2 * step)) != is_inside) ++wrong;
                is_inside = !is_inside;
            }
            last_t = hit.t;
        }
    }
    EXPECT_GT(met, e.rays / 10) << "too few rays met the solid for the test to say anything";
    EXPECT_EQ(0, wrong) << "of " << met << " hits";
}

void expect_normals_agree(const scene::Solid& solid, unsigned seed, double reach, double step) {
    const auto compiled = compile_solid(solid, 0);
    RandomRays random(seed);
    int asked = 0;
    int agreed = 0;
    for (int i = 0; i < 300; ++i) {
        const Ray ray = random.ray(reach);
        const std::optional<Hit> hit = compiled->nearest(ray, {});
        if (!hit) continue;
        for (int k = 0; k < 4; ++k) {
            const Vec3d off = random.point(1);
            const double along_normal = dot(off, hit->normal);
            if (std::abs(along_normal) < 0.2) continue;
            ++asked;
            if (compiled->inside(ray.at(hit->t) + off * step) == (along_normal < 0)) ++agreed;
        }
    }
    EXPECT_GT(asked, 50);
    // Near edges two faces meet, and neither's plane tells all.
    EXPECT_GT(agreed, 0.97 * asked) << "of " << asked;
}

}  // namespace sundog::solids::tests
