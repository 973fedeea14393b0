// SPDX-License-Identifier: Apache-2.0
#include "compile/media_bound.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include <tbb/parallel_for.h>

#include "solids/compiled_solid.h"

namespace sundog {
namespace {

double largest(Vec3d v) { return std::max({v.x, v.y, v.z}); }

Vec3d size_of(Vec3 v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// Extinction, or what is scattered if that is more, where all densities are 1.
Vec3d strength_of(const scene::Medium& m) {
    return size_of(m.absorption) + size_of(m.scattering) * std::max(std::abs(static_cast<double>(m.extinction)), 1.0);
}

}  // namespace

MediaBound::MediaBound(std::span<const scene::Medium> media, std::span<const scene::Texture> textures) {
    Vec3d sum;
    for (const scene::Medium& medium : media) {
        Part& part = parts_.emplace_back(Part{&medium, {}, {}});
        for (const auto& density : medium.densities) part.densities.emplace_back(*density, textures);
        part.most = product_over(part, kEverywhere);
        sum += strength_of(medium) * part.most;
    }
    // More than the kernel's sums may be off.
    most_ = largest(sum) * (1 + 1e-5);
}

Vec3d MediaBound::product_over(const Part& part, const RangeBox& box) {
    Vec3d product{1, 1, 1};
    for (const PigmentRange& density : part.densities) {
        const ColorRange colors = density.over(box);
        product = product * Vec3d{colors[0].most(), colors[1].most(), colors[2].most()};
    }
    return product;
}

double MediaBound::share_over(const RangeBox& box) const {
    Vec3d sum;
    double shining = 0;
    for (const Part& part : parts_) {
        const Vec3d product = product_over(part, box);
        sum += strength_of(*part.medium) * product;
        if (largest(size_of(part.medium->emission) * product) > 0)
            shining = std::max(shining, largest(product) / largest(part.most));
    }
    const double share = most_ > 0 ? largest(sum) * (1 + 2e-5) / most_ : 0;
    return std::min(std::max(share, shining), 1.0);
}

bool MediaBound::varies() const {
    return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return !part.densities.empty(); });
}

bool MediaBound::shines() const {
    return std::any_of(parts_.begin(), parts_.end(),
                       [](const Part& part) { return largest(size_of(part.medium->emission)) > 0; });
}

int MediaBound::cost() const {
    int cost = 0;
    for (const Part& part : parts_)
        for (const PigmentRange& density : part.densities) cost += density.cost();
    return cost;
}

namespace {

/// More words than this all grids together don't take, about.
constexpr std::size_t kMostCells = 48 * 48 * 48;
/// Where the mean share of the whole bound is more, a grid isn't worth its while.
constexpr double kWorthless = 0.8;
/// Where paths walk on along a grid, they may be this share of a cell beyond its sides; rounding comes on top.
constexpr double kMargin = 1.0 / 32;

struct Container {
    Bounds3 world;
    bool known = true;  ///< It is at rest, and has an end.
};

/// What holds each list of media, by its place in `code`.
std::map<std::uint32_t, Container> containers_of(const RenderScene& scene) {
    std::map<std::uint32_t, Container> out;
    const kernel::Geometry* geometry = nullptr;
    const auto add = [&](std::uint32_t material, const Bounds3& bounds) {
        const kernel::Material& m = scene.materials[material];
        if ((m.flags & kernel::MATERIAL_PATTERNED) == 0) return;
        const std::uint32_t medium = scene.patterned[m.patterned].medium;
        if (medium == kernel::NONE || medium == kernel::MEDIUM_SOLID) return;
        Container& container = out[medium];
        container.world.include(bounds);
        container.known = container.known && geometry->instance == kernel::NONE;
    };
    const auto host = [](const kernel::vec3& v) { return Vec3{v.x, v.y, v.z}; };
    const Bounds3 endless{{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    for (const kernel::Geometry& g : scene.geometries) {
        geometry = &g;
        for (std::uint32_t i = g.first_primitive; i < g.first_primitive + g.primitive_count; ++i) {
            if (g.kind == kernel::GEOMETRY_TRIANGLES) {
                const kernel::Triangle& t = scene.triangles[i];
                Bounds3 bounds;
                for (const std::uint32_t p : {t.p0, t.p1, t.p2}) bounds.include(host(scene.positions[p]));
                add(t.material, bounds);
            } else if (g.kind == kernel::GEOMETRY_SPHERE) {
                const kernel::Sphere& s = scene.spheres[i];
                const Vec3 r{s.radius, s.radius, s.radius};
                add(s.material, {host(s.center) - r, host(s.center) + r});
            } else if (g.kind == kernel::GEOMETRY_BOX) {
                add(scene.boxes[i].material, {host(scene.boxes[i].lower), host(scene.boxes[i].upper)});
            } else if (g.kind == kernel::GEOMETRY_PLANE) {
                add(scene.planes[i].material, endless);
            }
        }
    }
    for (const PlacedSolid& solid : scene.solids) {
        geometry = &scene.geometries[solid.geometry];
        for (const std::uint32_t material : solid.solid->materials()) add(material, solid.bounds);
    }
    return out;
}

/// A grid over a box of the media's own space.
struct Grid {
    RangeBox box;
    std::array<std::size_t, 3> count{};
    Vec3d rounding;  ///< How far the kernel's points may be off.

    [[nodiscard]] double cell(std::size_t axis) const {
        return (box[axis].upper - box[axis].lower) / static_cast<double>(count[axis]);
    }
    [[nodiscard]] std::size_t size() const { return count[0] * count[1] * count[2]; }
    /// From one cell's lower corner to another one's, and what is so near that paths may take it for a part.
    [[nodiscard]] RangeBox part(const std::array<std::size_t, 3>& first, const std::array<std::size_t, 3>& end) const {
        RangeBox out;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double margin = kMargin * cell(axis) + rounding[axis];
            out[axis] = {box[axis].lower + cell(axis) * static_cast<double>(first[axis]) - margin,
                         box[axis].lower + cell(axis) * static_cast<double>(end[axis]) + margin};
        }
        return out;
    }
};

/// Of a box, what media may be in, and a little more: so that there is nothing outside of it.
RangeBox occupied(const RangeBox& box, const MediaBound& bound) {
    constexpr int kHalvings = 24;
    RangeBox cut = box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool from_below : {true, false}) {
            double empty = from_below ? box[axis].lower : box[axis].upper;
            double tried = from_below ? box[axis].upper : box[axis].lower;
            for (int i = 0; i < kHalvings; ++i) {
                const double middle = 0.5 * (empty + tried);
                RangeBox part = box;
                (from_below ? part[axis].upper : part[axis].lower) = middle;
                (bound.share_over(part) == 0 ? empty : tried) = middle;
            }
            (from_below ? cut[axis].lower : cut[axis].upper) = empty;
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double more = 2 * kMargin * (cut[axis].upper - cut[axis].lower);
        cut[axis] = {std::max(cut[axis].lower - more, box[axis].lower),
                     std::min(cut[axis].upper + more, box[axis].upper)};
    }
    return cut;
}

/// The grid over a container, or over what of it holds media: as fine as brings something. A cell in which the bound of
/// the whole makes paths look but once at a density that is quickly computed isn't worth a step; at one of noise it is
/// worth many.
Grid grid_over(const Bounds3& world, const Affine3d& medium_from_world, const MediaBound& bound, std::size_t most) {
    Grid grid;
    Bounds3d box;
    for (unsigned corner = 0; corner < 8; ++corner)
        box.include(transform_point(medium_from_world, to_double({(corner & 1U) ? world.upper.x : world.lower.x,
                                                                  (corner & 2U) ? world.upper.y : world.lower.y,
                                                                  (corner & 4U) ? world.upper.z : world.lower.z})));
    const Vec3d far{std::max(std::abs(world.lower.x), std::abs(world.upper.x)),
                    std::max(std::abs(world.lower.y), std::abs(world.upper.y)),
                    std::max(std::abs(world.lower.z), std::abs(world.upper.z))};
    const double per_world = largest(box.upper - box.lower) / largest(to_double(world.extent()));
    grid.box = occupied(
        {Range{box.lower.x, box.upper.x}, Range{box.lower.y, box.upper.y}, Range{box.lower.z, box.upper.z}}, bound);
    Vec3d extent;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Affine3d& m = medium_from_world;
        constexpr double kRounding = 1e-6;
        grid.rounding[axis] = kRounding * (std::abs(m.x[axis]) * far.x + std::abs(m.y[axis]) * far.y +
                                           std::abs(m.z[axis]) * far.z + std::abs(m.t[axis]));
        extent[axis] = grid.box[axis].upper - grid.box[axis].lower;
        // In a box that is thin beside its distance, paths couldn't tell where they are.
        constexpr double kLeastSteps = 256;
        if (!(extent[axis] > kLeastSteps * grid.rounding[axis])) return {};
    }
    constexpr double kLeastLooks = 4, kMostAlong = 128;
    const double depth = bound.most() * largest(extent) / per_world;
    const double looks = std::max(depth, bound.shines() ? kLeastLooks : 0) * bound.cost();
    double cell = largest(extent) / std::min(looks, kMostAlong);
    for (;; cell *= 1.05) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            grid.count[axis] = static_cast<std::size_t>(std::max(std::ceil(extent[axis] / cell), 1.0));
        if (grid.size() <= most) break;
    }
    constexpr std::size_t kFewCells = 16;
    return grid.size() < kFewCells ? Grid{} : grid;
}

/// Fills a grid's cells with shares of the whole bound, halving it as long as something is there.
class GridFiller {
public:
    GridFiller(const Grid& grid, const MediaBound& bound) : grid_(grid), bound_(bound), shares_(grid.size()) {}

    std::vector<float> fill() {
        const auto blocks = [&](std::size_t axis) { return (grid_.count[axis] + kBlock - 1) / kBlock; };
        const std::size_t count = blocks(0) * blocks(1) * blocks(2);
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            fill_part({i % blocks(0) * kBlock, i / blocks(0) % blocks(1) * kBlock, i / blocks(0) / blocks(1) * kBlock},
                      kBlock);
        });
        return std::move(shares_);
    }

private:
    static constexpr std::size_t kBlock = 8;
    using Place = std::array<std::size_t, 3>;

    void fill_part(const Place& first, std::size_t size) {
        Place end;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (first[axis] >= grid_.count[axis]) return;
            end[axis] = std::min(first[axis] + size, grid_.count[axis]);
        }
        const double share = bound_.share_over(grid_.part(first, end));
        if (share == 0 || size == 1) return set(first, end, share);
        const std::size_t half = size / 2;
        for (std::size_t i = 0; i < 8; ++i)
            fill_part({first[0] + (i & 1U) * half, first[1] + (i >> 1U & 1U) * half, first[2] + (i >> 2U) * half},
                      half);
    }
    void set(const Place& first, const Place& end, double share) {
        const float rounded = share == 0 ? 0 : std::min(static_cast<float>(share) * (1 + 1e-6F), 1.0F);
        for (std::size_t z = first[2]; z < end[2]; ++z)
            for (std::size_t y = first[1]; y < end[1]; ++y)
                for (std::size_t x = first[0]; x < end[0]; ++x)
                    shares_[(z * grid_.count[1] + y) * grid_.count[0] + x] = rounded;
    }

    const Grid& grid_;
    const MediaBound& bound_;
    std::vector<float> shares_;
};

/// The most in all that lies outside of a grid: in six halves of space.
double share_outside(const Grid& grid, const MediaBound& bound) {
    double share = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        RangeBox below = kEverywhere, above = kEverywhere;
        const double margin = kMargin * grid.cell(axis) + grid.rounding[axis];
        below[axis].upper = grid.box[axis].lower + margin;
        above[axis].lower = grid.box[axis].upper - margin;
        share = std::max({share, bound.share_over(below), bound.share_over(above)});
    }
    return share;
}

void add_grid(const MediaList& list, const Bounds3& world, const MediaBound& bound, std::size_t most,
              RenderScene& out) {
    const Grid grid = grid_over(world, list.medium_from_world, bound, most);
    if (grid.size() == 0) return;
    const std::vector<float> shares = GridFiller(grid, bound).fill();
    double mean = 0;
    for (const float share : shares) mean += static_cast<double>(share) / static_cast<double>(shares.size());
    if (mean > kWorthless) return;
    out.code[list.at + kernel::MEDIA_LIST_GRID] = static_cast<std::uint32_t>(out.code.size());
    const auto put = [&](double v) { out.code.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(v))); };
    const Affine3d& m = list.medium_from_world;
    const Vec3d scale{1 / grid.cell(0), 1 / grid.cell(1), 1 / grid.cell(2)};
    const Vec3d corner{grid.box[0].lower, grid.box[1].lower, grid.box[2].lower};
    for (const Vec3d& column : {m.x * scale, m.y * scale, m.z * scale, (m.t - corner) * scale})
        put(column.x), put(column.y), put(column.z);
    for (const std::size_t count : grid.count) out.code.push_back(static_cast<std::uint32_t>(count));
    put(share_outside(grid, bound) * (1 + 1e-6));
    for (const float share : shares) out.code.push_back(std::bit_cast<std::uint32_t>(share));
}

}  // namespace

void add_majorant_grids(std::span<const MediaList> lists, std::span<const scene::Texture> textures, RenderScene& out) {
    if (lists.empty()) return;
    std::map<std::uint32_t, Container> containers = containers_of(out);
    // The air's is as large as the scene.
    if (out.atmosphere != kernel::NONE) containers[out.atmosphere] = {out.bounds, !out.bounds.empty()};
    const std::size_t most = std::max<std::size_t>(kMostCells / lists.size(), 512);
    for (const MediaList& list : lists) {
        const auto held = containers.find(list.at);
        if (held == containers.end() || !held->second.known) continue;
        const Bounds3& world = held->second.world;
        if (!is_finite(to_double(world.lower)) || !is_finite(to_double(world.upper))) continue;
        const MediaBound bound(list.media, textures);
        if (bound.varies()) add_grid(list, world, bound, most, out);
    }
}

}  // namespace sundog
