// SPDX-License-Identifier: Apache-2.0
// One step of the builder: where to divide a run of primitives in two.
#pragma once

#include <emmintrin.h>

#include <cstdint>
#include <limits>
#include <span>

#include "base/vec.h"

namespace sundog::bvh {

/// Bounds as two SSE registers: growing them is what the builder does most.
struct Box4 {
    __m128 lower = _mm_set1_ps(std::numeric_limits<float>::infinity());
    __m128 upper = _mm_set1_ps(-std::numeric_limits<float>::infinity());

    void include(__m128 point) { lower = _mm_min_ps(lower, point), upper = _mm_max_ps(upper, point); }
    void include(const Box4& box) { lower = _mm_min_ps(lower, box.lower), upper = _mm_max_ps(upper, box.upper); }
};

Bounds3 to_bounds(const Box4& box);

/// Half the surface of a box that is not empty, whose size is first multiplied by `scale`: 1 / (the largest size that
/// it is to be compared with), so that neither large nor small sizes overflow or underflow when squared.
inline float half_area(const Box4& box, float scale) {
    const __m128 size = _mm_mul_ps(_mm_sub_ps(box.upper, box.lower), _mm_set1_ps(scale));
    const __m128 products = _mm_mul_ps(size, _mm_shuffle_ps(size, size, _MM_SHUFFLE(3, 0, 2, 1)));
    const __m128 yz = _mm_shuffle_ps(products, products, _MM_SHUFFLE(1, 1, 1, 1));
    const __m128 zx = _mm_shuffle_ps(products, products, _MM_SHUFFLE(2, 2, 2, 2));
    return _mm_cvtss_f32(_mm_add_ss(_mm_add_ss(products, yz), zx));
}

/// The scale with which half_area() compares parts of `box`.
float area_scale(const Box4& box);

/// A primitive as the builder moves it about: 32 bytes, the index in the place of lower.w.
struct alignas(16) Reference {
    float lower[3];
    std::uint32_t primitive;
    float upper[3];
    float zero;

    [[nodiscard]] Box4 box() const {
        // An index read as a float is a denormal, with which arithmetic is many times slower.
        const __m128 xyz = _mm_castsi128_ps(_mm_set_epi32(0, -1, -1, -1));
        return {_mm_and_ps(_mm_load_ps(lower), xyz), _mm_load_ps(upper)};
    }
    [[nodiscard]] __m128 center() const {
        const Box4 b = box();
        return _mm_mul_ps(_mm_add_ps(b.lower, b.upper), _mm_set1_ps(0.5F));
    }
};

/// A run of references with what they span.
struct Range {
    std::span<Reference> references;
    Box4 box;
    Box4 centers;
};

/// The range over all of `references`.
Range make_range(std::span<Reference> references);

/// Reorders the range's references and divides them where the surface area heuristic finds it cheapest; in the middle
/// where all centres coincide. The range must have two references or more; both halves get at least one.
void split(const Range& range, Range& left, Range& right);

/// Divides at the median of the axis in which the centres spread most: the left half gets (n + 1) / 2.
void split_median(const Range& range, Range& left, Range& right);

}  // namespace sundog::bvh
