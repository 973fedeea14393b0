// SPDX-License-Identifier: Apache-2.0
// The points of a tile of the picture that have been traced, and what each of them remembers. Freestanding: no standard
// library, no allocation.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sundog::sampling {

/// Four floats in one register: linear red, green and blue, and what the fourth place is said to be.
using Float4 = float __attribute__((vector_size(16)));
/// The same in memory of any alignment.
using StoredFloat4 = float __attribute__((vector_size(16), aligned(4), may_alias));

/// Side of the coarsest squares, and of the tiles that are refined one by one, in pixels.
inline constexpr int kSquareSide = 8;
inline constexpr int kRefinedTileSide = 64;
inline constexpr int kSquaresAcross = kRefinedTileSide / kSquareSide;

/// A primitive that the eye sees, as the tracer numbers it.
struct SeenPrimitive {
    std::uint32_t geometry = 0;  ///< From 1; 0: none, or none that its neighbours could be taken to see.
    std::uint32_t primitive = 0;
};

/// What a traced point of the picture remembers (after Akimoto, Mase and Suenaga, Pixel-Selected Ray Tracing, IEEE
/// CG&A 1991, and Bala, Dorsey and Teller, Radiance Interpolants, ACM ToG 1999).
struct PointRecord {
    /// Radiance as the pixel shows it; the fourth place is 1, the number of samples.
    Float4 whole{};
    /// The same without what `shade` stands for. Fourth: as luminance, how much of it came by way of further surfaces.
    Float4 light{};
    /// What the first surface's texture is multiplied by; 0 where it has none.
    Float4 shade{};
    /// Equal where rays met the same objects in the same order, and the same lights lit each of them. 0: nothing is
    /// like it.
    std::uint32_t signature = 0;
    /// Equal where the eye itself sees the same object, whatever lights it and whatever it mirrors.
    std::uint32_t outline = 0;
    /// Equal where the same lights also have a visible highlight.
    std::uint32_t highlights = 0;
    /// The textured object that the eye sees, from 1; 0: it has no texture.
    std::uint32_t surface = 0;
    std::uint32_t rays = 0;  ///< Of all kinds, that the point took.
    SeenPrimitive seen;
};

/// A pixel whose light is known but not its texture.
struct SurfaceLook {
    Float4 light, shade;    ///< As in PointRecord: from here
    Float4 whole;           ///< to this,
    std::uint32_t surface;  ///< and which surface was found.
};

/// A point of a tile, in pixels from its first.
struct TilePlace {
    std::uint8_t x, y;
};

/// What counts as the same.
struct RefinementQuality {
    /// Most by which the corners of a coarsest square may differ for the eye (square roots of radiance, 1: white);
    /// smaller squares' may differ by more, as what lies between them bends less.
    float tolerance = 0.1F;
    /// Times radiance, before it is looked at.
    float gain = 1;
};

/// Where a tile's pixels go: rows of four floats, the fourth the number of samples.
struct TilePixels {
    float* first;           ///< The tile's first pixel.
    std::ptrdiff_t stride;  ///< Floats from row to row.
    int width, height;      ///< Of the part that lies in the picture; at most kRefinedTileSide.

    [[nodiscard]] StoredFloat4* row(int y) const { return reinterpret_cast<StoredFloat4*>(first + y * stride); }
};

/// Points between and at the corners of a tile's squares; the last column and row belong to the next tiles, too.
class TracedGrid {
public:
    static constexpr int kPointsAcross = kRefinedTileSide + 1;
    static constexpr int kPoints = kPointsAcross * kPointsAcross;

    /// Forgets all points.
    void clear() {
        for (std::uint8_t& wanted : wanted_) wanted = 0;
        traced_count_ = place_count_ = 0;
    }

    /// Asks for a point that hasn't been asked for yet; trace_wanted() traces it.
    void want(int x, int y) {
        std::uint8_t& wanted = wanted_[index(x, y)];
        if (wanted != 0) return;
        wanted = 1;
        places_[place_count_++] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)};
    }
    [[nodiscard]] bool is_wanted(int x, int y) const { return wanted_[index(x, y)] != 0; }

    /// Traces what was wanted since the last call, in that order, into the pixels: tracer.trace(places, count, records)
    /// is called, for at most kBatch places at a time.
    template <class Tracer>
    void trace_wanted(Tracer& tracer, const RefinementQuality& quality, const TilePixels& pixels) {
        while (traced_count_ < place_count_) {
            const int left = place_count_ - traced_count_;
            const int count = left < kBatch ? left : kBatch;
            const TilePlace* places = places_ + traced_count_;
            tracer.trace(places, count, records_);
            for (int i = 0; i < count; ++i) keep(places[i], records_[i], quality, pixels);
            traced_count_ += count;
        }
    }

    /// True if the points at all four corners remember the same and look alike.
    [[nodiscard]] bool agree(int x, int y, int step, const RefinementQuality& quality) const {
        // What bilinear interpolation misses grows with the square of the step, the difference of the ends with the
        // step: smaller squares may differ by more for the same error.
        return signature_[index(x, y)] != 0 && same(signature_, x, y, step) && same(highlights_, x, y, step) &&
               look_alike(x, y, step, quality.tolerance * static_cast<float>(kSquareSide) / static_cast<float>(step));
    }
    /// The same for points two pixels apart, between which hardly anything hides: edges of highlights, and faint ones
    /// of shadows and of what mirrors show, may be two pixels soft; the outlines of what the eye itself sees never are.
    [[nodiscard]] bool agree_softly(int x, int y, const RefinementQuality& quality) const {
        constexpr int kStep = 2;
        const int a = index(x, y), c = index(x, y + kStep);
        if (signature_[a] == 0 || signature_[a + kStep] == 0 || signature_[c] == 0 || signature_[c + kStep] == 0)
            return false;
        if (same(signature_, x, y, kStep))
            return look_alike(x, y, kStep, quality.tolerance * (static_cast<float>(kSquareSide) / kStep));
        return same_outline(x, y, kStep) && look_alike(x, y, kStep, quality.tolerance);
    }
    /// agree() and agree_softly() for the two ends of a stretch of a scan line.
    [[nodiscard]] bool ends_agree(int x, int y, int step, const RefinementQuality& quality) const {
        const int a = index(x, y), b = a + step;
        return signature_[a] != 0 && signature_[a] == signature_[b] && highlights_[a] == highlights_[b] &&
               ends_look_alike(a, b, quality.tolerance * static_cast<float>(kSquareSide) / static_cast<float>(step));
    }
    [[nodiscard]] bool ends_agree_softly(int x, int y, const RefinementQuality& quality) const {
        constexpr int kStep = 2;
        const int a = index(x, y), b = a + kStep;
        if (signature_[a] == 0 || signature_[b] == 0) return false;
        if (signature_[a] == signature_[b])
            return ends_look_alike(a, b, quality.tolerance * (static_cast<float>(kSquareSide) / kStep));
        return outline_[a] == outline_[b] && ends_look_alike(a, b, quality.tolerance);
    }
    /// True if the eye sees one object at all four corners.
    [[nodiscard]] bool same_outline(int x, int y, int step) const { return same(outline_, x, y, step); }

    [[nodiscard]] Float4 light(int x, int y) const { return light_[index(x, y)]; }
    [[nodiscard]] Float4 shade(int x, int y) const { return shade_[index(x, y)]; }
    [[nodiscard]] std::uint32_t surface(int x, int y) const { return surface_[index(x, y)]; }
    [[nodiscard]] int traced_count() const { return traced_count_; }

    /// Most points of one call of a tracer.
    static constexpr int kBatch = 64;

private:
    static constexpr int index(int x, int y) { return y * kPointsAcross + x; }
    static bool same(const std::uint32_t* of, int x, int y, int step) {
        const int a = index(x, y), c = index(x, y + step);
        return of[a] == of[a + step] && of[a] == of[c] && of[a] == of[c + step];
    }
    static Float4 least(Float4 a, Float4 b) { return a < b ? a : b; }
    static Float4 most(Float4 a, Float4 b) { return a > b ? a : b; }

    [[nodiscard]] bool look_alike(int x, int y, int step, float most_apart) const {
        const int a = index(x, y), c = index(x, y + step);
        const Float4 low = least(least(seen_[a], seen_[a + step]), least(seen_[c], seen_[c + step]));
        const Float4 high = most(most(seen_[a], seen_[a + step]), most(seen_[c], seen_[c + step]));
        return none_exceeds(high - low, most_apart);
    }
    [[nodiscard]] bool ends_look_alike(int a, int b, float most_apart) const {
        return none_exceeds(most(seen_[a], seen_[b]) - least(seen_[a], seen_[b]), most_apart);
    }
    static bool none_exceeds(Float4 apart, float most_apart) {
        // Written so that NaN isn't like anything.
        return apart[0] <= most_apart && apart[1] <= most_apart && apart[2] <= most_apart && apart[3] <= most_apart;
    }

    void keep(TilePlace place, const PointRecord& record, const RefinementQuality& quality, const TilePixels& pixels) {
        const int at = index(place.x, place.y);
        if (place.x < pixels.width && place.y < pixels.height) pixels.row(place.y)[place.x] = record.whole;
        light_[at] = record.light;
        if (record.surface != 0) shade_[at] = record.shade;
        signature_[at] = record.signature;
        outline_[at] = record.outline;
        highlights_[at] = record.highlights;
        surface_[at] = record.surface;
        const Float4 all = (record.light + record.shade) * quality.gain;
        Float4 seen;
        for (int i = 0; i < 4; ++i) seen[i] = __builtin_sqrtf(all[i] < 0 ? 0 : all[i] > 1 ? 1 : all[i]);
        seen_[at] = seen;
    }

    Float4 light_[kPoints], shade_[kPoints];
    Float4 seen_[kPoints];  ///< As the eye has it, for comparisons.
    std::uint32_t signature_[kPoints], outline_[kPoints], highlights_[kPoints], surface_[kPoints];
    std::uint8_t wanted_[kPoints];
    TilePlace places_[kPoints];
    int place_count_ = 0, traced_count_ = 0;
    PointRecord records_[kBatch];
};

}  // namespace sundog::sampling
