// SPDX-License-Identifier: Apache-2.0
#include "device/bvh/split.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <utility>

namespace sundog::bvh {
namespace {

constexpr int kMaxBins = 16;
/// Ranges of fewer references are binned by one thread.
constexpr std::size_t kParallelCount = 1U << 15U;
/// Centres that spread less than this allows count as one place; a larger scale would overflow.
constexpr float kLargestScale = 1e30F;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::array<float, 4> lanes(__m128 v) {
    alignas(16) std::array<float, 4> out;
    _mm_store_ps(out.data(), v);
    return out;
}

/// 1 / extent, 0 where that would be too large to work with.
float safe_inverse(float extent) { return extent > 1 / kLargestScale ? 1 / extent : 0.0F; }

/// Maps a centre to its bin in each axis.
struct BinMapping {
    int bins;
    __m128 origin;
    __m128 scale;  // 0 in axes along which the centres do not spread

    BinMapping(const Box4& centers, std::size_t count)
        // Few references need few bins: the sweep over the bins would cost more than it finds.
        : bins(static_cast<int>(std::min<std::size_t>(kMaxBins, 4 + count / 8))), origin(centers.lower) {
        const auto lower = lanes(centers.lower);
        const auto upper = lanes(centers.upper);
        alignas(16) std::array<float, 4> s{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // Slightly less than bins: the last centre stays in.
            s[axis] = 0.99F * static_cast<float>(bins) * safe_inverse(upper[axis] - lower[axis]);
        }
        scale = _mm_load_ps(s.data());
    }

    [[nodiscard]] std::array<int, 4> operator()(const Reference& reference) const {
        const __m128 position = _mm_mul_ps(_mm_sub_ps(reference.center(), origin), scale);
        const __m128 last = _mm_set1_ps(static_cast<float>(bins - 1));
        alignas(16) std::array<int, 4> out;
        _mm_store_si128(reinterpret_cast<__m128i*>(out.data()), _mm_cvttps_epi32(_mm_min_ps(position, last)));
        return out;
    }
};

struct Bin {
    Box4 box;
    std::uint32_t count = 0;
};

/// The bins of all three axes. Only the first `used` of each axis are ever touched: clearing all of them would take
/// longer than a small split.
struct Bins {
    int used;
    std::array<std::array<Bin, kMaxBins>, 3> axes;

    explicit Bins(int used_) : used(used_) {
        for (auto& axis : axes) std::fill_n(axis.begin(), used, Bin{});
    }
    void add(std::span<const Reference> references, const BinMapping& mapping) {
        for (const Reference& reference : references) {
            const auto places = mapping(reference);
            const Box4 box = reference.box();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Bin& bin = axes[axis][static_cast<std::size_t>(places[axis])];
                bin.box.include(box);
                ++bin.count;
            }
        }
    }
    void add(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(used); ++i) {
                axes[axis][i].box.include(other.axes[axis][i].box);
                axes[axis][i].count += other.axes[axis][i].count;
            }
        }
    }
};

Bins bin(std::span<const Reference> references, const BinMapping& mapping) {
    if (references.size() < kParallelCount) {
        Bins bins(mapping.bins);
        bins.add(references, mapping);
        return bins;
    }
    // Minima, maxima and counts come out the same in whatever order the parts are joined.
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, references.size(), kParallelCount / 4), Bins(mapping.bins),
        [&](const tbb::blocked_range<std::size_t>& part, Bins bins) {
            bins.add(references.subspan(part.begin(), part.size()), mapping);
            return bins;
        },
        [](Bins a, const Bins& b) {
            a.add(b);
            return a;
        });
}

/// Bins up to and including `last` of `axis` go left.
struct Cut {
    std::size_t axis = 0;
    int last = -1;  // -1: no cut divides anything
};

Cut cheapest_cut(const Bins& bins, float scale) {
    Cut best;
    float best_cost = kInfinity;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& row = bins.axes[axis];
        std::array<float, kMaxBins> right_cost;
        Box4 box;
        float count = 0;
        for (int i = bins.used - 1; i > 0; --i) {
            const auto& b = row[static_cast<std::size_t>(i)];
            box.include(b.box);
            count += static_cast<float>(b.count);
            // Infinite where nothing would go right.
            right_cost[static_cast<std::size_t>(i)] = count > 0 ? half_area(box, scale) * count : kInfinity;
        }
        box = {};
        count = 0;
        for (int i = 0; i + 1 < bins.used; ++i) {
            const auto& b = row[static_cast<std::size_t>(i)];
            box.include(b.box);
            count += static_cast<float>(b.count);
            if (count == 0) continue;
            const float cost = half_area(box, scale) * count + right_cost[static_cast<std::size_t>(i) + 1];
            if (cost < best_cost) {
                best_cost = cost;
                best = {axis, i};
            }
        }
    }
    return best;
}

/// Moves references for which `goes_left` holds to the front; gathers both sides' bounds on the way.
template <class Predicate>
void partition(std::span<Reference> references, const Predicate& goes_left, Range& left, Range& right) {
    left = right = {};
    std::size_t begin = 0;
    std::size_t end = references.size();
    const auto put = [](Range& range, const Reference& reference) {
        range.box.include(reference.box());
        range.centers.include(reference.center());
    };
    while (true) {
        for (; begin < end && goes_left(references[begin]); ++begin) put(left, references[begin]);
        for (; begin < end && !goes_left(references[end - 1]); --end) put(right, references[end - 1]);
        if (begin >= end) break;
        std::swap(references[begin], references[end - 1]);
    }
    left.references = references.first(begin);
    right.references = references.subspan(begin);
}

void halve(std::span<Reference> references, Range& left, Range& right) {
    const std::size_t middle = (references.size() + 1) / 2;
    left = make_range(references.first(middle));
    right = make_range(references.subspan(middle));
}

}  // namespace

Bounds3 to_bounds(const Box4& box) {
    const auto lower = lanes(box.lower);
    const auto upper = lanes(box.upper);
    return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
}

float area_scale(const Box4& box) {
    const auto size = lanes(_mm_sub_ps(box.upper, box.lower));
    return safe_inverse(std::max({size[0], size[1], size[2]}));
}

Range make_range(std::span<Reference> references) {
    Range range{references, {}, {}};
    for (const Reference& reference : references) {
        range.box.include(reference.box());
        range.centers.include(reference.center());
    }
    return range;
}

void split(const Range& range, Range& left, Range& right) {
    if (range.references.size() == 2) {
        halve(range.references, left, right);
        return;
    }
    const BinMapping mapping(range.centers, range.references.size());
    const Cut cut = cheapest_cut(bin(range.references, mapping), area_scale(range.box));
    if (cut.last < 0) {
        halve(range.references, left, right);
        return;
    }
    partition(
        range.references, [&](const Reference& r) { return mapping(r)[cut.axis] <= cut.last; }, left, right);
}

void split_median(const Range& range, Range& left, Range& right) {
    const Vec3 extent = to_bounds(range.centers).extent();
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto middle = range.references.begin() + static_cast<std::ptrdiff_t>((range.references.size() + 1) / 2);
    // Ties are broken by the primitive's index, so that the order is one and the same everywhere.
    std::nth_element(range.references.begin(), middle, range.references.end(),
                     [axis](const Reference& a, const Reference& b) {
                         const float ca = a.lower[axis] + a.upper[axis];
                         const float cb = b.lower[axis] + b.upper[axis];
                         return ca != cb ? ca < cb : a.primitive < b.primitive;
                     });
    halve(range.references, left, right);
}

}  // namespace sundog::bvh
