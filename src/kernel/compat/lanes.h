// SPDX-License-Identifier: Apache-2.0
// Several rays at a time: varying types are SIMD vectors of SUNDOG_KERNEL_LANES lanes. GCC's and clang's vector
// extensions do the arithmetic; what they lack (square roots, gathers, mask registers) is AVX-512, AVX2 or SSE4
// by what the unit is compiled for. Every operation rounds as its scalar one does, so lanes give the scalar bits.
// Included by cpp.h alone.
#pragma once

#include <immintrin.h>

#include <array>

namespace sundog::kernel {
inline namespace SUNDOG_KERNEL_SPACE {

inline constexpr int kLanes = SUNDOG_KERNEL_LANES;
using vfloat = float __attribute__((vector_size(4 * SUNDOG_KERNEL_LANES)));
using vuint = std::uint32_t __attribute__((vector_size(4 * SUNDOG_KERNEL_LANES)));
using vint = std::int32_t __attribute__((vector_size(4 * SUNDOG_KERNEL_LANES)));

/// std::bit_cast, inlined early: the tens of thousands of calls in a large kernel would keep the inliner busy for half
/// of the time that the kernel takes to compile.
template <class To, class From>
FN To bits_as(From from) {
    return reinterpret_cast<To>(from);
}

struct mask {
#if SUNDOG_KERNEL_LANES == 16
    __mmask16 m;
#else
    vint m;
#endif
    mask() = default;
    FN explicit mask(decltype(m) m_) : m(m_) {}
    /// All lanes alike.
#if SUNDOG_KERNEL_LANES == 16
    FN explicit mask(bool b) : m(static_cast<__mmask16>(b ? 0xffff : 0)) {}
#else
    FN explicit mask(bool b) : m(vint{} - (b ? 1 : 0)) {}
#endif
};

struct real {
    vfloat v;
    real() = default;
    FN real(float s) : v(s - vfloat{}) {}  // s - 0 keeps the sign of zero, s + 0 would not
    FN explicit real(vfloat v_) : v(v_) {}
};

struct word {
    vuint v;
    word() = default;
    FN word(uint s) : v(vuint{} + s) {}
    FN explicit word(vuint v_) : v(v_) {}
};

using real2 = Vec2T<real>;
using real3 = Vec3T<real>;

FN real operator+(real a, real b) { return real(a.v + b.v); }
FN real operator-(real a, real b) { return real(a.v - b.v); }
FN real operator*(real a, real b) { return real(a.v * b.v); }
FN real operator/(real a, real b) { return real(a.v / b.v); }
FN real operator-(real a) { return real(-a.v); }

FN word operator+(word a, word b) { return word(a.v + b.v); }
FN word operator-(word a, word b) { return word(a.v - b.v); }
FN word operator*(word a, word b) { return word(a.v * b.v); }
FN word operator&(word a, word b) { return word(a.v & b.v); }
FN word operator|(word a, word b) { return word(a.v | b.v); }
FN word operator^(word a, word b) { return word(a.v ^ b.v); }
FN word operator<<(word a, uint bits) { return word(a.v << bits); }
FN word operator>>(word a, uint bits) { return word(a.v >> bits); }

FN word as_word(real x) { return word(bits_as<vuint>(x.v)); }
FN real as_real(word x) { return real(bits_as<vfloat>(x.v)); }
FN word word_from_real(real x) { return word(bits_as<vuint>(__builtin_convertvector(x.v, vint))); }
FN real real_from_word(word x) { return real(__builtin_convertvector(bits_as<vint>(x.v), vfloat)); }

#if SUNDOG_KERNEL_LANES == 16

FN __m512 native(real x) { return bits_as<__m512>(x.v); }
FN __m512i native(word x) { return bits_as<__m512i>(x.v); }
FN real from_native(__m512 x) { return real(bits_as<vfloat>(x)); }
FN word from_native(__m512i x) { return word(bits_as<vuint>(x)); }

FN mask operator<(real a, real b) { return mask(_mm512_cmp_ps_mask(native(a), native(b), _CMP_LT_OQ)); }
FN mask operator<=(real a, real b) { return mask(_mm512_cmp_ps_mask(native(a), native(b), _CMP_LE_OQ)); }
FN mask operator==(word a, word b) { return mask(_mm512_cmpeq_epu32_mask(native(a), native(b))); }
FN mask operator!=(word a, word b) { return mask(_mm512_cmpneq_epu32_mask(native(a), native(b))); }
FN mask operator<(word a, word b) { return mask(_mm512_cmplt_epu32_mask(native(a), native(b))); }
FN mask mask_and(mask a, mask b) { return mask(static_cast<__mmask16>(a.m & b.m)); }
FN mask mask_or(mask a, mask b) { return mask(static_cast<__mmask16>(a.m | b.m)); }
FN mask mask_not(mask a) { return mask(static_cast<__mmask16>(~a.m)); }
FN unsigned lane_bits(mask m) { return m.m; }
FN real select(mask m, real a, real b) { return from_native(_mm512_mask_blend_ps(m.m, native(b), native(a))); }
FN word select(mask m, word a, word b) { return from_native(_mm512_mask_blend_epi32(m.m, native(b), native(a))); }
FN real sqrt(real x) { return from_native(_mm512_sqrt_ps(native(x))); }
FN real floor(real x) {
    return from_native(_mm512_roundscale_ps(native(x), _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
}
FN real abs(real x) { return from_native(_mm512_abs_ps(native(x))); }
/// -1 in active lanes, 0 in others: the form in which traversals want it.
FN vint lane_ints(mask m) { return bits_as<vint>(_mm512_movm_epi32(m.m)); }
FN real gather_lanes(const float* first, std::size_t stride_words, word i) {
    return from_native(_mm512_i32gather_ps(native(i * word(static_cast<uint>(stride_words))), first, 4));
}
FN word gather_lanes(const uint* first, std::size_t stride_words, word i) {
    return from_native(_mm512_i32gather_epi32(native(i * word(static_cast<uint>(stride_words))), first, 4));
}

#else

FN mask operator<(real a, real b) { return mask(bits_as<vint>(a.v < b.v)); }
FN mask operator<=(real a, real b) { return mask(bits_as<vint>(a.v <= b.v)); }
FN mask operator==(word a, word b) { return mask(bits_as<vint>(a.v == b.v)); }
FN mask operator!=(word a, word b) { return mask(bits_as<vint>(a.v != b.v)); }
FN mask operator<(word a, word b) { return mask(bits_as<vint>(a.v < b.v)); }
FN mask mask_and(mask a, mask b) { return mask(a.m & b.m); }
FN mask mask_or(mask a, mask b) { return mask(a.m | b.m); }
FN mask mask_not(mask a) { return mask(~a.m); }
FN vint lane_ints(mask m) { return m.m; }
FN real abs(real x) { return as_real(as_word(x) & word(0x7fffffffu)); }

#if SUNDOG_KERNEL_LANES == 8
FN unsigned lane_bits(mask m) { return static_cast<unsigned>(_mm256_movemask_ps(bits_as<__m256>(m.m))); }
FN real select(mask m, real a, real b) {
    return real(bits_as<vfloat>(_mm256_blendv_ps(bits_as<__m256>(b.v), bits_as<__m256>(a.v), bits_as<__m256>(m.m))));
}
FN real sqrt(real x) { return real(bits_as<vfloat>(_mm256_sqrt_ps(bits_as<__m256>(x.v)))); }
FN real floor(real x) { return real(bits_as<vfloat>(_mm256_floor_ps(bits_as<__m256>(x.v)))); }
FN real gather_lanes(const float* first, std::size_t stride_words, word i) {
    const word offset = i * word(static_cast<uint>(stride_words));
    return real(bits_as<vfloat>(_mm256_i32gather_ps(first, bits_as<__m256i>(offset.v), 4)));
}
FN word gather_lanes(const uint* first, std::size_t stride_words, word i) {
    const word offset = i * word(static_cast<uint>(stride_words));
    return word(
        bits_as<vuint>(_mm256_i32gather_epi32(reinterpret_cast<const int*>(first), bits_as<__m256i>(offset.v), 4)));
}
#else
FN unsigned lane_bits(mask m) { return static_cast<unsigned>(_mm_movemask_ps(bits_as<__m128>(m.m))); }
FN real select(mask m, real a, real b) {
    return real(bits_as<vfloat>(_mm_blendv_ps(bits_as<__m128>(b.v), bits_as<__m128>(a.v), bits_as<__m128>(m.m))));
}
FN real sqrt(real x) { return real(bits_as<vfloat>(_mm_sqrt_ps(bits_as<__m128>(x.v)))); }
FN real floor(real x) { return real(bits_as<vfloat>(_mm_floor_ps(bits_as<__m128>(x.v)))); }
FN real gather_lanes(const float* first, std::size_t stride_words, word i) {
    vfloat v{};
    for (int lane = 0; lane < kLanes; ++lane) v[lane] = first[stride_words * i.v[lane]];
    return real(v);
}
FN word gather_lanes(const uint* first, std::size_t stride_words, word i) {
    vuint v{};
    for (int lane = 0; lane < kLanes; ++lane) v[lane] = first[stride_words * i.v[lane]];
    return word(v);
}
#endif
FN word select(mask m, word a, word b) { return as_word(select(m, as_real(a), as_real(b))); }

#endif

FN mask operator>(real a, real b) { return b < a; }
FN mask operator>=(real a, real b) { return b <= a; }
FN mask select_mask(mask m, mask a, mask b) { return mask_or(mask_and(m, a), mask_and(mask_not(m), b)); }
FN bool any_lane(mask m) { return lane_bits(m) != 0; }
FN bool all_lanes(mask m) { return lane_bits(m) == (1u << kLanes) - 1u; }
FN real min(real a, real b) { return select(a < b, a, b); }
FN real max(real a, real b) { return select(a > b, a, b); }

// Uniform arithmetic, under the same names.
FN float sqrt(float x) { return std::sqrt(x); }
FN float abs(float x) { return std::fabs(x); }
FN float floor(float x) { return std::floor(x); }
FN float min(float a, float b) { return a < b ? a : b; }
FN float max(float a, float b) { return a > b ? a : b; }
FN uint min(uint a, uint b) { return a < b ? a : b; }
FN uint max(uint a, uint b) { return a > b ? a : b; }

/// True where all lanes hold the same index: neighbouring rays mostly hit the same thing, and one load is then
/// worth
/// many. (The compiler asks once for all fields of a struct.)
FN bool same_in_all_lanes(word i) { return all_lanes(i == word(i.v[0])); }
FN real gather(const float* first, std::size_t stride_words, word i) {
    return same_in_all_lanes(i) ? real(first[stride_words * i.v[0]]) : gather_lanes(first, stride_words, i);
}
FN word gather(const uint* first, std::size_t stride_words, word i) {
    return same_in_all_lanes(i) ? word(first[stride_words * i.v[0]]) : gather_lanes(first, stride_words, i);
}
/// `i` in the lanes of m, and one of those values in the others, so that these neither point astray nor spoil what
/// is alike.
FN word valid_index(mask m, word i) {
    const unsigned bits = lane_bits(m);
    return select(m, i, word(bits == 0 ? 0u : i.v[__builtin_ctz(bits)]));
}

/// The value in the first of the lanes of m (some lane must be in it), as a uniform one.
FN uint first_lane(mask m, word i) { return i.v[__builtin_ctz(lane_bits(m))]; }
/// A uniform float from its bits.
FN float uniform_float(uint bits) { return std::bit_cast<float>(bits); }

FN real load(const float* first, std::size_t stride_bytes, word i) { return gather(first, stride_bytes / 4, i); }
FN word load(const uint* first, std::size_t stride_bytes, word i) { return gather(first, stride_bytes / 4, i); }
FN real2 load(const vec2* first, std::size_t stride_bytes, word i) {
    return real2(gather(&first->x, stride_bytes / 4, i), gather(&first->y, stride_bytes / 4, i));
}
FN real3 load(const vec3* first, std::size_t stride_bytes, word i) {
    return real3(gather(&first->x, stride_bytes / 4, i), gather(&first->y, stride_bytes / 4, i),
                 gather(&first->z, stride_bytes / 4, i));
}

}  // namespace SUNDOG_KERNEL_SPACE
}  // namespace sundog::kernel
