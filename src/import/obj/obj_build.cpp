// SPDX-License-Identifier: Apache-2.0
#include "import/obj/obj_build.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>

#include "import/obj/polygon.h"

namespace sundog::import {
namespace {

using scene::kNone;
using scene::Mesh;
using Corners = std::uint32_t (Mesh::Triangle::*)[3];

/// The chunks' vectors, one after another.
template <class T>
std::vector<T> joined(std::vector<ObjChunk>& chunks, std::vector<T> ObjChunk::*member) {
    if (chunks.size() == 1) return std::move(chunks.front().*member);
    std::size_t count = 0;
    for (const ObjChunk& chunk : chunks) count += (chunk.*member).size();
    std::vector<T> all;
    all.reserve(count);
    for (ObjChunk& chunk : chunks) {
        all.insert(all.end(), (chunk.*member).begin(), (chunk.*member).end());
        (chunk.*member) = {};
    }
    return all;
}

/// Whether some of a run's polygons could only be cut roughly, and the first of them.
struct RoughCut {
    bool found = false;
    std::uint32_t face = 0;
};

/// Fills the run's triangles; indices are the file's.
RoughCut fill_triangles(const ObjChunk& chunk, const ObjRun& run, std::span<const Vec3> positions, Mesh::Triangle* to) {
    PolygonCutter cutter;
    std::vector<Vec3> polygon;
    RoughCut rough;
    std::uint32_t first = run.first_face > 0 ? chunk.face_ends[run.first_face - 1] : 0;
    const auto emit = [&](const ObjCorner* corners, const PolygonCutter::Triangle& cut) {
        const ObjCorner& a = corners[cut[0]];
        const ObjCorner& b = corners[cut[1]];
        const ObjCorner& c = corners[cut[2]];
        *to++ = {{a.position, b.position, c.position},
                 {a.normal, b.normal, c.normal},
                 {a.texcoord, b.texcoord, c.texcoord},
                 run.material};
    };
    for (std::uint32_t face = run.first_face; face < run.end_face; ++face) {
        const std::uint32_t end = chunk.face_ends[face];
        const ObjCorner* const corners = chunk.corners.data() + first;
        if (end - first == 3) {
            emit(corners, {0, 1, 2});
        } else {
            polygon.clear();
            for (std::uint32_t i = first; i < end; ++i) polygon.push_back(positions[chunk.corners[i].position]);
            for (const PolygonCutter::Triangle& cut : cutter.cut(polygon)) emit(corners, cut);
            if (cutter.approximate() && !rough.found) rough = {true, face};
        }
        first = end;
    }
    return rough;
}

/// Takes from `all` what the triangles use, in the same order, and renumbers the triangles.
template <class T>
void take_used(std::vector<Mesh::Triangle>& triangles, Corners corners, std::vector<T>& all, bool may_move,
               std::vector<T>& used) {
    std::uint32_t low = UINT32_MAX, high = 0;
    std::size_t references = 0;
    for (const Mesh::Triangle& t : triangles) {
        for (const std::uint32_t i : t.*corners) {
            if (i == kNone) continue;
            low = std::min(low, i), high = std::max(high, i);
            ++references;
        }
    }
    if (references == 0) return;
    const std::size_t range = std::size_t{high} - low + 1;
    if (range > 4 * references + 1024) {
        // Few of a wide range: a table of it for each object could grow without bound against the file.
        std::vector<std::uint32_t> sorted;
        sorted.reserve(references);
        for (const Mesh::Triangle& t : triangles)
            for (const std::uint32_t i : t.*corners)
                if (i != kNone) sorted.push_back(i);
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        for (const std::uint32_t i : sorted) used.push_back(all[i]);
        for (Mesh::Triangle& t : triangles)
            for (std::uint32_t& i : t.*corners)
                if (i != kNone)
                    i = static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), i) - sorted.begin());
        return;
    }
    std::vector<std::uint32_t> renumbered(range, 0);
    for (const Mesh::Triangle& t : triangles)
        for (const std::uint32_t i : t.*corners)
            if (i != kNone) renumbered[i - low] = 1;
    std::uint32_t count = 0;
    for (std::uint32_t& number : renumbered) number = number == 0 ? kNone : count++;
    if (may_move && count == all.size()) {
        used = std::move(all);
        return;
    }
    used.resize(count);
    for (std::size_t i = 0; i < range; ++i)
        if (renumbered[i] != kNone) used[renumbered[i]] = all[low + i];
    if (count == range && low == 0) return;
    for (Mesh::Triangle& t : triangles)
        for (std::uint32_t& i : t.*corners)
            if (i != kNone) i = renumbered[i - low];
}

void warn_rough(const ObjFile& file, std::span<const ObjRun> runs, std::span<const RoughCut> rough,
                const WarningSink& warn) {
    const auto first = std::find_if(rough.begin(), rough.end(), [](const RoughCut& r) { return r.found; });
    if (first == rough.end() || !warn) return;
    const ObjRun& run = runs[static_cast<std::size_t>(first - rough.begin())];
    const ObjFaceLine line = find_face_line(file.chunks[run.chunk], first->face);
    warn(diagnose(Severity::warning, file.source, line.text, line_number(file, run.chunk, line.line), line.text.data(),
                  "a polygon that crosses itself is drawn roughly (said once a file)"));
}

}  // namespace

void build_meshes(ObjFile& file, std::span<ObjRun> runs, std::span<scene::Object> objects, const WarningSink& warn) {
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> texcoords;
    tbb::parallel_invoke([&] { positions = joined(file.chunks, &ObjChunk::positions); },
                         [&] {
                             normals = joined(file.chunks, &ObjChunk::normals);
                             texcoords = joined(file.chunks, &ObjChunk::texcoords);
                         });
    std::vector<std::uint32_t> triangle_counts(objects.size(), 0);
    for (ObjRun& run : runs) {
        const ObjChunk& chunk = file.chunks[run.chunk];
        const std::uint32_t first_corner = run.first_face > 0 ? chunk.face_ends[run.first_face - 1] : 0;
        const std::uint32_t corners = chunk.face_ends[run.end_face - 1] - first_corner;
        run.first_triangle = triangle_counts[run.object];
        triangle_counts[run.object] += corners - 2 * (run.end_face - run.first_face);
    }
    for (std::size_t i = 0; i < objects.size(); ++i)
        std::get<Boxed<Mesh>>(objects[i].shape)->triangles.resize(triangle_counts[i]);

    std::vector<RoughCut> rough(runs.size());
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
        Mesh& mesh = *std::get<Boxed<Mesh>>(objects[runs[i].object].shape);
        rough[i] = fill_triangles(file.chunks[runs[i].chunk], runs[i], positions,
                                  mesh.triangles.data() + runs[i].first_triangle);
    });
    warn_rough(file, runs, rough, warn);
    smooth_normals(runs, objects, positions, normals);

    const bool alone = objects.size() == 1;
    tbb::parallel_for(std::size_t{0}, objects.size(), [&](std::size_t i) {
        Mesh& mesh = *std::get<Boxed<Mesh>>(objects[i].shape);
        tbb::parallel_invoke(
            [&] { take_used(mesh.triangles, &Mesh::Triangle::position, positions, alone, mesh.positions); },
            [&] { take_used(mesh.triangles, &Mesh::Triangle::normal, normals, alone, mesh.normals); },
            [&] { take_used(mesh.triangles, &Mesh::Triangle::texcoord, texcoords, alone, mesh.texcoords); });
    });
}

}  // namespace sundog::import
