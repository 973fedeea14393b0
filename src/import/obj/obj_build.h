// SPDX-License-Identifier: Apache-2.0
// The second step of reading an OBJ file: from the chunks' numbers to objects with meshes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "import/obj/obj_scan.h"
#include "scene/scene.h"

namespace sundog::import {

/// A scanned file. `first_*` count what earlier chunks hold.
struct ObjFile {
    struct Start {
        std::uint32_t position = 0, texcoord = 0, normal = 0, line = 0;
    };
    SourceText source;
    std::vector<ObjChunk> chunks;
    std::vector<Start> starts;  ///< One for each chunk, and one for the end of the file.
};

/// Scans a whole file in parallel, resolves all indices to the file's own (from 0) and checks them; the result doesn't
/// depend on the number of threads. `chunk_bytes` is for tests. Errors: InputError for the first bad line.
ObjFile scan_obj_file(const SourceText& source, std::size_t chunk_bytes = std::size_t{1} << 20U);

/// Number of the line (from 1) that follows `line` lines of a chunk.
std::uint32_t line_number(const ObjFile& file, std::size_t chunk, std::uint32_t line);

/// A run of faces in one chunk that share object, material and smoothing group.
struct ObjRun {
    std::uint32_t chunk;
    std::uint32_t first_face, end_face;
    std::uint32_t object;
    scene::Index material;
    std::uint32_t smoothing_group;  ///< 0: none.
    std::uint32_t first_triangle;   ///< In the object's mesh.
};

/// Builds the meshes. `objects` come with names and places and an empty mesh; `runs` in file order.
/// Warns about polygons that cross themselves.
void build_meshes(ObjFile& file, std::span<ObjRun> runs, std::span<scene::Object> objects, const WarningSink& warn);

/// Gives the triangles of runs with a smoothing group and without normals of their own the normals of their group:
/// at each vertex the sum of the group's face normals, weighted by the angle of each face there (Thürmer and Wüthrich
/// 1998, "Computing vertex normals from polygonal facets"). Triangles still use the file's own indices; new normals
/// are appended to `normals`.
void smooth_normals(std::span<const ObjRun> runs, std::span<scene::Object> objects, std::span<const Vec3> positions,
                    std::vector<Vec3>& normals);

}  // namespace sundog::import
