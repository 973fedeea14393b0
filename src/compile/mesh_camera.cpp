// SPDX-License-Identifier: Apache-2.0
// Cameras whose rays start on triangles (POV-Ray reference, section 3.4.2.2.3 "Mesh projection"). Which triangle a
// pixel gets is as in POV-Ray 3.7's pictures, whose first two rows both count as the first.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compile/camera.h"

namespace sundog {
namespace {

using scene::SolidMesh;

/// Triangles of a mesh by where they lie in texture space.
class UvGrid {
public:
    explicit UvGrid(const SolidMesh& mesh) : mesh_(mesh) {
        side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(mesh.triangles.size()))), 1, 1024);
        cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            if (mesh.triangles[i].uv[0] == SolidMesh::kNoIndex) continue;
            const std::array<Vec2, 3> uv = corners(i);
            const auto [left, right] = std::minmax({uv[0].x, uv[1].x, uv[2].x});
            const auto [bottom, top] = std::minmax({uv[0].y, uv[1].y, uv[2].y});
            if (right < 0 || left > 1 || top < 0 || bottom > 1) continue;
            // As wide as at() looks.
            const float wide = 1e-4F * std::max(right - left, top - bottom);
            for (int y = cell(bottom - wide); y <= cell(top + wide); ++y)
                for (int x = cell(left - wide); x <= cell(right + wide); ++x) cells_[index(x, y)].push_back(i);
        }
    }

    struct Found {
        std::uint32_t triangle = 0;
        std::array<float, 3> weights{};
    };
    /// The first triangle around (u, v). Edges are a little wide: places between two triangles belong to one of them.
    [[nodiscard]] std::optional<Found> at(float u, float v) const {
        constexpr float kEdge = 1e-4F;
        std::optional<Found> found;
        float best = -kEdge;
        for (const std::uint32_t i : cells_[index(cell(u), cell(v))]) {
            const std::array<Vec2, 3> uv = corners(i);
            const auto area = [](Vec2 a, Vec2 b, Vec2 c) {
                return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            };
            const float whole = area(uv[0], uv[1], uv[2]);
            if (whole == 0) continue;
            const Vec2 p{u, v};
            const float b = area(uv[0], p, uv[2]) / whole;
            const float c = area(uv[0], uv[1], p) / whole;
            const float within = std::min({1 - b - c, b, c});
            if (within >= 0) return Found{i, {1 - b - c, b, c}};
            if (within > best) best = within, found = Found{i, {1 - b - c, b, c}};
        }
        return found;
    }

private:
    [[nodiscard]] std::array<Vec2, 3> corners(std::uint32_t i) const {
        const auto& uv = mesh_.triangles[i].uv;
        return {mesh_.uvs[uv[0]], mesh_.uvs[uv[1]], mesh_.uvs[uv[2]]};
    }
    [[nodiscard]] int cell(float place) const {
        return static_cast<int>(std::clamp(place * static_cast<float>(side_), 0.0F, static_cast<float>(side_ - 1)));
    }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
    }
    const SolidMesh& mesh_;
    int side_ = 1;
    std::vector<std::vector<std::uint32_t>> cells_;
};

class TriangleCamera final : public CameraRays {
public:
    explicit TriangleCamera(std::shared_ptr<const scene::MeshCamera> camera) : camera_(std::move(camera)) {
        if (camera_->distribution == 3) grid_.emplace(*camera_->meshes.front());
    }

    [[nodiscard]] std::uint32_t most_rays() const override {
        return camera_->distribution == 0 ? static_cast<std::uint32_t>(camera_->rays_per_pixel) : 1;
    }

    [[nodiscard]] std::optional<Ray> ray(const kernel::FrameParams& frame, const Place& place) const override {
        if (grid_) return ray_by_uv(frame, place);
        const std::uint32_t row = place.y == 0 ? 0 : place.y - 1;
        const auto& meshes = camera_->meshes;
        std::size_t index = static_cast<std::size_t>(row) * frame.width + place.x;
        std::size_t mesh = 0;
        if (camera_->distribution == 0) {
            mesh = place.ray;
        } else if (camera_->distribution == 1) {
            while (mesh + 1 < meshes.size() && index >= meshes[mesh]->triangles.size())
                index -= meshes[mesh++]->triangles.size();
        } else {
            // Side by side; the columns of all but the first count on from the picture's edge.
            const auto share = static_cast<float>(frame.width) / static_cast<float>(meshes.size());
            mesh = std::min(static_cast<std::size_t>((static_cast<float>(place.x) + 0.5F) / share), meshes.size() - 1);
            index = static_cast<std::size_t>(row) * static_cast<std::size_t>(share) + place.x;
        }
        if (mesh >= meshes.size() || index >= meshes[mesh]->triangles.size()) return std::nullopt;
        const auto third = 1.0F / 3;
        return ray_from(*meshes[mesh], static_cast<std::uint32_t>(index), {third, third, third}, false);
    }

private:
    [[nodiscard]] std::optional<Ray> ray_by_uv(const kernel::FrameParams& frame, const Place& place) const {
        const float x = static_cast<float>(place.x) + place.dx - 0.5F;
        const float y = static_cast<float>(place.y) + place.dy - 0.5F;
        const auto found = grid_->at(std::max(x, 0.0F) / static_cast<float>(frame.width),
                                     1 - std::max(y, 0.5F) / static_cast<float>(frame.height));
        if (!found) return std::nullopt;
        return ray_from(*camera_->meshes.front(), found->triangle, found->weights, camera_->smooth);
    }

    [[nodiscard]] std::optional<Ray> ray_from(const SolidMesh& mesh, std::uint32_t index,
                                              const std::array<float, 3>& weights, bool smooth) const {
        const SolidMesh::Triangle& triangle = mesh.triangles[index];
        const Vec3 a = mesh.positions[triangle.position[0]];
        const Vec3 b = mesh.positions[triangle.position[1]];
        const Vec3 c = mesh.positions[triangle.position[2]];
        Vec3 normal = cross(c - a, b - a);
        if (smooth && triangle.normal[0] != SolidMesh::kNoIndex) {
            normal = {};
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 corner = mesh.normals[triangle.normal[i]];
                if (dot(corner, corner) > 0) normal += normalize(corner) * weights[i];
            }
        }
        if (!(dot(normal, normal) > 0)) return std::nullopt;
        normal = normalize(normal);
        const Vec3 origin =
            a * weights[0] + b * weights[1] + c * weights[2] + normal * static_cast<float>(camera_->offset);
        const float reach = camera_->max_distance > 0 ? static_cast<float>(camera_->max_distance)
                                                      : std::numeric_limits<float>::infinity();
        return Ray{origin, camera_->reversed ? -normal : normal, reach};
    }

    std::shared_ptr<const scene::MeshCamera> camera_;
    std::optional<UvGrid> grid_;
};

}  // namespace

std::shared_ptr<const CameraRays> make_mesh_camera(const scene::ProjectionCamera& camera) {
    return std::make_shared<TriangleCamera>(camera.mesh);
}

}  // namespace sundog
