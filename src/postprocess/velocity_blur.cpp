// SPDX-License-Identifier: Apache-2.0
#include "postprocess/velocity_blur.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sundog::postprocess {
namespace {

constexpr int kBand = 32;           ///< Rows that one task makes.
constexpr float kStill_px = 0.05F;  ///< Shorter paths are none.
constexpr float kApart_px = 1;      ///< Ends of paths that differ by less go the same way.
constexpr float kMoves_px = 6;      ///< Longer paths hide that an edge isn't smooth.
constexpr int kBeside_px = 2;       ///< How far a silhouette's pixel looks for its thing's own light.

/// Sums over what comes to a pixel: light and the share of time.
struct Sum {
    Vec3 light;
    float share = 0;
    void add(Vec3 radiance, float weight) { light += radiance * weight, share += weight; }
};

struct Layers {
    Sum front, own;
};

/// Of another's light at a pixel, what lies before and what behind what the pixel shows; the rest belongs to it.
struct Order {
    float front, behind;
};

class Blur {
public:
    explicit Blur(const MovingPicture& picture) : picture_(picture), radiance_(unmixed()) {
        for (int y = 0; y < picture.height; ++y) {
            Rows rows{y, y};
            for (int x = 0; x < picture.width; ++x) {
                const PixelPath& path = picture.path[index(x, y)];
                const auto [least, most] = std::minmax({path.opens.y, path.closes.y, 0.0F});
                // Between three places a parabola reaches beyond them by at most an eighth of their distance.
                const float beyond = (most - least) / 8 + 1;
                rows.first = std::min(rows.first, y + static_cast<int>(std::floor(least - beyond)));
                rows.last = std::max(rows.last, y + static_cast<int>(std::ceil(most + beyond)));
            }
            reached_.push_back(rows);
        }
    }

    /// Rows [y0, y1) of the result.
    void make_rows(int y0, int y1, std::vector<Vec3>& out) const {
        std::vector<Layers> layers(static_cast<std::size_t>(y1 - y0) * static_cast<std::size_t>(picture_.width));
        for (int y = 0; y < picture_.height; ++y) {
            const Rows& rows = reached_[static_cast<std::size_t>(y)];
            if (rows.last < y0 || rows.first >= y1) continue;
            for (int x = 0; x < picture_.width; ++x) spread(x, y, y0, y1, layers);
        }
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < picture_.width; ++x)
                out[index(x, y)] = composed(x, y, layers[index(x, y) - index(0, y0)]);
    }

private:
    struct Rows {
        int first, last;
    };

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool inside(int x, int y) const {
        return x >= 0 && y >= 0 && x < picture_.width && y < picture_.height;
    }

    static float length_of(const PixelPath& path) {
        return std::hypot(path.opens.x, path.opens.y) + std::hypot(path.closes.x, path.closes.y);
    }

    /// Places along a path, all at the same time from each other: 1 for what stays.
    static int places_on(const PixelPath& path) {
        const float length = length_of(path);
        return length < kStill_px ? 1 : static_cast<int>(std::ceil(length)) + 1;
    }
    static Vec2 place_on(const PixelPath& path, int i, int places) {
        const float t = 2 * (static_cast<float>(i) + 0.5F) / static_cast<float>(places) - 1;
        const float to_close = 0.5F * t * (t + 1), to_open = 0.5F * t * (t - 1);
        return {path.opens.x * to_open + path.closes.x * to_close, path.opens.y * to_open + path.closes.y * to_close};
    }

    /// How pixel `other`'s thing lies to that of pixel `here`.
    [[nodiscard]] Order order(std::size_t other, std::size_t here) const {
        const float a = picture_.depth[other], b = picture_.depth[here];
        if (a == b) return {0, 0};
        // Relative difference; 1 where one of them has no end.
        const float apart = std::isinf(a) || std::isinf(b) ? 1 : std::abs(a - b) / std::min(a, b);
        // One thing may well reach from here to there.
        const bool same = picture_.group[other] == picture_.group[here];
        const float share = same ? std::clamp(10 * apart - 1, 0.0F, 1.0F) : std::min(100 * apart, 1.0F);
        return a < b ? Order{share, 0} : Order{0, share};
    }

    /// True if two pixels show two things that go different ways, and the nearer of them moves. What rests before
    /// moving things keeps its smooth edge.
    [[nodiscard]] bool mixes(std::size_t here, std::size_t other) const {
        const PixelPath &a = picture_.path[here], &b = picture_.path[other];
        const auto apart = [](Vec2 u, Vec2 v) { return std::max(std::abs(u.x - v.x), std::abs(u.y - v.y)); };
        if (std::max(apart(a.opens, b.opens), apart(a.closes, b.closes)) < kApart_px) return false;
        const Order o = order(other, here);
        return (o.front > 0.5F && length_of(b) > kMoves_px) || (o.behind > 0.5F && length_of(a) > kMoves_px);
    }

    /// The light that each pixel spreads.
    [[nodiscard]] std::vector<Vec3> unmixed() const {
        std::vector<Vec3> out(picture_.radiance.begin(), picture_.radiance.end());
        std::vector<char> mixed(out.size());
        const auto around = [&](int x, int y, int reach, auto&& call) {
            for (int to_y = std::max(y - reach, 0); to_y <= std::min(y + reach, picture_.height - 1); ++to_y)
                for (int to_x = std::max(x - reach, 0); to_x <= std::min(x + reach, picture_.width - 1); ++to_x)
                    call(index(to_x, to_y));
        };
        const auto rows = [&](auto&& call) {
            tbb::parallel_for(0, picture_.height, [&](int y) {
                for (int x = 0; x < picture_.width; ++x) call(x, y, index(x, y));
            });
        };
        rows([&](int x, int y, std::size_t here) {
            bool found = false;
            around(x, y, 1, [&](std::size_t other) { found = found || mixes(here, other); });
            mixed[here] = found ? 1 : 0;
        });
        rows([&](int x, int y, std::size_t here) {
            if (mixed[here] == 0) return;
            Sum own;
            around(x, y, kBeside_px, [&](std::size_t other) {
                const Order o = order(other, here);
                if (mixed[other] == 0) own.add(picture_.radiance[other], 1 - o.front - o.behind);
            });
            if (own.share > 0.5F) out[here] = own.light / own.share;
        });
        return out;
    }

    /// Adds the light of pixel (x, y) to all that it comes by.
    void spread(int x, int y, int y0, int y1, std::vector<Layers>& layers) const {
        const std::size_t from = index(x, y);
        const PixelPath& path = picture_.path[from];
        const int places = places_on(path);
        const float share = 1 / static_cast<float>(places);
        const auto add = [&](int to_x, int to_y, float weight) {
            if (to_y < y0 || to_y >= y1 || to_x < 0 || to_x >= picture_.width || weight <= 0) return;
            const std::size_t to = index(to_x, to_y);
            const Order o = order(from, to);
            Layers& sums = layers[to - index(0, y0)];
            if (o.front > 0) sums.front.add(radiance_[from], o.front * weight);
            if (o.front + o.behind < 1) sums.own.add(radiance_[from], (1 - o.front - o.behind) * weight);
        };
        if (places == 1) return add(x, y, 1);
        for (int i = 0; i < places; ++i) {
            const Vec2 at = place_on(path, i, places);
            const float left = std::floor(at.x), top = std::floor(at.y);
            const float fx = at.x - left, fy = at.y - top;
            const int to_x = x + static_cast<int>(left), to_y = y + static_cast<int>(top);
            if (to_y + 1 < y0 || to_y >= y1) continue;
            add(to_x, to_y, share * (1 - fx) * (1 - fy));
            add(to_x + 1, to_y, share * fx * (1 - fy));
            add(to_x, to_y + 1, share * (1 - fx) * fy);
            add(to_x + 1, to_y + 1, share * fx * fy);
        }
    }

    [[nodiscard]] Vec3 composed(int x, int y, const Layers& layers) const {
        constexpr float kLittle = 1e-4F;
        const std::size_t here = index(x, y);
        const Sum& own = layers.own;
        Vec3 out = own.share > kLittle ? own.light / own.share : radiance_[here];
        if (own.share < 1 - kLittle) {
            const PixelPath& path = picture_.path[here];
            const int places = places_on(path);
            Sum behind;
            float blocked = 0;
            for (int i = 0; i < places; ++i) {
                const Vec2 at = place_on(path, i, places);
                const int from_x = x + static_cast<int>(std::lround(at.x));
                const int from_y = y + static_cast<int>(std::lround(at.y));
                if (!inside(from_x, from_y)) {
                    blocked += 1;
                    continue;
                }
                const std::size_t from = index(from_x, from_y);
                const Order o = order(from, here);
                blocked += o.front;
                if (o.behind > 0) behind.add(radiance_[from], o.behind);
            }
            // Its own thing goes on behind what is before it, and beyond the picture.
            const float open = std::max(1 - blocked / static_cast<float>(places), kLittle);
            const float own_share = std::min(own.share / open, 1.0F);
            if (behind.share > 0) out = out * own_share + behind.light * ((1 - own_share) / behind.share);
        }
        const float front = std::min(layers.front.share, 1.0F);
        if (front > 0) out = layers.front.light * (front / layers.front.share) + out * (1 - front);
        return out;
    }

    const MovingPicture& picture_;
    std::vector<Vec3> radiance_;  ///< unmixed().
    std::vector<Rows> reached_;   ///< By the light of each row.
};

}  // namespace

std::vector<Vec3> velocity_blurred(const MovingPicture& picture, const StopFlag& stop) {
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (picture.width <= 0 || picture.height <= 0 || picture.radiance.size() != pixels ||
        picture.depth.size() != pixels || picture.group.size() != pixels || picture.path.size() != pixels)
        throw std::invalid_argument("velocity_blurred: a plane is not of the picture's size");
    std::vector<PixelPath> paths(picture.path.begin(), picture.path.end());
    const auto shorten = [](Vec2& v) {
        const float length = std::hypot(v.x, v.y);
        if (length > kLongestPath_px) v = {v.x * (kLongestPath_px / length), v.y * (kLongestPath_px / length)};
        if (!std::isfinite(v.x) || !std::isfinite(v.y)) v = {};
    };
    for (PixelPath& path : paths) shorten(path.opens), shorten(path.closes);
    MovingPicture bounded = picture;
    bounded.path = paths;
    const Blur blur(bounded);
    std::vector<Vec3> out(pixels);
    tbb::parallel_for(0, (picture.height + kBand - 1) / kBand, [&](int band) {
        if (!stop.requested()) blur.make_rows(band * kBand, std::min((band + 1) * kBand, picture.height), out);
    });
    if (stop.requested()) return {};
    return out;
}

}  // namespace sundog::postprocess
