// SPDX-License-Identifier: Apache-2.0
// Compiled twice per width (SUNDOG_KERNEL_LANES), for all scenes and for plain ones (SUNDOG_KERNEL_FEATURES), under the
// name SUNDOG_TILE_KERNEL: primary rays of a block of pixels, Whitted's integrator over Embree, film.
#include "device/cpu/tile_kernel.h"

#include <algorithm>

#include "device/cpu/packet_traversal.h"
#include "device/cpu/photon_batch.h"
#include "device/cpu/ray_batch.h"

KERNEL_BEGIN

#if SUNDOG_KERNEL_LANES == 16
inline constexpr int kBlockWidth = 4, kBlockHeight = 4;
#elif SUNDOG_KERNEL_LANES == 8
inline constexpr int kBlockWidth = 4, kBlockHeight = 2;
#else
inline constexpr int kBlockWidth = 2, kBlockHeight = 2;
#endif

KERNEL_END

#include "kernel/cameras/pixel_samples.h"
#include "kernel/cameras/projections.h"
#include "kernel/integrators/whitted.h"
#ifdef SUNDOG_PHOTON_KERNEL
#include "kernel/integrators/photons.h"
#endif

namespace sundog::cpu {
namespace {

using namespace kernel;

/// One copy of the integrator for pixels and for rays that gather light.
[[gnu::noinline]] real3 radiance_along(const SceneView& scene, const Ray& ray, mask alive, RayCounts& counts,
                                       FirstHit& first) {
    return whitted_radiance(scene, ray, alive, counts, first);
}

/// Pixel coordinates of a block's lanes, row by row.
struct BlockPixels {
    vint x{}, y{};
    BlockPixels(int x0, int y0) {
        for (int lane = 0; lane < kLanes; ++lane) {
            x[lane] = x0 + lane % kBlockWidth;
            y[lane] = y0 + lane / kBlockWidth;
        }
    }
};

struct BlockResult {
    real3 radiance{real(0.0F)};  ///< Sums of samples times their weights, and of these.
    real weights{0.0F};
    RayCounts counts{word(0U), word(0U)};
    FirstHit first;
};

/// A block's sums in memory, lane by lane: picking lanes out of registers one at a time is slow.
struct StoredLanes {
    alignas(64) std::array<float, kLanes> r{}, g{}, b{}, weights{};
};

/// A packet of rays in memory, likewise.
struct StoredRays {
    alignas(64) std::array<float, kLanes> origin_x{}, origin_y{}, origin_z{}, x{}, y{}, z{}, t_max{};
};

/// Calls visit(lane, place in the film) for those pixels of the block at (x0, y0) that the work may write.
template <class Visit>
[[gnu::always_inline]] inline void for_each_pixel(int x0, int y0, const TileWork& work, const Visit& visit) {
    const int first_column = std::max(work.region.x0 - x0, 0);
    const int columns = std::min(work.region.x1 - x0, kBlockWidth);
    const int first_row = std::max(work.region.y0 - y0, 0);
    const int rows = std::min(work.region.y1 - y0, kBlockHeight);
    for (int row = first_row; row < rows; ++row) {
        const std::size_t first = work.film.index(x0 + first_column, y0 + row);
        for (int column = first_column; column < columns; ++column) {
            const std::size_t i = first + static_cast<std::size_t>(column - first_column);
            if (work.wanted.empty() || work.wanted[i] != 0)
                visit(static_cast<std::size_t>(row * kBlockWidth + column), i);
        }
    }
}

/// All bits set in the lanes whose pixels are wanted.
vuint wanted_lanes(int x0, int y0, const TileWork& work) {
    vuint lanes{};
    for_each_pixel(x0, y0, work, [&](std::size_t lane, std::size_t) { lanes[lane] = ~0U; });
    return lanes;
}

/// What the film holds of a block so far. New samples are added to it one by one, as if there had been no break, so
/// that a picture's bits don't depend on how its samples are split into works.
void add_sums_so_far(int x0, int y0, const TileWork& work, BlockResult& block) {
    StoredLanes stored;
    for_each_pixel(x0, y0, work, [&](std::size_t lane, std::size_t i) {
        const std::array<float, 4>& sum = work.film.radiance[i];
        stored.r[lane] = sum[0], stored.g[lane] = sum[1], stored.b[lane] = sum[2], stored.weights[lane] = sum[3];
    });
    block.radiance =
        real3(real(lanes_of(stored.r.data())), real(lanes_of(stored.g.data())), real(lanes_of(stored.b.data())));
    block.weights = real(lanes_of(stored.weights.data()));
}

/// Bends rays by the camera's normals, which lie in the picture: x and y from -0.5 to 0.5.
[[gnu::noinline]] void bend_rays(const SceneView& view, std::uint32_t normals, real x, real y, Ray& ray) {
    PatternPoint at = free_point(real3(x - 0.5F, 0.5F - y, real(0.0F)));
    at.normal = ray.direction;
    ray.direction = perturbed_normal(view, normals, at, vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1));
}

/// The rays of CameraRays for the lanes of `asked`, and in which of them there is one.
mask host_rays(const CameraRays& camera, const FrameParams& frame, const BlockPixels& pixels, const PixelSample& at,
               CameraRays::Place place, mask asked, Ray& ray) {
    const vint lanes = lane_ints(asked);
    vuint made{};
    ray.origin = real3(real(0.0F));
    ray.direction = real3(real(0.0F), real(0.0F), real(1.0F));
    ray.t_min = real(0.0F);
    ray.t_max = real(0.0F);
    for (int lane = 0; lane < kLanes; ++lane) {
        if (lanes[lane] == 0) continue;
        place.x = static_cast<std::uint32_t>(pixels.x[lane]), place.y = static_cast<std::uint32_t>(pixels.y[lane]);
        place.dx = at.x.v[lane], place.dy = at.y.v[lane];
        const std::optional<CameraRays::Ray> one = camera.ray(frame, place);
        if (!one) continue;
        made[lane] = ~0U;
        ray.origin.x.v[lane] = one->origin.x;
        ray.origin.y.v[lane] = one->origin.y;
        ray.origin.z.v[lane] = one->origin.z;
        ray.direction.x.v[lane] = one->direction.x;
        ray.direction.y.v[lane] = one->direction.y;
        ray.direction.z.v[lane] = one->direction.z;
        ray.t_max.v[lane] = one->reach;
    }
    return word(made) != word(0U);
}

/// One sample of a block's pixels: one ray of the kernel's camera, or the mean of as many of CameraRays as it takes.
[[gnu::always_inline]] inline real3 sample_radiance(const SceneView& view, const Frame& frame,
                                                    const BlockPixels& pixels, const PixelSample& at,
                                                    std::uint32_t sample, mask in_image, RayCounts& counts,
                                                    FirstHit& first) {
    const CameraRays* const camera = frame.camera_rays.get();
    const std::uint32_t most = camera != nullptr ? camera->most_rays() : 1;
    const std::uint32_t least = camera != nullptr ? std::max(camera->least_rays(), 2U) : 1;
    const real x =
        (real(__builtin_convertvector(pixels.x, vfloat)) + at.x) * (1.0F / static_cast<float>(view.frame.width));
    const real y =
        (real(__builtin_convertvector(pixels.y, vfloat)) + at.y) * (1.0F / static_cast<float>(view.frame.height));
    const real3 black(real(0.0F));
    real3 sum = black;
    real3 squares = black;
    real count(0.0F);
    mask going = in_image;
    for (std::uint32_t k = 0; k < most; ++k) {
        Ray ray;
        mask shown;
        if (camera != nullptr) {
            shown = host_rays(*camera, view.frame, pixels, at, {.sample = sample, .ray = k}, going, ray);
        } else {
            ray = camera_ray(view.frame, x, y);
            shown = mask_and(in_image, ray.t_max > ray.t_min);
        }
        if (frame.camera_normal != NONE) bend_rays(view, frame.camera_normal, x, y, ray);
        FirstHit hit;
        const real3 radiance = radiance_along(view, ray, shown, counts, hit);
        if (k == 0) first = hit;
        if (camera == nullptr) return radiance;
        sum = select(shown, sum + radiance, sum);
        squares = select(shown, squares + radiance * radiance, squares);
        count = select(shown, count + 1.0F, count);
        const std::uint32_t n = k + 1;
        if (n < least || n == most) continue;
        const auto rays = static_cast<float>(n);
        const real3 variance = (squares - sum * sum * real(1.0F / rays)) * real(1.0F / (rays - 1.0F));
        const real enough(camera->enough_variance(n));
        going = mask_and(going, max(max(variance.x, variance.y), variance.z) > enough);
        if (!any_lane(going)) break;
    }
    return sum * (1.0F / max(count, real(1.0F)));
}

BlockResult trace_block(const SceneView& view, int x0, int y0, mask in_image, const TileWork& work) {
    const BlockPixels pixels(x0, y0);
    BlockResult block;
    if (work.first_sample > 0) add_sums_so_far(x0, y0, work, block);
    const word x(std::bit_cast<vuint>(pixels.x)), y(std::bit_cast<vuint>(pixels.y));
    for (std::uint32_t i = 0; i < work.sample_count; ++i) {
        const std::uint32_t sample = work.first_sample + i;
        FirstHit first;
        const PixelSample at = pixel_sample(view.frame.sampling, x, y, sample);
        block.radiance =
            block.radiance +
            sample_radiance(view, work.frame, pixels, at, sample, in_image, block.counts, first) * at.weight;
        block.weights = block.weights + at.weight;
        if (i == 0) block.first = first;
    }
    return block;
}

/// AOVs of one pixel: the first sample's, and the sum of costs.
void add_aovs(Film& film, std::size_t i, const BlockResult& block, int lane, bool fresh) {
    if (film.aovs & AOV_COST)
        film.cost[i] = (fresh ? 0.0F : film.cost[i]) + static_cast<float>(block.counts.rays.v[lane]);
    if (!fresh) return;
    const bool missed = block.first.geometry.v[lane] == NONE;
    const auto vec = [&](const real3& v) { return Vec3{v.x.v[lane], v.y.v[lane], v.z.v[lane]}; };
    if (film.aovs & AOV_DEPTH) film.depth[i] = missed ? INFINITY : block.first.t.v[lane];
    if (film.aovs & AOV_NORMAL) film.normal[i] = vec(block.first.normal);
    if (film.aovs & AOV_ALBEDO) film.albedo[i] = vec(block.first.albedo);
    if (film.aovs & AOV_OBJECT) {
        film.object[i] = block.first.geometry.v[lane];
        film.primitive[i] = block.first.primitive.v[lane];
        film.material[i] = block.first.material.v[lane];
    }
}

EyeHits hits_of_block(const RasterisedTile& tile, int x0, int y0) {
    const int block = (y0 - tile.y0) / kBlockHeight * (tile.side / kBlockWidth) + (x0 - tile.x0) / kBlockWidth;
    return {tile.triangles + static_cast<std::ptrdiff_t>(block) * kLanes, tile.geometries};
}

/// Puts a block's sums and AOVs into the film.
void store_block(int x0, int y0, const BlockResult& block, const TileWork& work) {
    Film& film = work.film;
    StoredLanes stored;
    lanes_of(stored.r.data()) = block.radiance.x.v;
    lanes_of(stored.g.data()) = block.radiance.y.v;
    lanes_of(stored.b.data()) = block.radiance.z.v;
    lanes_of(stored.weights.data()) = block.weights.v;
    const bool fresh = work.first_sample == 0;
    for_each_pixel(x0, y0, work, [&](std::size_t lane, std::size_t i) {
        film.radiance[i] = {stored.r[lane], stored.g[lane], stored.b[lane], stored.weights[lane]};
        if (film.aovs != 0) add_aovs(film, i, block, static_cast<int>(lane), fresh);
    });
}

}  // namespace

TileRays SUNDOG_TILE_KERNEL(const TileWork& work) {
    SceneView view = view_of(work.scene, work.frame, work.traversal);
    view.indirect = work.indirect;
    view.photons = work.photons;
    view.light_cells = work.light_cells;
    const vint width = vint{} + static_cast<int>(view.frame.width);
    const vint height = vint{} + static_cast<int>(view.frame.height);
    RayCounts counts{word(0U), word(0U)};
    // Blocks are aligned to the image, whatever the region: a lane's bits can depend on the lanes beside it (Embree may
    // trace a thin packet another way), so those must always be the same ones.
    for (int y = work.region.y0 / kBlockHeight * kBlockHeight; y < work.region.y1; y += kBlockHeight) {
        for (int x = work.region.x0 / kBlockWidth * kBlockWidth; x < work.region.x1; x += kBlockWidth) {
            const BlockPixels pixels(x, y);
            vuint inside = std::bit_cast<vuint>(pixels.x < width) & std::bit_cast<vuint>(pixels.y < height);
            if (!work.wanted.empty()) {
                const vuint wanted = wanted_lanes(x, y, work);
                inside &= wanted;
                if (sum_lanes(word(wanted)) == 0) continue;
            }
            EyeHits given{};
            if (work.rasterised != nullptr) {
                given = hits_of_block(*work.rasterised, x, y);
                view.eye_hits = &given;
            }
            const BlockResult block = trace_block(view, x, y, word(inside) != word(0U), work);
            counts.rays = counts.rays + block.counts.rays;
            counts.shadow_rays = counts.shadow_rays + block.counts.shadow_rays;
            store_block(x, y, block, work);
        }
    }
    return {sum_lanes(counts.rays), sum_lanes(counts.shadow_rays)};
}

#ifdef SUNDOG_RAY_KERNEL
BatchRays SUNDOG_RAY_KERNEL(const SceneView& scene, std::span<const BatchRay> rays, std::span<BatchAnswer> answers) {
    RayCounts counts{word(0U), word(0U)};
    constexpr auto kPacket = static_cast<std::size_t>(kLanes);
    for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
        const std::size_t size = std::min(kPacket, rays.size() - begin);
        StoredRays in;
        for (std::size_t lane = 0; lane < kPacket; ++lane) {
            const BatchRay& ray = rays[begin + std::min(lane, size - 1)];
            in.origin_x[lane] = ray.origin.x, in.origin_y[lane] = ray.origin.y, in.origin_z[lane] = ray.origin.z;
            in.x[lane] = ray.direction.x, in.y[lane] = ray.direction.y, in.z[lane] = ray.direction.z;
            in.t_max[lane] = lane < size ? ray.t_max : -1.0F;
        }
        Ray ray;
        ray.origin = real3(real(lanes_of(in.origin_x.data())), real(lanes_of(in.origin_y.data())),
                           real(lanes_of(in.origin_z.data())));
        ray.direction = real3(real(lanes_of(in.x.data())), real(lanes_of(in.y.data())), real(lanes_of(in.z.data())));
        ray.t_min = real(0.0F);
        ray.t_max = real(lanes_of(in.t_max.data()));
        FirstHit first;
        const real3 radiance = radiance_along(scene, ray, ray.t_max > ray.t_min, counts, first);
        StoredLanes out;
        alignas(64) std::array<float, kLanes> distance{};
        lanes_of(out.r.data()) = radiance.x.v;
        lanes_of(out.g.data()) = radiance.y.v;
        lanes_of(out.b.data()) = radiance.z.v;
        lanes_of(distance.data()) = first.t.v;
        for (std::size_t lane = 0; lane < size; ++lane)
            answers[begin + lane] = {{out.r[lane], out.g[lane], out.b[lane]}, distance[lane]};
    }
    return {sum_lanes(counts.rays), sum_lanes(counts.shadow_rays)};
}
#endif

#ifdef SUNDOG_PHOTON_KERNEL
namespace {

/// Appends what arrives to a harvest.
class HarvestSink final : public kernel::PhotonSink {
public:
    explicit HarvestSink(StoredPhotons& stored) : stored_(stored) {}
    void on_surface(const kernel::PhotonArrivals& arrivals) override { append(arrivals, stored_.surface); }
    void in_medium(const kernel::PhotonArrivals& arrivals) override { append(arrivals, stored_.media); }

private:
    static void append(const kernel::PhotonArrivals& a, std::vector<StoredPhoton>& out) {
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            if (a.stored[lane] != 0)
                out.push_back({{a.x[lane], a.y[lane], a.z[lane]},
                               {a.direction_x[lane], a.direction_y[lane], a.direction_z[lane]},
                               {a.normal_x[lane], a.normal_y[lane], a.normal_z[lane]},
                               {a.red[lane], a.green[lane], a.blue[lane]}});
    }
    StoredPhotons& stored_;
};

}  // namespace

void SUNDOG_PHOTON_KERNEL(const SceneView& scene, const PhotonShot& shot, std::span<const BatchPhoton> photons,
                          PhotonHarvest& harvest) {
    HarvestSink sink(harvest.stored);
    RayCounts counts{word(0U), word(0U)};
    constexpr auto kPacket = static_cast<std::size_t>(kLanes);
    for (std::size_t begin = 0; begin < photons.size(); begin += kPacket) {
        const std::size_t size = std::min(kPacket, photons.size() - begin);
        StoredRays in;
        StoredLanes power;
        for (std::size_t lane = 0; lane < kPacket; ++lane) {
            const BatchPhoton& p = photons[begin + std::min(lane, size - 1)];
            in.origin_x[lane] = p.origin.x, in.origin_y[lane] = p.origin.y, in.origin_z[lane] = p.origin.z;
            in.x[lane] = p.direction.x, in.y[lane] = p.direction.y, in.z[lane] = p.direction.z;
            in.t_max[lane] = lane < size ? 3.0e38F : -1.0F;
            power.r[lane] = p.power.x, power.g[lane] = p.power.y, power.b[lane] = p.power.z;
        }
        PhotonPaths paths;
        Ray& ray = paths.path.ray;
        ray.origin = real3(real(lanes_of(in.origin_x.data())), real(lanes_of(in.origin_y.data())),
                           real(lanes_of(in.origin_z.data())));
        ray.direction = real3(real(lanes_of(in.x.data())), real(lanes_of(in.y.data())), real(lanes_of(in.z.data())));
        ray.t_min = real(0.0F);
        ray.t_max = real(lanes_of(in.t_max.data()));
        paths.path.weight = real3(real(1.0F));
        paths.path.depth = word(0U);
        paths.path.kind = word(RAY_PHOTON);
        paths.path.alive = ray.t_max > ray.t_min;
        paths.path.insides = insides_of_eye(scene, paths.path.alive);
        paths.path.media = eye_insides(scene, paths.path.alive);
        paths.path.spectrum = real(-1.0F);
        paths.path.nesting = 0;
        paths.travelled = real(0.0F);
        const real3 start(real(lanes_of(power.r.data())), real(lanes_of(power.g.data())),
                          real(lanes_of(power.b.data())));
        mask met;
        follow_photons(scene, scene.lights[shot.light], shot, start, paths, true, sink, counts, met);
        const vint met_lanes = lane_ints(met);
        for (std::size_t lane = 0; lane < size; ++lane) harvest.met.push_back(met_lanes[lane] != 0 ? 1 : 0);
    }
    harvest.rays.rays += sum_lanes(counts.rays);
    harvest.rays.shadow_rays += sum_lanes(counts.shadow_rays);
}
#endif

}  // namespace sundog::cpu
