// SPDX-License-Identifier: Apache-2.0
// One invocation traces one pixel of the dispatch's rectangle, all of its samples one after the other.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "device/vulkan/shaders/scene.glsl"
#include "device/vulkan/shaders/trace.glsl"
#include "kernel/integrators/whitted.h"
#include "kernel/cameras/lens.h"
#include "kernel/cameras/pixel_samples.h"
#include "kernel/cameras/projections.h"

#include "device/vulkan/shaders/film.glsl"

void main() {
    RayCounts counts = RayCounts(0u, 0u);
    if (gl_GlobalInvocationID.x < work.width && gl_GlobalInvocationID.y < work.height) {
        uint pixel = gl_GlobalInvocationID.y * work.width + gl_GlobalInvocationID.x;
        vec2 corner = vec2(work.x0 + gl_GlobalInvocationID.x, work.y0 + gl_GlobalInvocationID.y);
        vec2 per_pixel = 1.0f / vec2(frame.width, frame.height);
        // Sums go on from where the samples before left them: they come out the same however samples are split.
        vec4 sum = work.first_sample == 0u ? vec4(0.0f) : radiance_sums[pixel];
        for (uint i = 0u; i < work.sample_count; ++i) {
            uint index = work.first_sample + i;
            PixelSample at = pixel_sample(frame.sampling, uint(corner.x), uint(corner.y), index);
            vec2 place = (corner + vec2(at.x, at.y)) * per_pixel;
            Ray ray = camera_ray(frame, place.x, place.y);
            if (frame.lens_radius > 0.0f) {
                uint pixel_hash = hash_word(hash_word(uint(corner.x)) + uint(corner.y));
                ray = lens_ray(frame, ray, sample_pair(PathSample(pixel_hash, index), 1u));
            }
            FirstHit first;
            sum += vec4(whitted_radiance(ray, ray.t_max > ray.t_min, counts, first) * at.weight, at.weight);
            if (frame_aovs != 0u && index == 0u) write_aovs(pixel, first);
        }
        radiance_sums[pixel] = sum;
        if ((frame_aovs & AOV_COST) != 0u) pixel_aovs[pixel].cost = float(counts.rays);
    }
    count_all(counts);
}
