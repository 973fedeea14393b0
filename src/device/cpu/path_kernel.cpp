// SPDX-License-Identifier: Apache-2.0
// Compiled twice per width (SUNDOG_KERNEL_LANES), for all scenes and for plain ones (SUNDOG_KERNEL_FEATURES), under the
// name SUNDOG_PATH_KERNEL: paths of a block of pixels over Embree.
#include "device/cpu/packet_traversal.h"
#include "device/cpu/tile_kernel.h"
// After the traversal, which this asks.
#include "kernel/integrators/occlusion.h"
#include "kernel/integrators/path_samples.h"
#include "kernel/integrators/path_tracing.h"

#include "device/cpu/block.h"

KERNEL_BEGIN

/// A block's paths. Each lane traces its pixel's, one after the other, and begins the next where one has ended: so
/// lanes are busy until the last paths, whatever the lengths.
inline BlockResult trace_paths(const SceneView& view, int x0, int y0, mask in_image, const TileWork& work) {
    const BlockPixels pixels(x0, y0);
    BlockResult block;
    if (work.first_sample > 0) add_sums_so_far(x0, y0, work, block);
    block.first = nothing_met();
    const CameraRays* const camera = work.frame.camera_rays.get();
    const word pixel = pixel_hash(view, word(std::bit_cast<vuint>(pixels.x)), word(std::bit_cast<vuint>(pixels.y)));
    const uint bits = block_bits(view.frame.sampling);
    const word end(work.first_sample + work.sample_count);
    word next(work.first_sample);
    real3 radiance(real(0.0F));
    PixelSample at{real(0.0F), real(0.0F), real(0.0F)};
    TracedPath path = begun_path(view, Ray{}, PathSample{pixel, next}, mask(false));
    bool together = true;
    FirstHit unseen = nothing_met();
    while (true) {
        const mask begins = mask_and(in_image, mask_and(mask_not(path.alive), next < end));
        if (any_lane(begins)) {
            const PathSample sample = path_sample(pixel, next, bits);
            const PixelSample here = path_place(view, sample);
            const real x = (real(__builtin_convertvector(pixels.x, vfloat)) + here.x) *
                           (1.0F / static_cast<float>(view.frame.width));
            const real y = (real(__builtin_convertvector(pixels.y, vfloat)) + here.y) *
                           (1.0F / static_cast<float>(view.frame.height));
            Ray ray;
            mask shown = begins;
            if (camera != nullptr) {
                shown = host_rays(*camera, view.frame, pixels, here, next, 0, begins, ray);
            } else {
                ray = camera_ray(view.frame, x, y);
                shown = mask_and(begins, ray.t_max > ray.t_min);
                if (view.frame.lens_radius > 0) ray = lens_ray(view.frame, ray, sample_pair(sample, word(1U)));
            }
            if (work.frame.camera_normal != NONE) bend_rays(view, work.frame.camera_normal, x, y, ray);
            // What the last path of the lane brought.
            block.radiance = select(begins, block.radiance + path_light(view, radiance) * at.weight, block.radiance);
            block.weights = select(begins, block.weights + at.weight, block.weights);
            radiance = select(begins, real3(real(0.0F)), radiance);
            at.weight = select(begins, here.weight, at.weight);
            take_path(begins, begun_path(view, ray, sample, shown), path);
            next = next + select(begins, word(1U), word(0U));
        }
        if (!any_lane(path.alive)) {
            if (any_lane(mask_and(in_image, next < end))) continue;
            break;
        }
        FirstHit& first = work.first_sample == 0 && together ? block.first : unseen;
        // A host's rays may go anywhere, and of packets that aren't what they are said to be, Embree 3.13 loses rays.
        const bool coherent = together && camera == nullptr;
        if (view.frame.integrator == INTEGRATOR_OCCLUSION)
            extend_occlusion(view, coherent, path, radiance, block.counts, first);
        else extend_path(view, coherent, path, radiance, block.counts, first);
        together = false;
    }
    block.radiance = block.radiance + path_light(view, radiance) * at.weight;
    block.weights = block.weights + at.weight;
    return block;
}

KERNEL_END

namespace sundog::cpu {

TileRays SUNDOG_PATH_KERNEL(const TileWork& work) {
    using namespace kernel;
    const SceneView view = view_of(work.scene, work.frame, work.traversal);
    return render_blocks(work, view.frame,
                         [&](int x, int y, mask in_image) { return trace_paths(view, x, y, in_image, work); });
}

}  // namespace sundog::cpu
