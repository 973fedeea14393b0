// SPDX-License-Identifier: Apache-2.0
#include "bake/by_radiosity.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "bake/part_light.h"
#include "bake/radiosity.h"
#include "base/srgb.h"

namespace sundog::bake {
namespace {

/// More can't be sent back than what comes.
constexpr float kMostReflectance = 0.99F;
/// Form factors of what shines are at most so many times finer than others.
constexpr float kMostDetail = 64;

/// What stops light: all parts, in as few triangles as will do.
struct Blockers {
    std::vector<TriangleIndices> triangles;
    std::vector<std::size_t> parts;  ///< Of each of them.
};

Surfaces vertices_of(const std::vector<Part>& parts) {
    Surfaces surfaces;
    for (const Part& part : parts) {
        surfaces.positions.insert(surfaces.positions.end(), part.positions.begin(), part.positions.end());
        surfaces.normals.insert(surfaces.normals.end(), part.normals.begin(), part.normals.end());
        surfaces.inside.insert(surfaces.inside.end(), part.inside.begin(), part.inside.end());
    }
    return surfaces;
}

TriangleIndices moved(const TriangleIndices& t, std::size_t first) {
    const auto by = static_cast<std::uint32_t>(first);
    return {by + t[0], by + t[1], by + t[2]};
}

Blockers blockers_of(const std::vector<Part>& parts) {
    Blockers blockers;
    for (std::size_t p = 0, first = 0; p < parts.size(); first += parts[p].positions.size(), ++p)
        for (const TriangleIndices& t : parts[p].undivided) {
            blockers.triangles.push_back(moved(t, first));
            blockers.parts.push_back(p);
        }
    return blockers;
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

class Baking {
public:
    Baking(const scene::Scene& scene, const Frame& frame, DirectLight direct, const VertexPixels& pixels,
           const BakeOptions& options, std::vector<Part>& parts, const ProgressSink& progress, const StopFlag& stop)
        : scene_(scene),
          working_gamma_(frame.params.working_gamma),
          direct_(std::move(direct)),
          pixels_(pixels),
          options_(options),
          parts_(parts),
          progress_(progress),
          stop_(stop),
          surfaces_(vertices_of(parts)),
          blockers_(blockers_of(parts)),
          occluders_(surfaces_.positions, blockers_.triangles, options.threads),
          lift_(lift_of(surfaces_.positions)),
          back_(surfaces_.positions.size(), 0),
          received_(surfaces_.positions.size(), Vec3{0, 0, 0}),
          stopped_(direct_.stopped) {}

    bool run(const ShiningSurfaces& shining) {
        for (std::size_t p = 0, first = 0; p < parts_.size(); first += parts_[p].positions.size(), ++p)
            for (const TriangleIndices& t : parts_[p].triangles)
                if (!is_covered(p, t)) surfaces_.triangles.push_back(moved(t, first));
        add_shining(shining);
        if (options_.max_depth > 0) {
            const FormFactors factors(surfaces_, occluders_, {});
            const Exchanged exchanged =
                exchange(factors, surfaces_, light_before(), options_.max_depth, part_of_work(0.6, 0.7), stop_);
            choose_sides(exchanged.received);
            stopped_ |= exchanged.stopped;
            if (!exchanged.stopped)
                stopped_ |= !gather(factors, surfaces_, exchanged.nodes, back_, received_, part_of_work(0.7, 1), stop_);
        } else {
            choose_sides(std::vector<Sides<Vec3>>(received_.size(), {Vec3{0, 0, 0}, Vec3{0, 0, 0}}));
        }
        for (std::size_t p = 0, first = 0; p < parts_.size(); ++p) {
            PartSides sides;
            const bool turned = back_[first] != 0;
            sides[turned ? 1 : 0] = all_light(p, turned, [&](std::size_t v) { return received_[first + v]; });
            first += parts_[p].positions.size();
            take_side(parts_[p], sides, turned);
        }
        return stopped_;
    }

private:
    [[nodiscard]] ShareSink part_of_work(double from, double to) const {
        if (!progress_) return {};
        return [this, from, to](double share) {
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
            progress_({from + (to - from) * share, seconds, 0});
        };
    }

    /// Where surfaces lie upon each other, as a block's bottom on a floor, only the first part's counts: who looks at
    /// them would see both.
    [[nodiscard]] bool is_covered(std::size_t part, const TriangleIndices& t) const {
        const auto place = [&](std::size_t k) { return parts_[part].positions[t[k]]; };
        const Vec3 middle = (place(0) + place(1) + place(2)) / 3;
        const Vec3 off = normalize(cross(place(1) - place(0), place(2) - place(0))) * lift_;
        const std::optional<std::uint32_t> first = occluders_.first_between(middle + off, middle - off);
        return first && blockers_.parts[*first] < part;
    }

    /// Adds what comes to vertices from surfaces that shine but weren't aimed at.
    void add_shining(const ShiningSurfaces& shining) {
        Surfaces lamps = surfaces_;
        lamps.triangles.clear();
        SurfaceLight light;
        light.source.resize(received_.size(), {Vec3{0, 0, 0}, Vec3{0, 0, 0}});
        light.reflectance = light.source;
        std::vector<float> brightness;
        Vec3 sum{0, 0, 0};
        float area = 0;
        for (std::size_t p = 0, first = 0; p < parts_.size(); first += parts_[p].positions.size(), ++p) {
            const bool aimed_at = shining.aimed_at.contains({parts_[p].source, parts_[p].material});
            const auto own = [&](std::size_t v, bool back) { return direct_.own[pixels_.pixel_of(p, v, back)]; };
            if (!aimed_at)
                for (std::size_t v = 0; v < parts_[p].positions.size(); ++v)
                    light.source[first + v] = {own(v, false), own(v, true)};
            for (const TriangleIndices& t : parts_[p].triangles) {
                const auto place = [&](std::size_t k) { return parts_[p].positions[t[k]]; };
                const float size = length(cross(place(1) - place(0), place(2) - place(0)));
                area += size;
                Vec3 most{0, 0, 0};
                for (const std::uint32_t v : t) most = max(most, max(own(v, false), own(v, true)));
                if (aimed_at || !(luminance(most) > 0) || is_covered(p, t)) continue;
                lamps.triangles.push_back(moved(t, first));
                brightness.push_back(luminance(most));
                sum += most * size;
            }
        }
        if (lamps.triangles.empty()) return;
        // What one ray brings is to be little of what there is on average.
        const Vec3 mean = sum / area;
        for (float& b : brightness) b = std::clamp(b / luminance(mean), 1.0F, kMostDetail);
        const FormFactors factors(lamps, occluders_, brightness);
        const std::vector<Sides<Vec3>> nodes =
            radiance_of_nodes(factors, lamps, weights_of(factors, lamps), light, light.source);
        for (std::uint8_t side = 0; side < 2; ++side) {
            const std::vector<std::uint8_t> back(received_.size(), side);
            // Where it is stopped, the mean stands for what wasn't found.
            std::vector<Vec3> received(received_.size(), mean);
            stopped_ |= !gather(factors, lamps, nodes, back, received,
                                part_of_work(0.5 + 0.05 * side, 0.55 + 0.05 * side), stop_);
            for (std::size_t p = 0, first = 0; p < parts_.size(); first += parts_[p].positions.size(), ++p)
                for (std::size_t v = 0; v < parts_[p].positions.size(); ++v) {
                    const std::size_t pixel = pixels_.pixel_of(p, v, side == 1);
                    direct_.reflected[pixel] += direct_.albedo[pixel] * received[first + v];
                }
        }
    }

    /// What vertices send out before any exchange, but for what they shine with.
    [[nodiscard]] SurfaceLight light_before() const {
        SurfaceLight light;
        for (std::size_t p = 0; p < parts_.size(); ++p)
            for (std::size_t v = 0; v < parts_[p].positions.size(); ++v) {
                Sides<Vec3> source, reflectance;
                for (std::size_t side = 0; side < 2; ++side) {
                    const std::size_t pixel = pixels_.pixel_of(p, v, side == 1);
                    constexpr Vec3 most{kMostReflectance, kMostReflectance, kMostReflectance};
                    source[side] = direct_.reflected[pixel];
                    reflectance[side] = min(max(direct_.albedo[pixel], {0, 0, 0}), most);
                }
                light.source.push_back(source);
                light.reflectance.push_back(reflectance);
            }
        return light;
    }

    /// What a side of a part sends out: its own light and what it makes of others'. `received(v)` is what vertex v of
    /// the part receives by exchange.
    template <class Received>
    [[nodiscard]] std::vector<Vec3> all_light(std::size_t p, bool back, const Received& received) const {
        const bool textured = is_textured(scene_.materials[parts_[p].material]);
        std::vector<Vec3> all;
        for (std::size_t v = 0; v < parts_[p].positions.size(); ++v) {
            const std::size_t pixel = pixels_.pixel_of(p, v, back);
            const Vec3 albedo = direct_.albedo[pixel];
            const Vec3 sum = direct_.own[pixel] + direct_.reflected[pixel] + albedo * received(v);
            const Vec3 light = linear_light(sum, working_gamma_);
            all.push_back(textured ? light_of_white(light, albedo) : light);
        }
        return all;
    }

    /// Which side of a part counts can be told from what its patches receive.
    void choose_sides(const std::vector<Sides<Vec3>>& by_patches) {
        for (std::size_t p = 0, first = 0; p < parts_.size(); ++p) {
            PartSides sides;
            for (std::size_t side = 0; side < 2; ++side)
                sides[side] = all_light(p, side == 1, [&](std::size_t v) { return by_patches[first + v][side]; });
            const std::uint8_t back = is_turned(sides) ? 1 : 0;
            for (const std::size_t end = first + parts_[p].positions.size(); first < end; ++first) {
                back_[first] = back;
                received_[first] = by_patches[first][back];
            }
        }
    }

    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const scene::Scene& scene_;
    float working_gamma_;
    DirectLight direct_;
    const VertexPixels& pixels_;
    const BakeOptions& options_;
    std::vector<Part>& parts_;
    const ProgressSink& progress_;
    const StopFlag& stop_;
    Surfaces surfaces_;
    Blockers blockers_;
    cpu::TriangleOccluders occluders_;
    float lift_;
    std::vector<std::uint8_t> back_;  ///< 1 where a vertex's part is turned.
    std::vector<Vec3> received_;      ///< By exchange, on the side that counts.
    bool stopped_;
};

}  // namespace

bool by_radiosity(const scene::Scene& scene, const Frame& frame, const ShiningSurfaces& shining, DirectLight direct,
                  const VertexPixels& pixels, const BakeOptions& options, std::vector<Part>& parts,
                  const ProgressSink& progress, const StopFlag& stop) {
    Baking baking(scene, frame, std::move(direct), pixels, options, parts, progress, stop);
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    return arena.execute([&] { return baking.run(shining); });
}

}  // namespace sundog::bake
