// SPDX-License-Identifier: Apache-2.0
// One invocation traces the paths of one pixel of the dispatch's rectangle, one after the other.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "device/vulkan/shaders/scene.glsl"
#include "device/vulkan/shaders/trace.glsl"
#include "kernel/integrators/occlusion.h"
#include "kernel/integrators/path_samples.h"
#include "kernel/integrators/path_tracing.h"
#include "kernel/cameras/lens.h"
#include "kernel/cameras/projections.h"

#include "device/vulkan/shaders/film.glsl"

/// The ray of a path that begins at a place of its pixel.
Ray begun_ray(PathSample path, vec2 place) {
    Ray ray = camera_ray(frame, place.x, place.y);
    if (frame.lens_radius > 0.0f) ray = lens_ray(frame, ray, sample_pair(path, 1u));
    return ray;
}

void main() {
    RayCounts counts = RayCounts(0u, 0u);
    if (gl_GlobalInvocationID.x < work.width && gl_GlobalInvocationID.y < work.height) {
        uint pixel = gl_GlobalInvocationID.y * work.width + gl_GlobalInvocationID.x;
        uvec2 corner = uvec2(work.x0 + gl_GlobalInvocationID.x, work.y0 + gl_GlobalInvocationID.y);
        vec2 per_pixel = 1.0f / vec2(frame.width, frame.height);
        vec4 sum = work.first_sample == 0u ? vec4(0.0f) : radiance_sums[pixel];
        uint hash = pixel_hash(corner.x, corner.y);
        uint bits = block_bits(frame.sampling);
        uint end = work.first_sample + work.sample_count;
        uint next = work.first_sample;
        vec3 radiance = vec3(0.0f);
        float weight = 0.0f;
        bool wants_aovs = frame_aovs != 0u && next == 0u;
        FirstHit first = nothing_met();
        TracedPath path;
        path.alive = false;
        // One loop over all surfaces of all paths: invocations of a subgroup whose paths end early begin their next
        // ones while others are still under way.
        while (true) {
            if (!path.alive) {
                sum += vec4(path_light(radiance) * weight, weight);
                if (next == end) break;
                PathSample sampled = path_sample(hash, next, bits);
                PixelSample at = path_place(sampled);
                Ray ray = begun_ray(sampled, (vec2(corner) + vec2(at.x, at.y)) * per_pixel);
                path = begun_path(ray, sampled, ray.t_max > ray.t_min);
                radiance = vec3(0.0f);
                weight = at.weight;
                ++next;
            }
            if (path.alive) {
                if (frame_integrator == INTEGRATOR_OCCLUSION)
                    extend_occlusion(wants_aovs, path, radiance, counts, first);
                else extend_path(wants_aovs, path, radiance, counts, first);
            }
            if (wants_aovs) write_aovs(pixel, first);
            wants_aovs = false;
        }
        radiance_sums[pixel] = sum;
        if ((frame_aovs & AOV_COST) != 0u) pixel_aovs[pixel].cost = float(counts.rays);
    }
    count_all(counts);
}
