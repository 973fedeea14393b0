// SPDX-License-Identifier: Apache-2.0
#include "bake/element_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sundog::bake {
namespace {

/// Normals that spread more than this in one axis are told apart before places are.
constexpr float kMostSpread = 0.7F;

struct Element {
    Vec3 middle, normal;
    float area;
};

std::size_t widest(Vec3 extent) {
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

class Builder {
public:
    Builder(std::span<const Vec3> positions, std::span<const TriangleIndices> triangles,
            std::vector<ElementTree::Node>& nodes, std::vector<std::uint32_t>& order)
        : positions_(positions), triangles_(triangles), nodes_(nodes), order_(order) {
        for (const TriangleIndices& t : triangles) {
            const Vec3 a = positions[t[0]], b = positions[t[1]], c = positions[t[2]];
            const Vec3 across = cross(b - a, c - a);
            elements_.push_back({(a + b + c) / 3, normalize(across), length(across) / 2});
        }
    }

    void run() {
        // A job's node goes to the place where its parent waits for it; first children follow at once.
        struct Job {
            std::uint32_t first, count, parent;
        };
        constexpr std::uint32_t kNoParent = std::numeric_limits<std::uint32_t>::max();
        std::vector<Job> jobs{{0, static_cast<std::uint32_t>(order_.size()), kNoParent}};
        while (!jobs.empty()) {
            const Job job = jobs.back();
            jobs.pop_back();
            const auto number = static_cast<std::uint32_t>(nodes_.size());
            if (job.parent != kNoParent) nodes_[job.parent].right = number;
            nodes_.push_back(node_over(job.first, job.count));
            if (job.count == 1) continue;
            const std::uint32_t left = divide(job.first, job.count);
            jobs.push_back({job.first + left, job.count - left, number});
            jobs.push_back({job.first, left, kNoParent});
        }
    }

private:
    [[nodiscard]] std::span<std::uint32_t> run_of(std::uint32_t first, std::uint32_t count) {
        return std::span(order_).subspan(first, count);
    }

    ElementTree::Node node_over(std::uint32_t first, std::uint32_t count) {
        ElementTree::Node node{};
        node.first = first;
        node.count = count;
        Vec3 facing{0, 0, 0}, moment{0, 0, 0}, sum{0, 0, 0};
        double area = 0;
        for (const std::uint32_t t : run_of(first, count)) {
            const Element& e = elements_[t];
            // From the first one, so that little is lost far from the origin.
            const Vec3 away = e.middle - elements_[order_[first]].middle;
            facing += e.normal * e.area;
            moment += away * e.area;
            sum += away;
            area += e.area;
        }
        node.area = static_cast<float>(area);
        const Vec3 mean = node.area > 0 ? moment / node.area : sum / static_cast<float>(count);
        node.center = elements_[order_[first]].middle + mean;
        node.projected = length(facing);
        node.axis = node.projected > 0 ? facing / node.projected : Vec3{0, 0, 1};
        float nearest = std::numeric_limits<float>::infinity();
        for (const std::uint32_t t : run_of(first, count)) {
            for (const std::uint32_t v : triangles_[t]) {
                const Vec3 away = positions_[v] - node.center;
                node.radius = std::max(node.radius, length(away));
                node.thickness = std::max(node.thickness, std::abs(dot(node.axis, away)));
            }
            const float away = length(elements_[t].middle - node.center);
            if (away >= nearest) continue;
            nearest = away;
            node.middle = t;
        }
        return node;
    }

    /// Divides a run in two; how many come first.
    std::uint32_t divide(std::uint32_t first, std::uint32_t count) {
        const std::span<std::uint32_t> run = run_of(first, count);
        Bounds3 places, normals;
        for (const std::uint32_t t : run) {
            places.include(elements_[t].middle);
            normals.include(elements_[t].normal);
        }
        const std::size_t turned = widest(normals.extent());
        const bool by_normal = normals.extent()[turned] > kMostSpread;
        const std::size_t axis = by_normal ? turned : widest(places.extent());
        const float half = by_normal ? normals.center()[axis] : places.center()[axis];
        const auto key = [&](std::uint32_t t) {
            return by_normal ? elements_[t].normal[axis] : elements_[t].middle[axis];
        };
        const auto middle =
            std::stable_partition(run.begin(), run.end(), [&](std::uint32_t t) { return key(t) < half; });
        const auto left = static_cast<std::uint32_t>(middle - run.begin());
        // Few of many would make the tree deep.
        if (std::min(left, count - left) >= std::max(count / 16, 1U)) return left;
        std::stable_sort(run.begin(), run.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        return count / 2;
    }

    std::span<const Vec3> positions_;
    std::span<const TriangleIndices> triangles_;
    std::vector<ElementTree::Node>& nodes_;
    std::vector<std::uint32_t>& order_;
    std::vector<Element> elements_;
};

}  // namespace

ElementTree::ElementTree(std::span<const Vec3> positions, std::span<const TriangleIndices> triangles) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) order_.push_back(t);
    if (triangles.empty()) return;
    nodes_.reserve(2 * triangles.size());
    Builder(positions, triangles, nodes_, order_).run();
}

}  // namespace sundog::bake
