// SPDX-License-Identifier: Apache-2.0
// Laws that every reflection model obeys: reciprocity, energy, and directions drawn with the density that is told.
#include "kernel/bsdf/bsdf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "compile/bsdf_tables.h"
#include "kernel/sequences.h"

namespace sundog::kernel {
namespace {

constexpr float kPi = 3.14159265F;

struct Model {
    std::string name;
    uint kind;
    BsdfPoint point;
    bool white = false;  ///< Sends back all light, within 1%.
};

BsdfPoint blank() {
    BsdfPoint p{};
    p.color = real3(1.0F);
    p.alpha_x = p.alpha_y = 0.3F;
    p.n = real3(0.2F, 0.9F, 1.1F);
    p.k = real3(3.9F, 2.4F, 2.2F);
    p.eta = 1 / 1.5F;
    Principled& q = p.principled;
    q.base = real3(1.0F);
    q.alpha_x = q.alpha_y = 0.25F;
    q.roughness = 0.5F;
    q.f0 = real3(0.04F);
    q.f90 = 1;
    q.eta = 1 / 1.5F;
    q.thin = false;
    q.coat_alpha = 0.01F;
    q.coat_normal = real3(0, 0, 1);
    q.film_ior = 1.3F;
    q.film_nm = 400;
    return p;
}

Model with(std::string name, uint kind, float alpha_x, float alpha_y) {
    Model m{std::move(name), kind, blank()};
    m.point.alpha_x = alpha_x;
    m.point.alpha_y = alpha_y;
    return m;
}

Model principled(std::string name, float roughness) {
    Model m{std::move(name), BSDF_PRINCIPLED, blank()};
    Principled& q = m.point.principled;
    q.roughness = roughness;
    q.alpha_x = q.alpha_y = roughness * roughness;
    return m;
}

std::vector<Model> models() {
    std::vector<Model> all{
        with("Oren-Nayar, smooth", BSDF_OREN_NAYAR, 0, 0),
        with("Oren-Nayar, rough", BSDF_OREN_NAYAR, 0.6F, 0),
        with("Phong, wide", BSDF_PHONG, 3, 0),
        with("Phong, sharp", BSDF_PHONG, 60, 0),
        with("Blinn-Phong, wide", BSDF_BLINN_PHONG, 5, 0),
        with("Blinn-Phong, sharp", BSDF_BLINN_PHONG, 200, 0),
        with("Ward, brushed", BSDF_WARD, 0.15F, 0.5F),
        with("Cook-Torrance", BSDF_COOK_TORRANCE, 0.3F, 0),
        with("Beckmann", BSDF_BECKMANN, 0.3F, 0.3F),
        with("Beckmann, brushed", BSDF_BECKMANN, 0.6F, 0.2F),
        with("GGX metal", BSDF_CONDUCTOR, 0.3F, 0.3F),
        with("GGX metal, brushed", BSDF_CONDUCTOR, 0.1F, 0.6F),
        with("rough glass", BSDF_DIELECTRIC, 0.3F, 0.3F),
    };
    Model inside = with("rough glass, from inside", BSDF_DIELECTRIC, 0.2F, 0.2F);
    inside.point.eta = 1.5F;
    all.push_back(inside);

    for (const float roughness : {0.2F, 0.6F, 1.0F}) {
        Model plastic = principled("white plastic of roughness " + std::to_string(roughness), roughness);
        plastic.white = true;
        all.push_back(plastic);
        Model metal = principled("white metal of roughness " + std::to_string(roughness), roughness);
        metal.point.principled.metallic = 1;
        metal.point.principled.f0 = real3(1.0F);
        metal.white = true;
        all.push_back(metal);
    }
    Model gold = principled("brushed gold", 0.5F);
    gold.point.principled.metallic = 1;
    gold.point.principled.f0 = real3(1.0F, 0.77F, 0.34F);
    gold.point.principled.alpha_x = 0.6F;
    gold.point.principled.alpha_y = 0.15F;
    all.push_back(gold);
    Model coated = principled("coated", 0.7F);
    coated.point.principled.coat = 1;
    coated.point.principled.coat_alpha = 0.04F;
    all.push_back(coated);
    Model cloth = principled("cloth", 0.9F);
    cloth.point.principled.sheen = real3(0.8F, 0.6F, 0.9F);
    cloth.point.principled.sheen_roughness = 0.4F;
    cloth.point.principled.base = real3(0.3F);
    all.push_back(cloth);
    Model film = principled("iridescent", 0.4F);
    film.point.principled.film = 1;
    all.push_back(film);
    Model glass = principled("principled glass", 0.5F);
    glass.point.principled.transmission = 1;
    all.push_back(glass);
    Model half = principled("half of it glass, a thin wall", 0.5F);
    half.point.principled.transmission = 0.5F;
    half.point.principled.thin = true;
    all.push_back(half);
    return all;
}

class Bsdf : public testing::Test {
protected:
    Bsdf() {
        tables_.insert(tables_.end(), bsdf_tables().begin(), bsdf_tables().end());
        scene_.tables = tables_.data();
    }

    real3 value(const Model& m, real3 to_eye, real3 to_light, float* density = nullptr) {
        real3 v(0.0F);
        float d = 0;
        bsdf_value(scene_, m.kind, m.point, to_eye, to_light, v, d);
        if (density) *density = d;
        return v;
    }
    real3 direction(const Model& m, real3 to_eye, uint i, uint seed) {
        const PathSample path{seed, i};
        return bsdf_direction(scene_, m.kind, m.point, to_eye, sample_pair(path, 0), sample_pair(path, 1).x);
    }

    std::vector<float> tables_ = std::vector<float>(BSDF_TABLES_FIRST);
    SceneView scene_{};
};

real3 direction_of(float cosine_there, float azimuth) {
    const float s = std::sqrt(1 - cosine_there * cosine_there);
    return {s * std::cos(azimuth), s * std::sin(azimuth), cosine_there};
}

const std::array<real3, 4> kEyes{direction_of(0.99F, 0.4F), direction_of(0.8F, 2), direction_of(0.4F, 4.2F),
                                 direction_of(0.12F, 5.5F)};

// Light goes its way both ways. Catches a cosine or a shadowing that belongs to one side alone, and frames of mixed-up
// axes.
TEST_F(Bsdf, IsReciprocal) {
    for (const Model& m : models()) {
        for (uint i = 0; i < 200; ++i) {
            const real2 a = sample_pair({1, i}, 0), b = sample_pair({1, i}, 1);
            const real3 v = direction_of(0.05F + 0.95F * a.x, 2 * kPi * a.y);
            const real3 w = direction_of(0.05F + 0.95F * b.x, 2 * kPi * b.y);
            const real3 there = value(m, v, w) * (1 / w.z), back = value(m, w, v) * (1 / v.z);
            for (const auto& [x, y] : {std::pair{there.x, back.x}, {there.y, back.y}, {there.z, back.z}})
                EXPECT_NEAR(x, y, 2e-3F * (1e-2F + std::max(x, y))) << m.name;
        }
    }
}

// A furnace whose walls shine evenly: nothing in it is brighter than they are, and white things are as bright. Catches
// wrong normalisations, and energy that is lost between facets.
TEST_F(Bsdf, KeepsEnergy) {
    constexpr uint kCount = 20000;
    for (const Model& m : models()) {
        for (const real3& to_eye : kEyes) {
            std::array<double, 3> sum{};
            for (uint i = 0; i < kCount; ++i) {
                const real3 w = direction(m, to_eye, i, 7);
                float density = 0;
                const real3 v = value(m, to_eye, w, &density);
                if (!(density > 0)) continue;
                sum[0] += v.x / density, sum[1] += v.y / density, sum[2] += v.z / density;
            }
            for (const double channel : sum) {
                EXPECT_LE(channel / kCount, 1.01) << m.name << ", cosine " << to_eye.z;
                if (m.white) {
                    EXPECT_NEAR(channel / kCount, 1, 0.01) << m.name << ", cosine " << to_eye.z;
                }
            }
        }
    }
}

constexpr int kRows = 12, kColumns = 16;

/// Shares of directions in each of the cells that are even in the cosine (-1 to 1) and around.
std::vector<double> drawn_shares(const std::vector<real3>& directions, double& inside) {
    std::vector<double> shares(kRows * kColumns);
    inside = 0;
    for (const real3& w : directions) {
        const int row = std::min(static_cast<int>((w.z + 1) / 2 * kRows), kRows - 1);
        const float around = std::atan2(w.y, w.x) / (2 * kPi) + 0.5F;
        const int column = std::min(static_cast<int>(around * kColumns), kColumns - 1);
        shares[static_cast<std::size_t>(row * kColumns + column)] += 1;
        inside += 1;
    }
    return shares;
}

// Directions come as often as their density says, cell by cell (Pearson's chi-square over cells that expect 10 and
// more, at five standard deviations). Catches a density that misses a Jacobian or a lobe's share, and directions that
// never come where it says so. Where nothing can come (density 0) directions are left out, as integrators leave them.
TEST_F(Bsdf, DrawsByItsDensity) {
    constexpr uint kCount = 40000;
    constexpr int kFine = 40;  // Places a cell's side at which the density is asked.
    for (const Model& m : models()) {
        for (const real3& to_eye : kEyes) {
            std::vector<real3> directions;
            for (uint i = 0; i < kCount; ++i) {
                // Independent numbers: a sequence that is more even than chance would pass too easily.
                const PathSample path{11, i};
                const real2 u(sample_hash(path, 0), sample_hash(path, 1));
                const real3 w = bsdf_direction(scene_, m.kind, m.point, to_eye, u, sample_hash(path, 2));
                float density = 0;
                value(m, to_eye, w, &density);
                if (density > 0) directions.push_back(w);
            }
            double inside = 0;
            const std::vector<double> drawn = drawn_shares(directions, inside);
            double chi_square = 0, expected_sum = 0;
            int cells = 0;
            for (int row = 0; row < kRows; ++row)
                for (int column = 0; column < kColumns; ++column) {
                    double mean = 0;
                    for (int i = 0; i < kFine; ++i)
                        for (int j = 0; j < kFine; ++j) {
                            const float c = -1 + 2 * (row + (i + 0.5F) / kFine) / kRows;
                            const float around = ((column + (j + 0.5F) / kFine) / kColumns - 0.5F) * 2 * kPi;
                            float density = 0;
                            value(m, to_eye, direction_of(c, around), &density);
                            mean += density;
                        }
                    const double expected = mean / (kFine * kFine) * 4 * kPi / (kRows * kColumns) * kCount;
                    expected_sum += expected;
                    if (expected < 10) continue;
                    const double off = drawn[static_cast<std::size_t>(row * kColumns + column)] - expected;
                    chi_square += off * off / expected;
                    ++cells;
                }
            EXPECT_NEAR(expected_sum, inside, 0.02 * kCount) << m.name << ", cosine " << to_eye.z;
            // Cells whose expectation the places above only estimate get a little leave.
            EXPECT_LT(chi_square, cells + 5 * std::sqrt(2.0 * cells) + 0.2 * cells)
                << m.name << ", cosine " << to_eye.z << ", " << cells << " cells";
        }
    }
}

}  // namespace
}  // namespace sundog::kernel
