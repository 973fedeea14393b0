// SPDX-License-Identifier: Apache-2.0
#include "bake/patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

namespace sundog::bake {
namespace {

/// What tells vertices apart that stand in one place.
struct Corner {
    std::uint32_t position, normal, texcoord;
    auto operator<=>(const Corner&) const = default;  // NOLINT(modernize-use-nullptr): its own zero
};

Vec3 unit(Vec3 v) {
    const float len = length(v);
    return len > 0 ? v * (1 / len) : Vec3{0, 0, 1};
}

/// A normal where its surface is moved: by the cofactors of the matrix.
Vec3 moved_normal(const Affine3& m, Vec3 n) {
    return unit(cross(m.y, m.z) * n.x + cross(m.z, m.x) * n.y + cross(m.x, m.y) * n.z);
}

class Divider {
public:
    Divider(Part& part, float longest) : part_(part), longest_(longest) {}

    /// Divides all triangles until no edge is too long.
    void run() {
        for (bool divided = true; divided;) {
            divided = false;
            std::vector<std::array<std::uint32_t, 3>> next;
            next.reserve(part_.triangles.size());
            for (const auto& t : part_.triangles) divided |= divide(t, next);
            part_.triangles = std::move(next);
            if (part_.positions.size() > kMostVertices)
                throw InputError({Severity::error,
                                  {},
                                  "object '" + part_.object + "' would have too many patches",
                                  "",
                                  "make patches larger: --patch"});
        }
    }

private:
    [[nodiscard]] bool is_long(std::uint32_t a, std::uint32_t b) const {
        return length(part_.positions[a] - part_.positions[b]) > longest_;
    }

    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        // One for both triangles of an edge. Neighbours with vertices of their own get it from the same two places.
        const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
        const auto [known, is_new] = middles_.try_emplace(key, static_cast<std::uint32_t>(part_.positions.size()));
        if (is_new) {
            part_.positions.push_back((part_.positions[a] + part_.positions[b]) * 0.5F);
            part_.normals.push_back(unit(part_.normals[a] + part_.normals[b]));
            part_.texcoords.push_back({(part_.texcoords[a].x + part_.texcoords[b].x) * 0.5F,
                                       (part_.texcoords[a].y + part_.texcoords[b].y) * 0.5F});
        }
        return known->second;
    }

    bool divide(std::array<std::uint32_t, 3> t, std::vector<std::array<std::uint32_t, 3>>& out) {
        std::array<bool, 3> cut{};
        int cuts = 0;
        for (std::size_t e = 0; e < 3; ++e) {
            cut[e] = is_long(t[e], t[(e + 1) % 3]);
            cuts += cut[e] ? 1 : 0;
        }
        if (cuts == 0) {
            out.push_back(t);
            return false;
        }
        // Turned so that edge 0 is cut, and with two cuts edge 1 as well.
        const auto turn = [&] {
            std::rotate(t.begin(), t.begin() + 1, t.end());
            std::rotate(cut.begin(), cut.begin() + 1, cut.end());
        };
        while (!cut[0] || (cuts == 2 && !cut[1])) turn();
        const std::uint32_t m0 = middle(t[0], t[1]);
        if (cuts == 1) {
            out.push_back({t[0], m0, t[2]});
            out.push_back({m0, t[1], t[2]});
            return true;
        }
        const std::uint32_t m1 = middle(t[1], t[2]);
        out.push_back({m0, t[1], m1});
        if (cuts == 2) {
            out.push_back({t[0], m0, m1});
            out.push_back({t[0], m1, t[2]});
            return true;
        }
        const std::uint32_t m2 = middle(t[2], t[0]);
        out.push_back({t[0], m0, m2});
        out.push_back({m0, m1, m2});
        out.push_back({m2, m1, t[2]});
        return true;
    }

    Part& part_;
    float longest_;
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

/// Where the light of each vertex is asked: a little inside of its largest face, so that corners of a room don't see
/// the other side of its walls.
void find_insides(Part& part) {
    std::vector<float> largest(part.positions.size(), -1);
    part.inside = part.positions;
    for (const auto& t : part.triangles) {
        const Vec3 a = part.positions[t[0]], b = part.positions[t[1]], c = part.positions[t[2]];
        const float area = length(cross(b - a, c - a));
        const Vec3 middle = (a + b + c) * (1 / 3.0F);
        for (const std::uint32_t v : t) {
            if (area <= largest[v]) continue;
            largest[v] = area;
            part.inside[v] = part.positions[v] * 0.9F + middle * 0.1F;
        }
    }
}

/// A mesh's triangles by material.
void add_mesh(const scene::Object& object, std::size_t source, const scene::Mesh& mesh,
              const Affine3& world_from_object, std::vector<Part>& parts) {
    std::map<scene::Index, std::size_t> part_of;
    std::map<std::pair<scene::Index, Corner>, std::uint32_t> known;
    std::map<std::array<int, 3>, std::uint32_t> flat_normals;
    const auto vertex_of = [&](Part& part, const scene::Mesh::Triangle& t, std::size_t k, std::uint32_t flat,
                               Vec3 face) {
        const bool smooth = t.normal[k] != scene::kNone;
        const Corner corner{t.position[k], smooth ? t.normal[k] : 0x80000000U | flat, t.texcoord[k]};
        const auto [found, is_new] =
            known.try_emplace({t.material, corner}, static_cast<std::uint32_t>(part.positions.size()));
        if (!is_new) return found->second;
        part.positions.push_back(transform_point(world_from_object, mesh.positions[t.position[k]]));
        Vec3 normal = face;
        if (smooth) {
            // Vertex normals may have been written for either side.
            normal = moved_normal(world_from_object, mesh.normals[t.normal[k]]);
            if (dot(normal, face) < 0) normal = normal * -1;
        }
        part.normals.push_back(normal);
        part.texcoords.push_back(t.texcoord[k] != scene::kNone ? mesh.texcoords[t.texcoord[k]] : Vec2{0, 0});
        return found->second;
    };
    for (const scene::Mesh::Triangle& t : mesh.triangles) {
        const auto [at, is_new] = part_of.try_emplace(t.material, parts.size());
        if (is_new) {
            parts.emplace_back();
            parts.back().object = object.name;
            parts.back().source = source;
            parts.back().material = t.material;
        }
        Part& part = parts[at->second];
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = transform_point(world_from_object, mesh.positions[t.position[k]]);
        const Vec3 across = cross(p[1] - p[0], p[2] - p[0]);
        if (!(length(across) > 0)) continue;
        const Vec3 face = unit(across);
        // Faces of one plane share their corners.
        const auto rounded = [](float v) { return static_cast<int>(std::lround(v * 2000)); };
        const std::uint32_t flat = flat_normals
                                       .try_emplace({rounded(face.x), rounded(face.y), rounded(face.z)},
                                                    static_cast<std::uint32_t>(flat_normals.size()))
                                       .first->second;
        part.triangles.push_back(
            {vertex_of(part, t, 0, flat, face), vertex_of(part, t, 1, flat, face), vertex_of(part, t, 2, flat, face)});
    }
}

/// A box's six sides as a mesh.
scene::Mesh mesh_of(const scene::Box& box, scene::Index material) {
    scene::Mesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.positions.push_back({(i & 1U) ? box.upper.x : box.lower.x, (i & 2U) ? box.upper.y : box.lower.y,
                                  (i & 4U) ? box.upper.z : box.lower.z});
    constexpr scene::Index n = scene::kNone;
    constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : sides) {
        mesh.triangles.push_back({{a, b, c}, {n, n, n}, {n, n, n}, material});
        mesh.triangles.push_back({{a, c, d}, {n, n, n}, {n, n, n}, material});
    }
    return mesh;
}

/// A ball by rows and columns, its edges no longer than asked, with smooth normals.
scene::Mesh mesh_of(const scene::Sphere& ball, scene::Index material, float longest) {
    const double around = 2 * std::numbers::pi * ball.radius / std::max(longest, 1e-6F);
    const auto columns = static_cast<std::uint32_t>(std::clamp(std::ceil(around), 12.0, 4096.0));
    const std::uint32_t rows = columns / 2;
    scene::Mesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double down = std::numbers::pi * row / rows, turn = 2 * std::numbers::pi * column / columns;
            const Vec3 n{static_cast<float>(std::sin(down) * std::cos(turn)),
                         static_cast<float>(std::sin(down) * std::sin(turn)), static_cast<float>(std::cos(down))};
            mesh.normals.push_back(n);
            mesh.positions.push_back(ball.center + n * ball.radius);
        }
    constexpr scene::Index none = scene::kNone;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({{a, b, c}, {a, b, c}, {none, none, none}, material});
    };
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * columns + column, b = row * columns + (column + 1) % columns;
            if (row + 1 < rows) add(a, a + columns, b + columns);
            if (row > 0) add(a, b + columns, b);
        }
    return mesh;
}

/// Brings vertices that came between a ball's first ones up to the ball.
void round_off(const scene::Sphere& ball, const Affine3& world_from_object, Part& part) {
    const Affine3 object_from_world = inverse(world_from_object);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
        const Vec3 out = unit(transform_point(object_from_world, part.positions[v]) - ball.center);
        const Vec3 normal = moved_normal(world_from_object, out);
        part.positions[v] = transform_point(world_from_object, ball.center + out * ball.radius);
        part.normals[v] = dot(normal, part.normals[v]) < 0 ? normal * -1 : normal;
    }
}

}  // namespace

std::vector<Part> parts_of(const scene::Scene& scene, float time_s, float longest_edge, const WarningSink& warn) {
    std::vector<Part> parts;
    for (std::size_t source = 0; source < scene.objects.size(); ++source) {
        const scene::Object& object = scene.objects[source];
        if (!object.seen_by_camera || object.projects != 0) continue;
        const Affine3 place = scene::transform_at(object, time_s);
        if (const auto* mesh = std::get_if<Boxed<scene::Mesh>>(&object.shape)) {
            add_mesh(object, source, **mesh, place, parts);
        } else if (const auto* box = std::get_if<scene::Box>(&object.shape)) {
            add_mesh(object, source, mesh_of(*box, object.material), place, parts);
        } else if (const auto* ball = std::get_if<scene::Sphere>(&object.shape)) {
            add_mesh(object, source, mesh_of(*ball, object.material, longest_edge), place, parts);
        } else if (warn) {
            warn(
                {Severity::warning, object.where, "object '" + object.name + "' has no triangles to be baked", "", ""});
        }
    }
    std::erase_if(parts, [](const Part& part) { return part.triangles.empty(); });
    for (Part& part : parts) {
        part.undivided = part.triangles;
        Divider(part, longest_edge).run();
        const scene::Object& object = scene.objects[part.source];
        if (const auto* ball = std::get_if<scene::Sphere>(&object.shape)) {
            round_off(*ball, scene::transform_at(object, time_s), part);
            part.undivided = part.triangles;
        }
        find_insides(part);
    }
    return parts;
}

}  // namespace sundog::bake
