// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "import/obj/obj_build.h"

namespace sundog::import {
namespace {

using scene::kNone;
using scene::Mesh;

/// A run's triangles in its object's mesh.
std::span<Mesh::Triangle> triangles_of(const ObjRun& run, std::uint32_t end, std::span<scene::Object> objects) {
    Mesh& mesh = *std::get<Boxed<Mesh>>(objects[run.object].shape);
    return {mesh.triangles.data() + run.first_triangle, end - run.first_triangle};
}

/// A smoothed run with the end of its triangles.
struct SmoothRun {
    const ObjRun* run;
    std::uint32_t end_triangle;
};

/// Angle at `corner` between the edges to the two others; 0 for edges without length.
float angle_at(Vec3 corner, Vec3 one, Vec3 other) {
    const Vec3 a = normalize(one - corner);
    const Vec3 b = normalize(other - corner);
    return std::atan2(length(cross(a, b)), dot(a, b));
}

/// From a position's index in the file to the place of its normal among the group's.
class VertexTable {
public:
    /// `used`: the group's positions, with repeats.
    explicit VertexTable(std::vector<std::uint32_t> used) {
        const auto [low, high] = std::minmax_element(used.begin(), used.end());
        const std::size_t range = std::size_t{*high} - *low + 1;
        first_ = *low;
        if (range <= 4 * used.size() + 1024) {
            table_.assign(range, kNone);
            for (const std::uint32_t position : used) {
                std::uint32_t& place = table_[position - first_];
                if (place == kNone) place = count_++;
            }
        } else {
            sorted_ = std::move(used);
            std::sort(sorted_.begin(), sorted_.end());
            sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
            count_ = static_cast<std::uint32_t>(sorted_.size());
        }
    }
    [[nodiscard]] std::uint32_t place_of(std::uint32_t position) const {
        if (!table_.empty()) return table_[position - first_];
        return static_cast<std::uint32_t>(std::lower_bound(sorted_.begin(), sorted_.end(), position) - sorted_.begin());
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }

private:
    std::uint32_t first_ = 0, count_ = 0;
    std::vector<std::uint32_t> table_, sorted_;
};

void smooth_group(std::span<const SmoothRun> runs, std::span<scene::Object> objects, std::span<const Vec3> positions,
                  std::vector<Vec3>& normals) {
    std::vector<std::uint32_t> used;
    for (const SmoothRun& smooth : runs)
        for (const Mesh::Triangle& t : triangles_of(*smooth.run, smooth.end_triangle, objects))
            if (t.normal[0] == kNone) used.insert(used.end(), t.position, t.position + 3);
    if (used.empty()) return;
    const VertexTable table(std::move(used));
    const auto first = static_cast<std::uint32_t>(normals.size());
    normals.resize(first + std::size_t{table.count()});
    for (const SmoothRun& smooth : runs) {
        for (Mesh::Triangle& t : triangles_of(*smooth.run, smooth.end_triangle, objects)) {
            if (t.normal[0] != kNone) continue;
            const Vec3 p[3] = {positions[t.position[0]], positions[t.position[1]], positions[t.position[2]]};
            const Vec3 face_normal = normalize(cross(p[1] - p[0], p[2] - p[0]));
            for (std::size_t i = 0; i < 3; ++i) {
                t.normal[i] = first + table.place_of(t.position[i]);
                const Vec3 weighted = face_normal * angle_at(p[i], p[(i + 1) % 3], p[(i + 2) % 3]);
                if (is_finite(weighted)) normals[t.normal[i]] += weighted;
            }
        }
    }
    for (std::size_t i = first; i < normals.size(); ++i) normals[i] = normalize(normals[i]);
}

}  // namespace

void smooth_normals(std::span<const ObjRun> runs, std::span<scene::Object> objects, std::span<const Vec3> positions,
                    std::vector<Vec3>& normals) {
    // Where a run's triangles end: where the object's next run starts.
    std::vector<SmoothRun> smooth;
    std::vector<std::uint32_t> ends(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i)
        ends[i] = static_cast<std::uint32_t>(std::get<Boxed<Mesh>>(objects[i].shape)->triangles.size());
    for (std::size_t i = runs.size(); i-- > 0;) {
        if (runs[i].smoothing_group > 0) smooth.push_back({&runs[i], ends[runs[i].object]});
        ends[runs[i].object] = runs[i].first_triangle;
    }
    std::reverse(smooth.begin(), smooth.end());
    std::stable_sort(smooth.begin(), smooth.end(), [](const SmoothRun& a, const SmoothRun& b) {
        return a.run->smoothing_group < b.run->smoothing_group;
    });
    for (std::size_t first = 0; first < smooth.size();) {
        std::size_t end = first;
        while (end < smooth.size() && smooth[end].run->smoothing_group == smooth[first].run->smoothing_group) ++end;
        smooth_group(std::span(smooth).subspan(first, end - first), objects, positions, normals);
        first = end;
    }
}

}  // namespace sundog::import
