// SPDX-License-Identifier: Apache-2.0
// What a dispatch computes and where that goes: sums of radiance, auxiliary values, ray counts.
#extension GL_KHR_shader_subgroup_arithmetic : require

layout(local_size_x = GROUP_WIDTH, local_size_y = GROUP_HEIGHT) in;

layout(scalar, set = 0, binding = BINDING_RADIANCE) restrict buffer radiance_buffer {
    uint counters[COUNTERS];
    vec4 radiance_sums[];
};
layout(scalar, set = 0, binding = BINDING_AOVS) restrict buffer aovs_buffer { PixelAovs pixel_aovs[]; };
layout(scalar, push_constant) uniform dispatch_block { Dispatch work; };

void count(uint place, uint rays) {
    uint sum = subgroupAdd(rays);
    if (subgroupElect()) {
        uint before = atomicAdd(counters[place], sum);
        if (before > 0xffffffffu - sum) atomicAdd(counters[place + 1u], 1u);
    }
}

/// Counts what was traced. Mesa's llvmpipe ends each loop at the end of its first round once an invocation has gone
/// through 65,535 rounds in all its loops together (lp_bld_limits.h), and pictures are wrong: a loop shows whether it
/// has come to that.
void count_all(RayCounts counts) {
    count(COUNTER_RAYS, counts.rays);
    count(COUNTER_SHADOW_RAYS, counts.shadow_rays);
    uint rounds = 0u;
    for (uint i = 0u; i < work.probe_rounds; ++i) rounds += i;
    count(COUNTER_CUT_LOOPS, rounds == 1u ? 0u : 1u);
}

void write_aovs(uint pixel, FirstHit first) {
    float depth = first.geometry == NONE ? uintBitsToFloat(0x7f800000u) : first.t;
    pixel_aovs[pixel] =
        PixelAovs(depth, first.normal, first.albedo, first.geometry, first.primitive, first.material, 0.0f);
}
