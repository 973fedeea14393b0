// SPDX-License-Identifier: Apache-2.0
#include "compile/emitters.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/srgb.h"
#include "compile/alias_table.h"
#include "compile/convert.h"

namespace sundog {
namespace {

constexpr double kPiExact = std::numbers::pi;
/// Directions towards the environment are drawn by cells of at most so many a row.
constexpr std::uint32_t kMostCells = 512;

Vec3 to_vec(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

Vec3 placed(const kernel::Instance& i, const kernel::vec3& p) {
    return to_vec(i.world_from_object_x) * p.x + to_vec(i.world_from_object_y) * p.y +
           to_vec(i.world_from_object_z) * p.z + to_vec(i.world_from_object_t);
}

double triangle_area(const RenderScene& scene, std::uint32_t triangle, const kernel::Instance* instance) {
    const kernel::Triangle& t = scene.triangles[triangle];
    const auto corner = [&](std::uint32_t p) {
        return instance ? placed(*instance, scene.positions[p]) : to_vec(scene.positions[p]);
    };
    const Vec3 a = corner(t.p0);
    return 0.5 * length(cross(corner(t.p1) - a, corner(t.p2) - a));
}

/// Radius of the ball around everything; 1 where there is nothing.
double scene_radius(const RenderScene& scene) {
    if (scene.bounds.empty()) return 1;
    const double radius = 0.5 * length(scene.bounds.upper - scene.bounds.lower);
    return radius > 0 && std::isfinite(radius) ? radius : 1;
}

/// Mean luminance of the environment over all directions.
double mean_luminance(const scene::Environment& e) {
    double sum = 0, weight = 0;
    for (std::uint32_t y = 0; y < e.height; ++y) {
        const double sine = std::sin((y + 0.5) / e.height * kPiExact);
        for (std::uint32_t x = 0; x < e.width; ++x) sum += sine * luminance(e.radiance[std::size_t{y} * e.width + x]);
        weight += sine * e.width;
    }
    return weight > 0 ? sum / weight * e.gain : 0;
}

}  // namespace

float emission_power(Vec3 emission, scene::Index number, std::span<const scene::Texture> textures) {
    const float own = luminance(emission);
    if (!(own > 0) || !std::isfinite(own)) return 0;
    if (number >= textures.size() || textures[number].rgba8.empty()) return own;
    const scene::Texture& texture = textures[number];
    const auto channel = [&](std::uint32_t texel, unsigned shift) {
        const std::uint32_t stored = (texel >> shift) & 255U;
        return texture.srgb ? linear_of_srgb8()[stored] : static_cast<float>(stored) / 255;
    };
    double sum = 0;
    for (const std::uint32_t texel : texture.rgba8)
        sum += luminance(Vec3{channel(texel, 0), channel(texel, 8), channel(texel, 16)} * emission);
    return static_cast<float>(sum / static_cast<double>(texture.rgba8.size()));
}

void find_shining(RenderScene& out) {
    for (std::uint32_t g = 0; g < out.geometries.size(); ++g) {
        const kernel::Geometry& geometry = out.geometries[g];
        const bool triangles = geometry.kind == kernel::GEOMETRY_TRIANGLES;
        if (!triangles && geometry.kind != kernel::GEOMETRY_SPHERE) continue;
        for (std::uint32_t i = 0; i < geometry.primitive_count; ++i) {
            const std::uint32_t primitive = geometry.first_primitive + i;
            const std::uint32_t material =
                triangles ? out.triangles[primitive].material : out.spheres[primitive].material;
            if (out.materials[material].emission_power > 0) out.shining.push_back({g, primitive});
        }
    }
}

void compile_environment(const scene::Environment& environment, RenderScene& out) {
    if (environment.width == 0 || environment.height == 0) return;
    kernel::Environment& e = out.environment;
    e.up = to_kernel(environment.up);
    e.middle = to_kernel(environment.middle);
    e.right = to_kernel(cross(environment.middle, environment.up));
    e.width = environment.width;
    e.height = environment.height;
    e.gain = environment.gain;
    out.environment_mean = mean_luminance(environment);
    e.cells_wide = std::min(e.width, kMostCells);
    e.cells_high = std::min(e.height, kMostCells / 2);
    out.tables.resize(kernel::ENVIRONMENT_FIRST);
    out.tables.reserve(kernel::ENVIRONMENT_FIRST +
                       3 * (environment.radiance.size() + std::size_t{e.cells_wide} * e.cells_high));
    for (const Vec3& pixel : environment.radiance) out.tables.insert(out.tables.end(), {pixel.x, pixel.y, pixel.z});

    const std::size_t cells = std::size_t{e.cells_wide} * e.cells_high;
    std::vector<double> weights(cells, 0.0);
    // Each pixel gives light to its own cell and, by interpolation, to those beside it.
    for (std::uint32_t y = 0; y < e.height; ++y)
        for (std::uint32_t x = 0; x < e.width; ++x) {
            const double light = std::max(luminance(environment.radiance[std::size_t{y} * e.width + x]), 0.0F);
            if (!(light > 0) || !std::isfinite(light)) continue;
            const auto add = [&](int dx, int dy, double share) {
                const std::uint32_t px = (x + e.width + static_cast<std::uint32_t>(dx)) % e.width;
                const int py = std::clamp(static_cast<int>(y) + dy, 0, static_cast<int>(e.height) - 1);
                const std::size_t column = std::size_t{px} * e.cells_wide / e.width;
                const std::size_t row = static_cast<std::size_t>(py) * e.cells_high / e.height;
                weights[row * e.cells_wide + column] += light * share;
            };
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) add(dx, dy, (dx == 0 ? 0.75 : 0.125) * (dy == 0 ? 0.75 : 0.125));
        }
    double sum = 0;
    for (std::size_t row = 0; row < e.cells_high; ++row) {
        const double sine = std::sin((static_cast<double>(row) + 0.5) / e.cells_high * kPiExact);
        for (std::size_t column = 0; column < e.cells_wide; ++column) {
            weights[row * e.cells_wide + column] *= sine;
            sum += weights[row * e.cells_wide + column];
        }
    }
    if (!(sum > 0) || !std::isfinite(sum)) return;
    const std::vector<AliasEntry> table = alias_table(weights);
    e.first_cell = static_cast<std::uint32_t>(out.tables.size());
    for (std::size_t i = 0; i < cells; ++i)
        out.tables.insert(out.tables.end(), {table[i].keep, std::bit_cast<float>(table[i].alias),
                                             static_cast<float>(weights[i] / sum * static_cast<double>(cells) /
                                                                (2 * kPiExact * kPiExact))});
}

void list_emitters(const RenderScene& compiled, Frame& frame) {
    kernel::FrameParams& params = frame.params;
    const double radius = scene_radius(compiled);
    const double disc = kPiExact * radius * radius;
    std::vector<double> power;
    frame.emitters.clear();
    for (const ShiningPrimitive& p : compiled.shining) {
        const kernel::Geometry& geometry = compiled.geometries[p.geometry];
        double area = 0;
        std::uint32_t kind = kernel::EMITTER_TRIANGLE, material = 0;
        if (geometry.kind == kernel::GEOMETRY_SPHERE) {
            const kernel::Sphere& sphere = compiled.spheres[p.primitive];
            kind = kernel::EMITTER_SPHERE;
            material = sphere.material;
            area = 4 * kPiExact * sphere.radius * sphere.radius;
        } else {
            material = compiled.triangles[p.primitive].material;
            area = triangle_area(compiled, p.primitive,
                                 geometry.instance == kernel::NONE ? nullptr : &frame.instances[geometry.instance]);
        }
        const double weight = compiled.materials[material].emission_power * area;
        if (!(weight > 0) || !std::isfinite(weight)) continue;
        frame.emitters.push_back({kind, p.primitive, p.geometry, 1, 0, 0});
        // To both sides, by the cosine.
        power.push_back(2 * kPiExact * weight);
    }
    for (std::uint32_t i = 0; i < params.light_count; ++i) {
        const kernel::Light& light = frame.lights[i];
        const Vec3 amount{std::abs(light.color.x), std::abs(light.color.y), std::abs(light.color.z)};
        // A light that doesn't fade brings pi times its colour to each surface that faces it.
        double weight = kPiExact * luminance(amount) * disc;
        if (light.fade_power > 0) {
            const double reach = light.fade_distance > 0 ? light.fade_distance : 1;
            weight *= std::min(2.0, 2.0 / (1 + std::pow(radius / reach, light.fade_power)));
        }
        if (!(weight > 0) || !std::isfinite(weight)) continue;
        frame.emitters.push_back({kernel::EMITTER_LIGHT, i, kernel::NONE, 1, 0, 0});
        power.push_back(weight);
    }
    const bool surrounded = params.environment.first_cell != 0;
    if (surrounded) {
        const double weight = 4 * kPiExact * disc * compiled.environment_mean;
        if (weight > 0 && std::isfinite(weight)) {
            frame.emitters.push_back({kernel::EMITTER_ENVIRONMENT, 0, kernel::NONE, 1, 0, 0});
            power.push_back(weight);
        }
    }
    const double total = set_emitters(std::move(frame.emitters), power, frame);
    params.emitted_power = static_cast<float>(total / (2 * kPiExact));
}

double set_emitters(std::vector<kernel::Emitter> emitters, std::span<const double> power, Frame& frame) {
    frame.params.emitter_count = static_cast<std::uint32_t>(emitters.size());
    frame.params.environment.probability = 0;
    const double total = std::accumulate(power.begin(), power.end(), 0.0);
    if (total > 0) {
        const std::vector<AliasEntry> table = alias_table(power);
        for (std::size_t i = 0; i < power.size(); ++i) {
            kernel::Emitter& e = emitters[i];
            e.keep = table[i].keep;
            e.alias = table[i].alias;
            e.probability = static_cast<float>(power[i] / total);
            if (e.kind == kernel::EMITTER_ENVIRONMENT) frame.params.environment.probability = e.probability;
        }
    }
    if (emitters.empty()) emitters.resize(1);
    frame.emitters = std::move(emitters);
    return total;
}

}  // namespace sundog
