// SPDX-License-Identifier: Apache-2.0
// Half of a packet's lanes in double precision, which fill a register as all of them do in single. Every operation
// rounds as its scalar one does. Only units of one width include it.
#pragma once

#include "kernel/compat/cpp.h"

namespace sundog::kernel {
inline namespace SUNDOG_KERNEL_SPACE {

inline constexpr int kWideLanes = SUNDOG_KERNEL_LANES / 2;
using vdouble = double __attribute__((vector_size(4 * SUNDOG_KERNEL_LANES)));
using vlong = std::int64_t __attribute__((vector_size(4 * SUNDOG_KERNEL_LANES)));
using vhalf = float __attribute__((vector_size(2 * SUNDOG_KERNEL_LANES)));

struct wide_mask {
#if SUNDOG_KERNEL_LANES == 16
    __mmask8 m;
#else
    vlong m;
#endif
    wide_mask() = default;
    FN explicit wide_mask(decltype(m) m_) : m(m_) {}
};

struct wide {
    vdouble v;
    wide() = default;
    FN wide(double s) : v(s - vdouble{}) {}  // NOLINT(google-explicit-constructor): a constant
    FN explicit wide(vdouble v_) : v(v_) {}
};

FN wide operator+(wide a, wide b) { return wide(a.v + b.v); }
FN wide operator-(wide a, wide b) { return wide(a.v - b.v); }
FN wide operator*(wide a, wide b) { return wide(a.v * b.v); }
FN wide operator/(wide a, wide b) { return wide(a.v / b.v); }
FN wide operator-(wide a) { return wide(-a.v); }

#if SUNDOG_KERNEL_LANES == 16
FN __m512d native(wide x) { return bits_as<__m512d>(x.v); }
FN wide from_native(__m512d x) { return wide(bits_as<vdouble>(x)); }
FN wide_mask operator<(wide a, wide b) { return wide_mask(_mm512_cmp_pd_mask(native(a), native(b), _CMP_LT_OQ)); }
FN wide_mask operator<=(wide a, wide b) { return wide_mask(_mm512_cmp_pd_mask(native(a), native(b), _CMP_LE_OQ)); }
FN wide_mask operator==(wide a, wide b) { return wide_mask(_mm512_cmp_pd_mask(native(a), native(b), _CMP_EQ_OQ)); }
FN wide_mask operator&(wide_mask a, wide_mask b) { return wide_mask(static_cast<__mmask8>(a.m & b.m)); }
FN wide_mask operator|(wide_mask a, wide_mask b) { return wide_mask(static_cast<__mmask8>(a.m | b.m)); }
FN wide_mask operator~(wide_mask a) { return wide_mask(static_cast<__mmask8>(~a.m)); }
FN unsigned bits_of(wide_mask m) { return m.m; }
FN wide_mask mask_of(unsigned bits) { return wide_mask(static_cast<__mmask8>(bits)); }
FN wide select(wide_mask m, wide a, wide b) { return from_native(_mm512_mask_blend_pd(m.m, native(b), native(a))); }
FN wide sqrt(wide x) { return from_native(_mm512_sqrt_pd(native(x))); }
FN wide abs(wide x) { return from_native(_mm512_abs_pd(native(x))); }
#else
FN wide_mask operator<(wide a, wide b) { return wide_mask(bits_as<vlong>(a.v < b.v)); }
FN wide_mask operator<=(wide a, wide b) { return wide_mask(bits_as<vlong>(a.v <= b.v)); }
FN wide_mask operator==(wide a, wide b) { return wide_mask(bits_as<vlong>(a.v == b.v)); }
FN wide_mask operator&(wide_mask a, wide_mask b) { return wide_mask(a.m & b.m); }
FN wide_mask operator|(wide_mask a, wide_mask b) { return wide_mask(a.m | b.m); }
FN wide_mask operator~(wide_mask a) { return wide_mask(~a.m); }
FN wide_mask mask_of(unsigned bits) {
    vlong m{};
    for (int lane = 0; lane < kWideLanes; ++lane) m[lane] = (bits >> lane & 1U) != 0 ? -1 : 0;
    return wide_mask(m);
}
FN wide abs(wide x) { return wide(bits_as<vdouble>(bits_as<vlong>(x.v) & 0x7fffffffffffffffLL)); }
#if SUNDOG_KERNEL_LANES == 8
FN unsigned bits_of(wide_mask m) { return static_cast<unsigned>(_mm256_movemask_pd(bits_as<__m256d>(m.m))); }
FN wide select(wide_mask m, wide a, wide b) {
    return wide(
        bits_as<vdouble>(_mm256_blendv_pd(bits_as<__m256d>(b.v), bits_as<__m256d>(a.v), bits_as<__m256d>(m.m))));
}
FN wide sqrt(wide x) { return wide(bits_as<vdouble>(_mm256_sqrt_pd(bits_as<__m256d>(x.v)))); }
#else
FN unsigned bits_of(wide_mask m) { return static_cast<unsigned>(_mm_movemask_pd(bits_as<__m128d>(m.m))); }
FN wide select(wide_mask m, wide a, wide b) {
    return wide(bits_as<vdouble>(_mm_blendv_pd(bits_as<__m128d>(b.v), bits_as<__m128d>(a.v), bits_as<__m128d>(m.m))));
}
FN wide sqrt(wide x) { return wide(bits_as<vdouble>(_mm_sqrt_pd(bits_as<__m128d>(x.v)))); }
#endif
#endif

FN wide_mask operator>(wide a, wide b) { return b < a; }
FN wide_mask operator>=(wide a, wide b) { return b <= a; }
FN bool any_lane(wide_mask m) { return bits_of(m) != 0; }
FN wide min(wide a, wide b) { return select(b < a, b, a); }
FN wide max(wide a, wide b) { return select(a < b, b, a); }

struct wide3 {
    wide x, y, z;
};
FN wide3 operator+(wide3 a, wide3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
FN wide3 operator-(wide3 a, wide3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
FN wide3 operator*(wide3 a, wide s) { return {a.x * s, a.y * s, a.z * s}; }
FN wide dot(wide3 a, wide3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Lanes half*kWideLanes and on of the member of a packet whose first lane this is.
FN wide half_of(const float& first, int half) {
    vhalf v;
    __builtin_memcpy(&v, &first + half * kWideLanes, sizeof v);
    return wide(__builtin_convertvector(v, vdouble));
}

/// The first lanes whose bits are set, one after the other, of such a member: as many as half of a packet has.
FN wide packed_of(const float& first, unsigned bits) {
    vhalf v{};
#if SUNDOG_KERNEL_LANES == 16
    v = bits_as<vhalf>(
        _mm512_castps512_ps256(_mm512_maskz_compress_ps(static_cast<__mmask16>(bits), _mm512_loadu_ps(&first))));
#else
    for (int lane = 0; lane < kWideLanes && bits != 0; ++lane, bits &= bits - 1)
        v[lane] = (&first)[__builtin_ctz(bits)];
#endif
    return wide(__builtin_convertvector(v, vdouble));
}

FN void store_half(wide x, float* first, int half) {
    const vhalf v = __builtin_convertvector(x.v, vhalf);
    __builtin_memcpy(first + half * kWideLanes, &v, sizeof v);
}
/// To single precision and back.
FN wide rounded(wide x) { return wide(__builtin_convertvector(__builtin_convertvector(x.v, vhalf), vdouble)); }

/// A packet's lanes whose bits are set.
FN mask lanes_of_bits(unsigned bits) {
#if SUNDOG_KERNEL_LANES == 16
    return mask(static_cast<__mmask16>(bits));
#else
    vint m{};
    for (int lane = 0; lane < kLanes; ++lane) m[lane] = (bits >> lane & 1U) != 0 ? -1 : 0;
    return mask(m);
#endif
}

}  // namespace SUNDOG_KERNEL_SPACE
}  // namespace sundog::kernel
