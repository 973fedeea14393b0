// SPDX-License-Identifier: Apache-2.0
// Compiled twice per width (SUNDOG_KERNEL_LANES), for all scenes and for plain ones (SUNDOG_KERNEL_FEATURES), under the
// name SUNDOG_TILE_KERNEL: primary rays of a block of pixels, Whitted's integrator over Embree, film.
#include "device/cpu/tile_kernel.h"

#include <algorithm>

#include "device/cpu/packet_traversal.h"
#include "device/cpu/photon_batch.h"
#include "device/cpu/ray_batch.h"
// After the traversal, which these ask.
#include "kernel/integrators/whitted.h"

#include "device/cpu/block.h"
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

/// A packet of rays in memory: picking lanes out of registers one at a time is slow.
struct StoredRays {
    alignas(64) std::array<float, kLanes> origin_x{}, origin_y{}, origin_z{}, x{}, y{}, z{}, t_max{};
};

/// Few pictures have a lens: its code stays out of the way of the others'.
[[gnu::noinline]] void look_through_lens(const SceneView& view, const BlockPixels& pixels, std::uint32_t sample,
                                         Ray& ray) {
    const word pixel =
        hash_word(hash_word(word(std::bit_cast<vuint>(pixels.x))) + word(std::bit_cast<vuint>(pixels.y)));
    ray = lens_ray(view.frame, ray, sample_pair(PathSample{pixel, word(sample)}, word(1U)));
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
            shown = host_rays(*camera, view.frame, pixels, at, word(sample), k, going, ray);
        } else {
            ray = camera_ray(view.frame, x, y);
            shown = mask_and(in_image, ray.t_max > ray.t_min);
            if (view.frame.lens_radius > 0) look_through_lens(view, pixels, sample, ray);
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

EyeHits hits_of_block(const RasterisedTile& tile, int x0, int y0) {
    const int block = (y0 - tile.y0) / kBlockHeight * (tile.side / kBlockWidth) + (x0 - tile.x0) / kBlockWidth;
    return {tile.triangles + static_cast<std::ptrdiff_t>(block) * kLanes, tile.geometries};
}

}  // namespace

TileRays SUNDOG_TILE_KERNEL(const TileWork& work) {
    SceneView view = view_of(work.scene, work.frame, work.traversal);
    view.indirect = work.indirect;
    view.photons = work.photons;
    view.light_cells = work.light_cells;
    return render_blocks(work, view.frame, [&](int x, int y, mask in_image) {
        EyeHits given{};
        if (work.rasterised != nullptr) {
            given = hits_of_block(*work.rasterised, x, y);
            view.eye_hits = &given;
        }
        return trace_block(view, x, y, in_image, work);
    });
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
