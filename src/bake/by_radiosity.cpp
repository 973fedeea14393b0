// SPDX-License-Identifier: Apache-2.0
#include "bake/by_radiosity.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "bake/part_light.h"
#include "bake/radiosity.h"
#include "base/srgb.h"

namespace sundog::bake {
namespace {

/// More can't be sent back than what comes.
constexpr float kMostReflectance = 0.99F;

/// The objects' materials that paths aim at as lights.
std::set<std::pair<std::size_t, scene::Index>> aimed_at(const RenderScene& compiled) {
    std::set<std::pair<std::size_t, scene::Index>> aimed;
    for (const ShiningPrimitive& p : compiled.shining) {
        const bool triangle = compiled.geometries[p.geometry].kind == kernel::GEOMETRY_TRIANGLES;
        aimed.emplace(compiled.geometry_objects[p.geometry],
                      triangle ? compiled.triangles[p.primitive].material : compiled.spheres[p.primitive].material);
    }
    return aimed;
}

Surfaces surfaces_of(const std::vector<Part>& parts) {
    Surfaces surfaces;
    for (const Part& part : parts) {
        const auto first = static_cast<std::uint32_t>(surfaces.positions.size());
        surfaces.positions.insert(surfaces.positions.end(), part.positions.begin(), part.positions.end());
        surfaces.normals.insert(surfaces.normals.end(), part.normals.begin(), part.normals.end());
        surfaces.inside.insert(surfaces.inside.end(), part.inside.begin(), part.inside.end());
        for (const auto& t : part.triangles) surfaces.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        for (const auto& t : part.undivided) surfaces.occluders.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return surfaces;
}

/// A scene's own numbers as linear light (linear_light() of kernel/integrators/path.h).
Vec3 linear_light(Vec3 c, float working_gamma) {
    if (working_gamma == 1) return c;
    const auto channel = [&](float v) {
        if (!(v > 0)) return 0.0F;
        return working_gamma > 0 ? std::pow(v, working_gamma) : static_cast<float>(linear_from_srgb(v));
    };
    return {channel(c.x), channel(c.y), channel(c.z)};
}

/// What vertices send out before any exchange.
SurfaceLight light_before(const DirectLight& direct, const VertexPixels& pixels, const RenderScene& compiled,
                          const std::vector<Part>& parts) {
    const auto aimed = aimed_at(compiled);
    SurfaceLight light;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        // What paths aimed at is part of the direct light already.
        const float own = aimed.contains({parts[p].source, parts[p].material}) ? 0.0F : 1.0F;
        for (std::size_t v = 0; v < parts[p].positions.size(); ++v) {
            Sides<Vec3> source, reflectance;
            for (std::size_t side = 0; side < 2; ++side) {
                const std::size_t pixel = pixels.pixel_of(p, v, side == 1);
                constexpr Vec3 most{kMostReflectance, kMostReflectance, kMostReflectance};
                source[side] = direct.reflected[pixel] + direct.own[pixel] * own;
                reflectance[side] = min(max(direct.albedo[pixel], {0, 0, 0}), most);
            }
            light.source.push_back(source);
            light.reflectance.push_back(reflectance);
        }
    }
    return light;
}

/// Puts together what a vertex sends out: its own light and what it makes of others'.
class Sum {
public:
    Sum(const scene::Scene& scene, const DirectLight& direct, const VertexPixels& pixels, float working_gamma)
        : scene_(scene), direct_(direct), pixels_(pixels), working_gamma_(working_gamma) {}

    /// `received(v)` is what vertex v of the part receives by exchange.
    template <class Received>
    [[nodiscard]] std::vector<Vec3> of(const Part& part, std::size_t number, bool back,
                                       const Received& received) const {
        const bool textured = is_textured(scene_.materials[part.material]);
        std::vector<Vec3> all;
        for (std::size_t v = 0; v < part.positions.size(); ++v) {
            const std::size_t pixel = pixels_.pixel_of(number, v, back);
            const Vec3 albedo = direct_.albedo[pixel];
            const Vec3 sum = direct_.own[pixel] + direct_.reflected[pixel] + albedo * received(v);
            const Vec3 light = linear_light(sum, working_gamma_);
            all.push_back(textured ? light_of_white(light, albedo) : light);
        }
        return all;
    }

private:
    const scene::Scene& scene_;
    const DirectLight& direct_;
    const VertexPixels& pixels_;
    float working_gamma_;
};

}  // namespace

bool by_radiosity(const scene::Scene& scene, const RenderScene& compiled, const Frame& frame, const DirectLight& direct,
                  const VertexPixels& pixels, const BakeOptions& options, std::vector<Part>& parts,
                  const ProgressSink& progress, const StopFlag& stop) {
    const auto start = std::chrono::steady_clock::now();
    const auto part_of_work = [&](double from, double to) -> ShareSink {
        if (!progress) return {};
        return [&progress, start, from, to](double share) {
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            progress({from + (to - from) * share, seconds, 0});
        };
    };
    const Surfaces surfaces = surfaces_of(parts);
    const Sum sum(scene, direct, pixels, frame.params.working_gamma);
    std::vector<Vec3> received(surfaces.positions.size(), {0, 0, 0});
    std::vector<std::uint8_t> back(surfaces.positions.size(), 0);
    std::vector<bool> turned(parts.size(), false);
    // Which side of a part counts can be told from what its patches receive.
    const auto choose_sides = [&](const std::vector<Sides<Vec3>>& by_patches) {
        std::size_t first = 0;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            PartSides sides;
            for (std::size_t side = 0; side < 2; ++side)
                sides[side] =
                    sum.of(parts[p], p, side == 1, [&](std::size_t v) { return by_patches[first + v][side]; });
            turned[p] = is_turned(sides);
            for (const std::size_t end = first + parts[p].positions.size(); first < end; ++first) {
                back[first] = turned[p] ? 1 : 0;
                received[first] = by_patches[first][back[first]];
            }
        }
    };
    bool stopped = direct.stopped;
    if (options.max_depth > 0) {
        tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
        arena.execute([&] {
            const FormFactors factors(surfaces, options.threads);
            const Exchanged exchanged = exchange(factors, surfaces, light_before(direct, pixels, compiled, parts),
                                                 options.max_depth, part_of_work(0.5, 0.6), stop);
            choose_sides(exchanged.received);
            stopped |= exchanged.stopped;
            if (!exchanged.stopped)
                stopped |= !gather(factors, surfaces, exchanged.nodes, back, received, part_of_work(0.6, 1), stop);
        });
    } else {
        choose_sides(std::vector<Sides<Vec3>>(received.size(), {Vec3{0, 0, 0}, Vec3{0, 0, 0}}));
    }
    std::size_t first = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        PartSides sides;
        sides[turned[p] ? 1 : 0] = sum.of(parts[p], p, turned[p], [&](std::size_t v) { return received[first + v]; });
        first += parts[p].positions.size();
        take_side(parts[p], sides, turned[p]);
    }
    return stopped;
}

}  // namespace sundog::bake
