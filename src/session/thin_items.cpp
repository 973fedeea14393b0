// SPDX-License-Identifier: Apache-2.0
#include "session/thin_items.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>

#include "sampling/traced_grid.h"

namespace sundog {
namespace {

using sampling::kSquareSide;

Vec3 to_vec(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

ThinItem item_of(const Bounds3& bounds, std::uint32_t instance) {
    const Vec3 half = bounds.extent() * 0.5F;
    return {bounds.lower + half, {half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}, instance};
}

/// Splits a mesh's triangles into connected parts, and those into pieces that fill their boxes.
class MeshParts {
public:
    MeshParts(const RenderScene& scene, const kernel::Geometry& geometry, std::vector<ThinItem>& out)
        : scene_(scene), geometry_(geometry), out_(out) {}

    void add() {
        std::vector<std::uint32_t> order(geometry_.primitive_count);
        std::iota(order.begin(), order.end(), geometry_.first_primitive);
        const std::vector<std::uint32_t> parts = connected(order);
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return parts[a - geometry_.first_primitive] < parts[b - geometry_.first_primitive];
        });
        for (std::size_t begin = 0; begin < order.size();) {
            const std::uint32_t part = parts[order[begin] - geometry_.first_primitive];
            std::size_t end = begin;
            while (end < order.size() && parts[order[end] - geometry_.first_primitive] == part) ++end;
            add_piece(std::span(order).subspan(begin, end - begin), 0);
            begin = end;
        }
    }

private:
    /// The number of the part that each triangle belongs to: triangles that share a corner are of one.
    std::vector<std::uint32_t> connected(std::span<const std::uint32_t> triangles) {
        std::vector<std::uint32_t> parent(triangles.size());
        std::iota(parent.begin(), parent.end(), 0U);
        const auto root = [&](std::uint32_t i) {
            while (parent[i] != i) i = parent[i] = parent[parent[i]];
            return i;
        };
        std::unordered_map<std::uint32_t, std::uint32_t> first_with;
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const kernel::Triangle& t = scene_.triangles[triangles[i]];
            for (const std::uint32_t corner : {t.p0, t.p1, t.p2}) {
                const auto [known, is_new] = first_with.try_emplace(corner, i);
                if (is_new) continue;
                const std::uint32_t a = root(known->second), b = root(i);
                parent[std::max(a, b)] = std::min(a, b);
            }
        }
        for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = root(i);
        return parent;
    }

    /// A piece whose surface is small beside its box's has room for others between its parts: it is cut in two.
    void add_piece(std::span<std::uint32_t> triangles, int depth) {
        constexpr int kDeepest = 8;
        constexpr float kFilled = 0.2F;
        const ThinItem box = box_around(triangles);
        float area = 0;
        for (const std::uint32_t i : triangles) {
            const kernel::Triangle& t = scene_.triangles[i];
            area += 0.5F * length(cross(position(t.p1) - position(t.p0), position(t.p2) - position(t.p0)));
        }
        if (triangles.size() > 1 && depth < kDeepest && area < kFilled * surface_of(box)) {
            const Vec3 along = length(box.half_x) > 0 ? normalize(box.half_x) : Vec3{1, 0, 0};
            const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
            std::nth_element(triangles.begin(), middle, triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
                return dot(middle_of(a), along) < dot(middle_of(b), along);
            });
            add_piece(triangles.subspan(0, triangles.size() / 2), depth + 1);
            add_piece(triangles.subspan(triangles.size() / 2), depth + 1);
            return;
        }
        out_.push_back(box);
    }

    /// A box around triangles, its first side along the longest way through them.
    [[nodiscard]] ThinItem box_around(std::span<const std::uint32_t> triangles) const {
        const auto farthest = [&](const auto& how_far) {
            Vec3 best;
            float most = -1;
            for (const std::uint32_t i : triangles)
                for (const std::uint32_t corner :
                     {scene_.triangles[i].p0, scene_.triangles[i].p1, scene_.triangles[i].p2})
                    if (const float far = how_far(position(corner)); far > most) most = far, best = position(corner);
            return best;
        };
        const Vec3 any = position(scene_.triangles[triangles[0]].p0);
        const Vec3 start = farthest([&](Vec3 p) { return dot(p - any, p - any); });
        const Vec3 end = farthest([&](Vec3 p) { return dot(p - start, p - start); });
        const auto unit_or = [](Vec3 v, Vec3 otherwise) { return length(v) > 0 ? normalize(v) : otherwise; };
        const Vec3 x = unit_or(end - start, {1, 0, 0});
        const auto across = [&](Vec3 p) { return (p - start) - x * dot(p - start, x); };
        const Vec3 side = farthest([&](Vec3 p) { return dot(across(p), across(p)); });
        const Vec3 least = std::abs(x.x) < 0.6F ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 y = unit_or(across(side), normalize(cross(x, least)));
        const Vec3 z = cross(x, y);
        Bounds3 in_axes;
        for (const std::uint32_t i : triangles)
            for (const std::uint32_t corner :
                 {scene_.triangles[i].p0, scene_.triangles[i].p1, scene_.triangles[i].p2}) {
                const Vec3 p = position(corner);
                in_axes.include(Vec3{dot(p, x), dot(p, y), dot(p, z)});
            }
        const Vec3 center = in_axes.center();
        const Vec3 half = in_axes.extent() * 0.5F;
        return {x * center.x + y * center.y + z * center.z, x * half.x, y * half.y, z * half.z, geometry_.instance};
    }
    static float surface_of(const ThinItem& box) {
        const float x = length(box.half_x), y = length(box.half_y), z = length(box.half_z);
        return 8 * (x * y + y * z + z * x);
    }
    [[nodiscard]] Vec3 position(std::uint32_t i) const { return to_vec(scene_.positions[i]); }
    [[nodiscard]] Vec3 middle_of(std::uint32_t triangle) const {
        const kernel::Triangle& t = scene_.triangles[triangle];
        return (position(t.p0) + position(t.p1) + position(t.p2)) / 3.0F;
    }

    const RenderScene& scene_;
    const kernel::Geometry& geometry_;
    std::vector<ThinItem>& out_;
};

Vec3 corner_of(const ThinItem& item, int corner) {
    const auto sign = [&](int bit) { return (corner & bit) != 0 ? 1.0F : -1.0F; };
    return item.center + item.half_x * sign(1) + item.half_y * sign(2) + item.half_z * sign(4);
}

/// Boxes around runs of neighbours in the list, which are mostly neighbours in space.
void merge_runs(std::vector<ThinItem>& items) {
    const std::size_t run = (items.size() + kMostItems - 1) / kMostItems;
    std::vector<ThinItem> merged;
    for (std::size_t begin = 0; begin < items.size();) {
        Bounds3 bounds;
        std::size_t i = begin;
        for (; i < std::min(begin + run, items.size()) && items[i].instance == items[begin].instance; ++i)
            for (int corner = 0; corner < 8; ++corner) bounds.include(corner_of(items[i], corner));
        merged.push_back(item_of(bounds, items[begin].instance));
        begin = i;
    }
    items = std::move(merged);
}

struct Point2 {
    float x = 0, y = 0;
};

/// World points to pixels, for cameras of straight lines.
class Projection {
public:
    explicit Projection(const kernel::FrameParams& frame)
        : camera_(frame.camera),
          orthographic_(frame.camera_kind == kernel::CAMERA_ORTHOGRAPHIC),
          width_(static_cast<float>(frame.width)),
          height_(static_cast<float>(frame.height)) {}

    /// None behind the eye.
    [[nodiscard]] std::optional<Point2> operator()(Vec3 p) const {
        const Vec3 right = to_vec(camera_.right), up = to_vec(camera_.up), center = to_vec(camera_.center);
        const Vec3 from_eye = p - to_vec(camera_.eye);
        const Vec3 along = normalize(center);
        // In terms of center, right and up, which need not be at right angles to each other.
        const float volume = dot(center, cross(right, up));
        if (volume == 0) return std::nullopt;
        float depth = dot(from_eye, cross(right, up)) / volume;
        float x = dot(center, cross(from_eye, up)) / volume;
        float y = dot(center, cross(right, from_eye)) / volume;
        if (!orthographic_) {
            if (dot(from_eye, along) <= 1e-6F * length(from_eye) || depth <= 0) return std::nullopt;
            x /= depth;
            y /= depth;
        }
        return Point2{(x + 1) * 0.5F * width_ - 0.5F, (1 - y) * 0.5F * height_ - 0.5F};
    }

private:
    kernel::Camera camera_;
    bool orthographic_;
    float width_, height_;
};

/// The convex hull, counterclockwise (Andrew 1979, the monotone chain).
std::vector<Point2> hull_of(std::array<Point2, 8> points) {
    std::sort(points.begin(), points.end(),
              [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Point2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t base = hull.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point2& p = points[side == 0 ? i : points.size() - 1 - i];
            while (hull.size() >= base + 2) {
                const Point2& a = hull[hull.size() - 2];
                const Point2& b = hull.back();
                if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0) break;
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
    }
    if (hull.empty()) hull.push_back(points[0]);
    return hull;
}

/// The least distance between two parallel lines that hold all of it.
float width_of(std::span<const Point2> hull) {
    if (hull.size() < 3) return 0;
    float least = INFINITY;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point2& a = hull[i];
        const Point2& b = hull[(i + 1) % hull.size()];
        const float length = std::hypot(b.x - a.x, b.y - a.y);
        if (length < 1e-6F) continue;
        float most = 0;
        for (const Point2& p : hull)
            most = std::max(most, std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length);
        least = std::min(least, most);
    }
    return std::isfinite(least) ? least : 0;
}

/// Whether a hull comes into a square: no side of either lies between them.
bool meets(std::span<const Point2> hull, float x, float y, float side) {
    for (std::size_t i = 0; hull.size() > 2 && i < hull.size(); ++i) {
        const Point2& a = hull[i];
        const Point2& b = hull[(i + 1) % hull.size()];
        bool all_outside = true;
        for (const Point2 corner : {Point2{x, y}, Point2{x + side, y}, Point2{x, y + side}, Point2{x + side, y + side}})
            all_outside = all_outside && (b.x - a.x) * (corner.y - a.y) - (b.y - a.y) * (corner.x - a.x) < 0;
        if (all_outside) return false;
    }
    return true;
}

}  // namespace

std::vector<ThinItem> thin_items(const RenderScene& scene) {
    std::vector<ThinItem> items;
    for (const kernel::Geometry& g : scene.geometries) {
        if ((g.hidden_from & kernel::RAY_CAMERA) != 0) continue;
        if (g.kind == kernel::GEOMETRY_TRIANGLES) {
            MeshParts(scene, g, items).add();
            continue;
        }
        for (std::uint32_t i = g.first_primitive; i < g.first_primitive + g.primitive_count; ++i) {
            Bounds3 bounds;
            if (g.kind == kernel::GEOMETRY_SPHERE) {
                const kernel::Sphere& s = scene.spheres[i];
                bounds.include(to_vec(s.center) - Vec3{s.radius, s.radius, s.radius});
                bounds.include(to_vec(s.center) + Vec3{s.radius, s.radius, s.radius});
            } else if (g.kind == kernel::GEOMETRY_BOX) {
                bounds.include(to_vec(scene.boxes[i].lower)), bounds.include(to_vec(scene.boxes[i].upper));
            } else {
                continue;
            }
            items.push_back(item_of(bounds, g.instance));
        }
    }
    for (const PlacedSolid& placed : scene.solids) {
        const Bounds3& b = placed.bounds;
        if (std::isfinite(length(b.lower)) && std::isfinite(length(b.upper)) && b.lower.x <= b.upper.x)
            items.push_back(item_of(b, kernel::NONE));
    }
    if (items.size() > kMostItems) merge_runs(items);
    return items;
}

std::vector<std::uint8_t> finest_squares(const std::vector<ThinItem>& items, const Frame& frame) {
    const kernel::FrameParams& params = frame.params;
    if (params.camera_kind != kernel::CAMERA_PERSPECTIVE && params.camera_kind != kernel::CAMERA_ORTHOGRAPHIC)
        return {};
    const auto squares = [](std::uint32_t pixels) {
        return (static_cast<int>(pixels) + kSquareSide - 1) / kSquareSide;
    };
    const int columns = squares(params.width), rows = squares(params.height);
    std::vector<std::uint8_t> finest(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kSquareSide);
    const Projection project(params);
    for (const ThinItem& item : items) {
        std::array<Point2, 8> corners;
        bool in_front = true;
        for (std::size_t i = 0; i < corners.size() && in_front; ++i) {
            Vec3 p = corner_of(item, static_cast<int>(i));
            if (item.instance != kernel::NONE) {
                const kernel::Instance& m = frame.instances[item.instance];
                p = to_vec(m.world_from_object_x) * p.x + to_vec(m.world_from_object_y) * p.y +
                    to_vec(m.world_from_object_z) * p.z + to_vec(m.world_from_object_t);
            }
            const std::optional<Point2> seen = project(p);
            in_front = seen.has_value();
            if (seen) corners[i] = *seen;
        }
        if (!in_front) continue;
        const auto [left, right] = std::minmax_element(corners.begin(), corners.end(),
                                                       [](const Point2& a, const Point2& b) { return a.x < b.x; });
        const auto [top, bottom] = std::minmax_element(corners.begin(), corners.end(),
                                                       [](const Point2& a, const Point2& b) { return a.y < b.y; });
        const auto width = static_cast<float>(params.width), height = static_cast<float>(params.height);
        if (right->x < 0 || left->x > width || bottom->y < 0 || top->y > height) continue;
        const std::vector<Point2> hull = hull_of(corners);
        const float thickness = width_of(hull);
        // A disc as wide as a square's diagonal holds a corner wherever it lies, and a box at least its inscribed disc.
        constexpr float kDiagonal = 1.4142136F;
        if (thickness >= kDiagonal * kSquareSide) continue;
        std::uint8_t side = kSquareSide;
        while (side > 1 && thickness < kDiagonal * static_cast<float>(side)) side /= 2;
        const auto first = [](float at) { return std::max(0, static_cast<int>(std::floor(at)) / kSquareSide); };
        const int last_column = std::min(columns - 1, static_cast<int>(std::min(right->x, width)) / kSquareSide);
        const int last_row = std::min(rows - 1, static_cast<int>(std::min(bottom->y, height)) / kSquareSide);
        for (int row = first(std::max(top->y, 0.0F)); row <= last_row; ++row)
            for (int column = first(std::max(left->x, 0.0F)); column <= last_column; ++column) {
                std::uint8_t& mark = finest[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                                            static_cast<std::size_t>(column)];
                if (mark > side && meets(hull, static_cast<float>(column * kSquareSide),
                                         static_cast<float>(row * kSquareSide), static_cast<float>(kSquareSide)))
                    mark = side;
            }
    }
    return finest;
}

}  // namespace sundog
