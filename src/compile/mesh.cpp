// SPDX-License-Identifier: Apache-2.0
#include "compile/mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>

#include "compile/convert.h"

namespace sundog {
namespace {

constexpr std::size_t kBlock = 8192;  // Triangles or vertices that one task takes.

/// A triangle whose normal can't be formed in single precision: no area, or so large or small that its squared
/// area leaves the range of normal floats.
bool usable(const scene::Mesh& mesh, const scene::Mesh::Triangle& t) {
    const Vec3 a = mesh.positions[t.position[0]];
    const Vec3 n = cross(mesh.positions[t.position[1]] - a, mesh.positions[t.position[2]] - a);
    const float squared = dot(n, n);
    return squared >= FLT_MIN && squared <= FLT_MAX;
}

template <class Body>
void parallel_blocks(std::size_t count, const Body& body) {
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    tbb::parallel_for(std::size_t{0}, blocks,
                      [&](std::size_t b) { body(b, b * kBlock, std::min(count, (b + 1) * kBlock)); });
}

[[noreturn]] void throw_too_large(const scene::Object& object, const char* what) {
    throw InputError({Severity::error, object.where,
                      "object '" + object.name + "': the scene holds more " + what + " than 32-bit indices can count",
                      "", "at most 4294967294 of them are possible"});
}

/// Where this mesh's entries begin in `array` when `count` more are appended to it.
template <class T>
std::uint32_t grow(std::vector<T>& array, std::size_t count, const scene::Object& object, const char* what) {
    const std::size_t first = array.size();
    if (first + count >= kernel::NONE) throw_too_large(object, what);
    array.resize(first + count);
    return static_cast<std::uint32_t>(first);
}

kernel::TriangleCorners corners(const std::uint32_t (&index)[3], std::uint32_t first, std::uint32_t stride = 1) {
    if (index[0] == scene::kNone || index[1] == scene::kNone || index[2] == scene::kNone)
        return {kernel::NONE, kernel::NONE, kernel::NONE};
    return {first + stride * index[0], first + stride * index[1], first + stride * index[2]};
}

/// A vertex's further numbers, behind its texture coordinates at `vertex`.
void put(const scene::Mesh::Attributes& a, kernel::vec2* vertex) {
    vertex[kernel::VERTEX_SECOND_UV] = to_kernel(a.second_texcoord);
    vertex[kernel::VERTEX_COLOR] = {a.color.x, a.color.y};
    vertex[kernel::VERTEX_COLOR + 1] = {a.color.z, a.alpha};
    vertex[kernel::VERTEX_TANGENT] = {a.tangent.x, a.tangent.y};
    vertex[kernel::VERTEX_TANGENT + 1] = {a.tangent.z, a.handedness};
}

bool is_zero(const kernel::vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// A vertex normal without a direction can't be used: such triangles are flat.
kernel::TriangleCorners flat_where_zero(kernel::TriangleCorners c, const std::vector<kernel::vec3>& normals) {
    if (c.a != kernel::NONE && (is_zero(normals[c.a]) || is_zero(normals[c.b]) || is_zero(normals[c.c])))
        return {kernel::NONE, kernel::NONE, kernel::NONE};
    return c;
}

/// For each block of triangles, the place of its first usable one in the output; the last entry is their number.
std::vector<std::size_t> output_offsets(const scene::Mesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    std::vector<std::size_t> offset((count + kBlock - 1) / kBlock + 1);
    parallel_blocks(count, [&](std::size_t block, std::size_t begin, std::size_t end) {
        offset[block + 1] =
            static_cast<std::size_t>(std::count_if(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(begin),
                                                   mesh.triangles.begin() + static_cast<std::ptrdiff_t>(end),
                                                   [&](const scene::Mesh::Triangle& t) { return usable(mesh, t); }));
    });
    for (std::size_t i = 1; i < offset.size(); ++i) offset[i] += offset[i - 1];
    return offset;
}

void warn_of_dropped(const scene::Object& object, std::size_t dropped, std::size_t total, const WarningSink& warn) {
    if (dropped == 0 || !warn) return;
    warn({Severity::warning, object.where,
          "object '" + object.name + "': " + std::to_string(dropped) + " of " + std::to_string(total) +
              (total == 1 ? " triangle has" : " triangles have") +
              " no area, or one beyond single precision, and can't be seen; left out",
          "", ""});
}

/// A number for a place that hardly any other has (the mixing of Steele, Lea and Flood's SplitMix64, 2014).
std::uint64_t hash_of(Vec3 p) {
    std::uint64_t hash = 0x9e3779b97f4a7c15U;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Zero has two signs.
        hash ^= std::bit_cast<std::uint32_t>(p[axis] + 0.0F);
        hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
        hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
        hash ^= hash >> 31U;
    }
    return hash;
}

/// A number for an edge; the same edge the other way round has its negative.
std::uint64_t hash_of(std::uint64_t from, std::uint64_t to) {
    std::uint64_t hash = std::min(from, to) * 3 + std::max(from, to);
    hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
    hash ^= hash >> 31U;
    return from < to ? hash : from > to ? ~hash + 1 : 0;
}

}  // namespace

/// Each edge of a closed surface belongs to two triangles, which go along it in opposite ways: then the sum of all
/// edges' hashes is 0, and otherwise hardly ever. Seen from outside, a surface around a volume shows its front.
bool is_closed(const scene::Mesh& mesh) {
    struct Sums {
        std::uint64_t edges = 0;
        double volume = 0;
    };
    const std::size_t blocks = (mesh.triangles.size() + kBlock - 1) / kBlock;
    std::vector<Sums> sums(blocks);
    parallel_blocks(mesh.triangles.size(), [&](std::size_t block, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const scene::Mesh::Triangle& t = mesh.triangles[i];
            std::array<std::uint64_t, 3> corner{};
            std::array<Vec3, 3> place;
            for (std::size_t k = 0; k < 3; ++k) place[k] = mesh.positions[t.position[k]], corner[k] = hash_of(place[k]);
            for (std::size_t k = 0; k < 3; ++k) sums[block].edges += hash_of(corner[k], corner[(k + 1) % 3]);
            // Six times the volume of the tetrahedron that the triangle spans with the first vertex.
            const Vec3 o = mesh.positions.front();
            sums[block].volume += static_cast<double>(dot(place[0] - o, cross(place[1] - o, place[2] - o)));
        }
    });
    Sums all;
    for (const Sums& s : sums) all.edges += s.edges, all.volume += s.volume;
    return all.edges == 0 && all.volume > 0;
}

std::uint32_t append_mesh(const scene::Object& object, const scene::Mesh& mesh, MeshAttributes attributes,
                          RenderScene& out, const WarningSink& warn) {
    const std::vector<std::size_t> offset = output_offsets(mesh);
    const std::size_t kept = offset.back();
    warn_of_dropped(object, mesh.triangles.size() - kept, mesh.triangles.size(), warn);
    if (kept == 0) return 0;

    const std::uint32_t first_position = grow(out.positions, mesh.positions.size(), object, "vertices");
    parallel_blocks(mesh.positions.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out.positions[first_position + i] = to_kernel(mesh.positions[i]);
    });
    std::uint32_t first_normal = 0;
    std::uint32_t first_uv = 0;
    if (attributes.normals) {
        first_normal = grow(out.normals, mesh.normals.size(), object, "normals");
        parallel_blocks(mesh.normals.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                out.normals[first_normal + i] = to_kernel(normalize(mesh.normals[i]));
        });
    }
    const std::uint32_t uv_stride = attributes.further ? kernel::VERTEX_UVS : 1;
    if (attributes.uvs) {
        first_uv = grow(out.uvs, uv_stride * mesh.texcoords.size(), object, "texture coordinates");
        parallel_blocks(mesh.texcoords.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                kernel::vec2* const to = &out.uvs[first_uv + uv_stride * i];
                *to = to_kernel(mesh.texcoords[i]);
                if (!attributes.further) continue;
                scene::Mesh::Attributes plain;
                plain.second_texcoord = mesh.texcoords[i];
                put(mesh.attributes.empty() ? plain : mesh.attributes[i], to);
            }
        });
    }

    const std::uint32_t first_triangle = grow(out.triangles, kept, object, "triangles");
    if (attributes.normals) out.triangle_normals.resize(out.triangles.size());
    if (attributes.uvs) out.triangle_uvs.resize(out.triangles.size());
    parallel_blocks(mesh.triangles.size(), [&](std::size_t block, std::size_t begin, std::size_t end) {
        std::size_t to = first_triangle + offset[block];
        for (std::size_t i = begin; i < end; ++i) {
            const scene::Mesh::Triangle& t = mesh.triangles[i];
            if (!usable(mesh, t)) continue;
            out.triangles[to] = {first_position + t.position[0], first_position + t.position[1],
                                 first_position + t.position[2], t.material};
            if (attributes.normals)
                out.triangle_normals[to] = flat_where_zero(corners(t.normal, first_normal), out.normals);
            if (attributes.uvs) out.triangle_uvs[to] = corners(t.texcoord, first_uv, uv_stride);
            ++to;
        }
    });
    return static_cast<std::uint32_t>(kept);
}

}  // namespace sundog
