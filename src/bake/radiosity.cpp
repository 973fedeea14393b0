// SPDX-License-Identifier: Apache-2.0
#include "bake/radiosity.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/srgb.h"

namespace sundog::bake {
namespace {

/// Triangles of a patch, as long as patches don't become more than kMostPatches.
constexpr std::size_t kPatchTriangles = 16;
constexpr std::size_t kMostPatches = 32768;
/// The exchange ends when a bounce changes less than this share of all light.
constexpr double kLeastChange = 1e-4;
/// So much is done between two looks at what the caller wants.
constexpr std::size_t kChunk = 512;

/// Receives light in the name of its triangles.
struct Patch {
    std::uint32_t node;
    std::uint32_t vertex;  ///< Where its light arrives: nearest to its centre.
};

Vec3 middle_of(const Surfaces& surfaces, std::size_t triangle) {
    const TriangleIndices& t = surfaces.triangles[triangle];
    return (surfaces.positions[t[0]] + surfaces.positions[t[1]] + surfaces.positions[t[2]]) / 3;
}

/// Groups of triangles that face one way and that no wall divides.
class PatchFinder {
public:
    PatchFinder(const FormFactors& factors, const Surfaces& surfaces, const Weights& weights)
        : factors_(factors), tree_(factors.tree()), surfaces_(surfaces), weights_(weights) {}

    [[nodiscard]] std::vector<Patch> run() const {
        const std::size_t most = std::max(kPatchTriangles, surfaces_.triangles.size() / kMostPatches);
        std::vector<Patch> patches;
        std::vector<std::uint32_t> stack;
        if (!tree_.nodes().empty()) stack.push_back(0);
        while (!stack.empty()) {
            const std::uint32_t number = stack.back();
            stack.pop_back();
            const ElementTree::Node& node = tree_.nodes()[number];
            const Patch patch{number, node.count <= most ? middle_vertex(node) : 0};
            if (node.is_leaf() || (node.count <= most && node.is_flat() && !is_divided(node, patch.vertex))) {
                patches.push_back(patch);
                continue;
            }
            stack.push_back(node.right);
            stack.push_back(number + 1);
        }
        return patches;
    }

private:
    [[nodiscard]] std::uint32_t middle_vertex(const ElementTree::Node& node) const {
        std::uint32_t middle = 0;
        float nearest = std::numeric_limits<float>::infinity();
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t t = tree_.order()[i], v = surfaces_.triangles[t][k];
                const float away = length(surfaces_.inside[v] - node.center);
                if (away >= nearest || !(weights_.corners[t][k] > 0)) continue;
                nearest = away;
                middle = v;
            }
        return middle;
    }

    /// In a bent surface, its own triangles stand in between: it isn't asked.
    [[nodiscard]] bool is_divided(const ElementTree::Node& node, std::uint32_t vertex) const {
        if (!node.is_plane()) return false;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (factors_.is_walled(middle_of(surfaces_, tree_.order()[i]), surfaces_.inside[vertex], node.axis))
                return true;
        return false;
    }

    const FormFactors& factors_;
    const ElementTree& tree_;
    const Surfaces& surfaces_;
    const Weights& weights_;
};

/// Calls done(begin, end) for parts of [0, count), one after the other, until it is stopped; false if it was.
template <class Done>
bool in_chunks(std::size_t count, const ShareSink& progress, const StopFlag& stop, const Done& done) {
    for (std::size_t begin = 0; begin < count; begin += kChunk) {
        if (stop.requested()) return false;
        const std::size_t end = std::min(count, begin + kChunk);
        done(begin, end);
        if (progress) progress(static_cast<double>(end) / static_cast<double>(count));
    }
    return true;
}

Vec3 sum_of(std::span<const FormFactors::Link> links, std::span<const Sides<Vec3>> nodes) {
    Vec3 sum{0, 0, 0};
    for (const FormFactors::Link& link : links) sum += nodes[link.node][link.back] * link.share;
    return sum;
}

/// Which side of a vertex is on that side of a triangle: vertices may have been written for the other one.
std::size_t vertex_side(const FormFactors& factors, const Surfaces& surfaces, std::uint32_t triangle,
                        std::uint32_t vertex, std::size_t side) {
    return dot(factors.face(triangle), surfaces.normals[vertex]) < 0 ? 1 - side : side;
}

class Solver {
public:
    Solver(const FormFactors& factors, const Surfaces& surfaces, const SurfaceLight& light)
        : factors_(factors),
          surfaces_(surfaces),
          light_(light),
          tree_(factors.tree()),
          weights_(weights_of(factors, surfaces)),
          patches_(PatchFinder(factors, surfaces, weights_).run()) {}

    Exchanged run(int bounces, const ShareSink& progress, const StopFlag& stop) {
        Exchanged result;
        result.received.resize(surfaces_.positions.size(), {Vec3{0, 0, 0}, Vec3{0, 0, 0}});
        result.nodes = radiance_of_nodes(factors_, surfaces_, weights_, light_, result.received);
        if (!find_links(progress, stop)) {
            result.stopped = true;
            const Vec3 ambient = ambient_light();
            std::fill(result.received.begin(), result.received.end(), Sides<Vec3>{ambient, ambient});
            return result;
        }
        for (int bounce = 1;; ++bounce) {
            result.received = received(result.nodes);
            if (bounce >= bounces || stop.requested()) break;
            std::vector<Sides<Vec3>> next = radiance_of_nodes(factors_, surfaces_, weights_, light_, result.received);
            const double change = std::abs(power(next) - power(result.nodes));
            const bool ends = change < kLeastChange * power(next);
            result.nodes = std::move(next);
            if (ends) break;
        }
        return result;
    }

private:
    bool find_links(const ShareSink& progress, const StopFlag& stop) {
        links_.resize(patches_.size());
        return in_chunks(patches_.size(), progress, stop, [&](std::size_t begin, std::size_t end) {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, 8), [&](const auto& range) {
                FormFactors::Query query;
                for (std::size_t p = range.begin(); p < range.end(); ++p)
                    for (std::size_t side = 0; side < 2; ++side) {
                        const std::uint32_t v = patches_[p].vertex;
                        const bool turned = dot(surfaces_.normals[v], tree_.nodes()[patches_[p].node].axis) < 0;
                        const Vec3 normal = surfaces_.normals[v] * (turned == (side == 1) ? 1.0F : -1.0F);
                        factors_.find(surfaces_.inside[v], normal, query);
                        links_[p][side].assign(query.links.begin(), query.links.end());
                    }
            });
        });
    }

    /// What vertices receive: the mean of the patches around, of those triangles that no wall parts from them.
    [[nodiscard]] std::vector<Sides<Vec3>> received(const std::vector<Sides<Vec3>>& nodes) const {
        std::vector<Sides<Vec3>> at_patches(patches_.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, patches_.size(), 64), [&](const auto& range) {
            for (std::size_t p = range.begin(); p < range.end(); ++p)
                for (std::size_t side = 0; side < 2; ++side) at_patches[p][side] = sum_of(links_[p][side], nodes);
        });
        std::vector<Sides<Vec3>> at_vertices(surfaces_.positions.size(), {Vec3{0, 0, 0}, Vec3{0, 0, 0}});
        std::vector<float> count(at_vertices.size(), 0);
        for (std::size_t p = 0; p < patches_.size(); ++p) {
            const ElementTree::Node& node = tree_.nodes()[patches_[p].node];
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                const std::uint32_t t = tree_.order()[i];
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t v = surfaces_.triangles[t][k];
                    // Little is better than nothing, where all are parted from it.
                    const float weight = std::max(weights_.corners[t][k], 1e-6F);
                    for (std::size_t side = 0; side < 2; ++side)
                        at_vertices[v][vertex_side(factors_, surfaces_, t, v, side)] += at_patches[p][side] * weight;
                    count[v] += weight;
                }
            }
        }
        for (std::size_t v = 0; v < at_vertices.size(); ++v)
            for (Vec3& light : at_vertices[v]) light = count[v] > 0 ? light / count[v] : Vec3{0, 0, 0};
        return at_vertices;
    }

    /// All that surfaces send out, up to a factor.
    [[nodiscard]] double power(const std::vector<Sides<Vec3>>& nodes) const {
        double sum = 0;
        for (std::size_t n = 0; n < tree_.nodes().size(); ++n)
            if (tree_.nodes()[n].is_leaf())
                sum += (luminance(nodes[n][0]) + luminance(nodes[n][1])) * tree_.nodes()[n].area;
        return sum;
    }

    /// The mean radiance if all that is sent out were shared by all surfaces, times that of all bounces; a surface
    /// counts by its brighter side.
    [[nodiscard]] Vec3 ambient_light() const {
        Vec3 sum{0, 0, 0}, reflected{0, 0, 0};
        float area = 0;
        for (const ElementTree::Node& node : tree_.nodes()) {
            if (!node.is_leaf()) continue;
            for (const std::uint32_t v : surfaces_.triangles[node.middle]) {
                const Sides<Vec3>& source = light_.source[v];
                const std::size_t side = luminance(source[1]) > luminance(source[0]) ? 1 : 0;
                sum += source[side] * node.area;
                reflected += light_.reflectance[v][side] * node.area;
                area += node.area;
            }
        }
        if (!(area > 0)) return {0, 0, 0};
        const auto all_bounces = [&](float light, float reflectance) {
            return light / area / (1 - std::clamp(reflectance / area, 0.0F, 0.9F));
        };
        return {all_bounces(sum.x, reflected.x), all_bounces(sum.y, reflected.y), all_bounces(sum.z, reflected.z)};
    }

    const FormFactors& factors_;
    const Surfaces& surfaces_;
    const SurfaceLight& light_;
    const ElementTree& tree_;
    Weights weights_;
    std::vector<Patch> patches_;
    std::vector<Sides<std::vector<FormFactors::Link>>> links_;
};

}  // namespace

Weights weights_of(const FormFactors& factors, const Surfaces& surfaces) {
    const std::vector<ElementTree::Node>& nodes = factors.tree().nodes();
    Weights weights;
    weights.corners.resize(surfaces.triangles.size());
    weights.left.resize(nodes.size());
    const auto corners_of = [&](std::uint32_t t) {
        std::array<float, 3> corners{};
        float sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = factors.is_corner_walled(t, k) ? 0 : 1;
            sum += corners[k];
        }
        for (float& w : corners) w = sum > 0 ? w / sum : 1 / 3.0F;
        return corners;
    };
    const auto left_of = [&](std::size_t n) {
        const ElementTree::Node &node = nodes[n], &left = nodes[n + 1], &right = nodes[node.right];
        // In a bent surface, its own triangles stand in between: it isn't asked.
        const auto is_seen = [&](const ElementTree::Node& child) {
            return !node.is_plane() ||
                   !factors.is_walled(middle_of(surfaces, node.middle), middle_of(surfaces, child.middle), node.axis);
        };
        const bool left_seen = is_seen(left), right_seen = is_seen(right);
        if (left_seen != right_seen) return left_seen ? 1.0F : 0.0F;
        const float area = left.area + right.area;
        return area > 0 ? left.area / area : 0.5F;
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes.size(), 256), [&](const auto& range) {
        for (std::size_t n = range.begin(); n < range.end(); ++n) {
            if (nodes[n].is_leaf()) weights.corners[nodes[n].middle] = corners_of(nodes[n].middle);
            else weights.left[n] = left_of(n);
        }
    });
    return weights;
}

std::vector<Sides<Vec3>> radiance_of_nodes(const FormFactors& factors, const Surfaces& surfaces, const Weights& weights,
                                           const SurfaceLight& light, std::span<const Sides<Vec3>> received) {
    const std::vector<ElementTree::Node>& nodes = factors.tree().nodes();
    const std::vector<std::uint32_t>& divided = factors.divided();
    std::vector<Sides<Vec3>> radiance(nodes.size() + divided.size(), {Vec3{0, 0, 0}, Vec3{0, 0, 0}});
    const auto at_corner = [&](std::uint32_t triangle, std::size_t corner, std::size_t side) {
        const std::uint32_t v = surfaces.triangles[triangle][corner];
        const std::size_t s = vertex_side(factors, surfaces, triangle, v, side);
        return light.source[v][s] + light.reflectance[v][s] * received[v][s];
    };
    // Children come after their parents.
    for (std::size_t n = nodes.size(); n-- > 0;)
        for (std::size_t side = 0; side < 2; ++side) {
            Vec3& sum = radiance[n][side];
            if (nodes[n].is_leaf()) {
                const std::uint32_t t = nodes[n].middle;
                for (std::size_t k = 0; k < 3; ++k) sum += at_corner(t, k, side) * weights.corners[t][k];
            } else {
                const float left = weights.left[n];
                sum = radiance[n + 1][side] * left + radiance[nodes[n].right][side] * (1 - left);
            }
        }
    for (std::size_t d = 0; d < divided.size(); ++d)
        for (std::size_t side = 0; side < 2; ++side) {
            float count = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                if (!factors.is_corner_walled(divided[d], k)) continue;
                radiance[nodes.size() + d][side] += at_corner(divided[d], k, side);
                count += 1;
            }
            radiance[nodes.size() + d][side] *= 1 / count;
        }
    return radiance;
}

Exchanged exchange(const FormFactors& factors, const Surfaces& surfaces, const SurfaceLight& light, int bounces,
                   const ShareSink& progress, const StopFlag& stop) {
    return Solver(factors, surfaces, light).run(bounces, progress, stop);
}

bool gather(const FormFactors& factors, const Surfaces& surfaces, std::span<const Sides<Vec3>> nodes,
            std::span<const std::uint8_t> back, std::span<Vec3> received, const ShareSink& progress,
            const StopFlag& stop) {
    return in_chunks(received.size(), progress, stop, [&](std::size_t begin, std::size_t end) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, 16), [&](const auto& range) {
            FormFactors::Query query;
            for (std::size_t v = range.begin(); v < range.end(); ++v) {
                factors.find(surfaces.inside[v], surfaces.normals[v] * (back[v] == 0 ? 1.0F : -1.0F), query);
                received[v] = sum_of(query.links, nodes);
            }
        });
    });
}

}  // namespace sundog::bake
