// SPDX-License-Identifier: Apache-2.0
#include "postprocess/lens_blur.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace sundog::postprocess {
namespace {

constexpr int kStrip = 32;          ///< Pixels of a row that are made together.
constexpr float kRadiusSteps = 16;  ///< Radii are rounded to parts of a pixel, so that weights can be listed.
constexpr float kSameLayer_px = 1;  ///< Blurs that differ by less belong to one surface.

/// The disc with an edge one pixel wide.
struct Disc {
    static constexpr float kReach = 1;      ///< Of the radius.
    static constexpr bool kSmooth = false;  ///< So that far from its middle, blocks of pixels are as good as pixels.
    /// What the weight's formula takes instead of the radius, for it and for the place.
    static float shape(float radius) { return radius + 0.5F; }
    static float place(float squared_distance) { return std::sqrt(squared_distance); }
    static float weight(float place, float shape) { return std::clamp(shape - place, 0.0F, 1.0F); }
};

/// (1 - d^2/(5 r^2))^8, nearly a Gaussian, which ends; its second moment is that of the disc of radius r.
struct Gaussian {
    static constexpr float kReach = 2.2360680F;
    static constexpr bool kSmooth = true;
    static float shape(float radius) { return 1 / (5 * std::max(radius * radius, 0.04F)); }
    static float place(float squared_distance) { return squared_distance; }
    static float weight(float place, float shape) {
        const float base = std::max(1 - place * shape, 0.0F);
        const float square = base * base, fourth = square * square;
        return fourth * fourth;
    }
};

/// A square of pixels beside one, by its corner's offset.
struct Tap {
    int x, y, size;
    [[nodiscard]] float squared_distance() const {
        const float half = 0.5F * static_cast<float>(size - 1);
        const float dx = static_cast<float>(x) + half, dy = static_cast<float>(y) + half;
        return dx * dx + dy * dy;
    }
};

constexpr std::array<int, 3> kSizes = {1, 2, 4};
constexpr std::array<int, 2> kZones_px = {8, 24};  ///< How far away squares of the first two sizes are taken.

/// What lies around a pixel, each pixel once.
std::vector<Tap> taps_around(int reach, bool smooth) {
    std::vector<Tap> taps;
    int within = 0;  // covered so far: [-within, within) in both directions
    for (std::size_t level = 0; level < kSizes.size(); ++level) {
        const int size = kSizes[level];
        const bool last = !smooth || level == kZones_px.size();
        const int end = last ? reach + size : std::min(kZones_px[level], reach + size);
        const int covered = within + (end - within + size - 1) / size * size;
        for (int y = -covered; y < covered; y += size)
            for (int x = -covered; x < covered; x += size) {
                if (x >= -within && x < within && y >= -within && y < within) continue;
                const Tap tap{x, y, size};
                if (std::sqrt(tap.squared_distance()) <= static_cast<float>(reach + size)) taps.push_back(tap);
            }
        within = covered;
        if (within > reach) break;
    }
    return taps;
}

/// One over the sum of a spread's weights over all pixels, for each step of radius up to the widest.
template <class S>
std::vector<float> inverse_sums(float widest) {
    std::vector<float> out;
    for (int step = 0; static_cast<float>(step) < widest * kRadiusSteps + 1; ++step) {
        const float radius = static_cast<float>(step) / kRadiusSteps;
        const float shape = S::shape(radius);
        double sum = 0;
        for (const Tap& tap : taps_around(static_cast<int>(std::ceil(radius * S::kReach)) + 1, S::kSmooth))
            sum += tap.size * tap.size * S::weight(S::place(tap.squared_distance()), shape);
        out.push_back(static_cast<float>(1 / sum));
    }
    return out;
}

using Plane = std::vector<float>;

/// The picture with a margin of the border's pixels around it.
struct Planes {
    int width, height, margin, stride;
    std::array<Plane, 3> radiance;
    Plane blur;                 ///< signed_blur_px.
    Plane shape;                ///< Of the blur's radius.
    Plane scale;                ///< One over the sum of its weights, times the number of pixels.
    std::vector<float> scales;  ///< For each step of radius.
    [[nodiscard]] std::ptrdiff_t at(int x, int y) const {
        return static_cast<std::ptrdiff_t>(y + margin) * stride + x + margin;
    }
};

int reach_px(float radius, float share) { return radius < 0.5F ? 0 : static_cast<int>(std::ceil(radius * share)); }

template <class S>
Planes planes_of(const SharpPicture& picture, const ThinLens& lens) {
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    Plane blur(pixels);
    float widest = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        blur[i] = signed_blur_px(lens, picture.axis_depth[i]);
        widest = std::max(widest, std::abs(blur[i]));
    }
    Planes out{picture.width, picture.height, reach_px(widest, S::kReach) + 2 * kSizes.back(), 0, {}, {}, {}, {}, {}};
    out.stride = (out.width + kStrip - 1) / kStrip * kStrip + 2 * out.margin;
    const auto size = static_cast<std::size_t>(out.stride) * static_cast<std::size_t>(out.height + 2 * out.margin);
    for (Plane* plane : {&out.radiance[0], &out.radiance[1], &out.radiance[2], &out.blur, &out.shape, &out.scale})
        plane->resize(size);
    out.scales = inverse_sums<S>(widest);
    tbb::parallel_for(-out.margin, out.height + out.margin, [&](int y) {
        const int from_row = std::clamp(y, 0, out.height - 1) * out.width;
        for (int x = -out.margin; x < out.stride - out.margin; ++x) {
            const auto from = static_cast<std::size_t>(from_row + std::clamp(x, 0, out.width - 1));
            const auto to = static_cast<std::size_t>(out.at(x, y));
            const Vec3 radiance = picture.radiance[from];
            for (std::size_t c = 0; c < 3; ++c) out.radiance[c][to] = radiance[c];
            const float step = std::round(std::abs(blur[from]) * kRadiusSteps);
            out.blur[to] = blur[from];
            out.shape[to] = S::shape(step / kRadiusSteps);
            out.scale[to] = out.scales[static_cast<std::size_t>(step)];
        }
    });
    return out;
}

/// Squares of pixels in place of pixels, each by its corner. Of several layers it holds the one that is blurred most:
/// the others' light doesn't come as far as squares are used.
template <class S>
Planes squares_of(const Planes& p, int size) {
    Planes out = p;
    tbb::parallel_for(-p.margin, p.height + p.margin - size + 1, [&](int y) {
        for (int x = -p.margin; x <= p.stride - p.margin - size; ++x) {
            const auto each = [&](auto&& call) {
                for (int dy = 0; dy < size; ++dy)
                    for (int dx = 0; dx < size; ++dx) call(static_cast<std::size_t>(p.at(x + dx, y + dy)));
            };
            float most = 0;
            each([&](std::size_t i) {
                if (std::abs(p.blur[i]) > std::abs(most)) most = p.blur[i];
            });
            float count = 0, blur = 0;
            std::array<float, 3> light{};
            each([&](std::size_t i) {
                if (std::abs(p.blur[i] - most) > kSameLayer_px) return;
                count += 1;
                blur += p.blur[i];
                for (std::size_t c = 0; c < 3; ++c) light[c] += p.radiance[c][i];
            });
            const auto to = static_cast<std::size_t>(p.at(x, y));
            blur /= count;
            const float step = std::round(std::abs(blur) * kRadiusSteps);
            out.blur[to] = blur;
            out.shape[to] = S::shape(step / kRadiusSteps);
            out.scale[to] = p.scales[static_cast<std::size_t>(step)] * count;
            for (std::size_t c = 0; c < 3; ++c) out.radiance[c][to] = light[c] / count;
        }
    });
    return out;
}

/// How far around each strip of a row the light that reaches it comes from, and whether all there is one layer.
struct Surroundings {
    int reach = 0;
    bool one_layer = true;
};

/// Squares of pixels and what they hold, from which the surroundings of strips are told.
class Squares {
public:
    Squares(const Planes& planes, float share)
        : columns_((planes.width + kStrip - 1) / kStrip), rows_((planes.height + kStrip - 1) / kStrip) {
        squares_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        for (int y = 0; y < planes.height; ++y)
            for (int x = 0; x < planes.width; ++x) {
                Square& square = squares_[index(x / kStrip, y / kStrip)];
                const float blur = planes.blur[static_cast<std::size_t>(planes.at(x, y))];
                square.least = std::min(square.least, blur);
                square.most = std::max(square.most, blur);
                square.reach = std::max(square.reach, reach_px(std::abs(blur), share));
            }
    }
    /// Of the strips in square (column, row).
    [[nodiscard]] Surroundings around(int column, int row) const {
        Surroundings out;
        const auto each = [&](auto&& call) {
            for (int r = 0; r < rows_; ++r)
                for (int c = 0; c < columns_; ++c) call(squares_[index(c, r)], std::max(gap(c - column), gap(r - row)));
        };
        each([&](const Square& square, int away) {
            if (away <= square.reach) out.reach = std::max(out.reach, square.reach);
        });
        float least = 1e9F, most = -1e9F;
        each([&](const Square& square, int away) {
            if (away > out.reach) return;
            least = std::min(least, square.least);
            most = std::max(most, square.most);
        });
        out.one_layer = most - least <= kSameLayer_px;
        return out;
    }

private:
    struct Square {
        float least = 1e9F, most = -1e9F;
        int reach = 0;
    };
    /// Pixels between squares that lie so many squares apart.
    static int gap(int squares) { return squares == 0 ? 0 : (std::abs(squares) - 1) * kStrip + 1; }
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    int columns_, rows_;
    std::vector<Square> squares_;
};

using Strip = std::array<float, kStrip>;

/// Sums over the places around each pixel of a strip.
struct Layers {
    std::array<Strip, 4> front{}, own{}, behind{};  ///< Red, green, blue and weights.
    Strip blocked{};                                ///< What the pixel's own disc has before it.
};

/// Adds what lies at one offset to a strip whose first pixel is `at`; of several layers.
template <class S>
void add_layers(const Planes& p, const Planes& from, std::ptrdiff_t at, const Tap& tap, Layers& out) {
    const float place = S::place(tap.squared_distance());
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(tap.y) * p.stride + tap.x;
    const float* red = from.radiance[0].data() + at + offset;
    const float* green = from.radiance[1].data() + at + offset;
    const float* blue = from.radiance[2].data() + at + offset;
    const float* blur = from.blur.data() + at + offset;
    const float* shape = from.shape.data() + at + offset;
    const float* scale = from.scale.data() + at + offset;
    const float* here_blur = p.blur.data() + at;
    const float* here_shape = p.shape.data() + at;
    const float* here_scale = p.scale.data() + at;
    const auto pixels = static_cast<float>(tap.size * tap.size);
    for (std::size_t i = 0; i < kStrip; ++i) {
        const float nearer = blur[i] - here_blur[i];
        const float front = std::clamp(nearer - kSameLayer_px, 0.0F, 1.0F);
        const float behind = std::clamp(-nearer - kSameLayer_px, 0.0F, 1.0F);
        const float spread = S::weight(place, shape[i]) * scale[i];
        const float here = S::weight(place, here_shape[i]) * here_scale[i] * pixels;
        const float to_front = front * spread;
        const float to_own = (1 - front - behind) * spread;
        // Seen through the pixel's own rim, or spread as far as that: the wider of the two.
        const float to_behind = behind * (scale[i] < here_scale[i] * pixels ? spread : here);
        out.front[0][i] += to_front * red[i];
        out.front[1][i] += to_front * green[i];
        out.front[2][i] += to_front * blue[i];
        out.front[3][i] += to_front;
        out.own[0][i] += to_own * red[i];
        out.own[1][i] += to_own * green[i];
        out.own[2][i] += to_own * blue[i];
        out.own[3][i] += to_own;
        out.behind[0][i] += to_behind * red[i];
        out.behind[1][i] += to_behind * green[i];
        out.behind[2][i] += to_behind * blue[i];
        out.behind[3][i] += to_behind;
        out.blocked[i] += front * here;
    }
}

/// The same where all is one layer.
template <class S>
void add_own(const Planes& from, std::ptrdiff_t at, const Tap& tap, Layers& out) {
    const float place = S::place(tap.squared_distance());
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(tap.y) * from.stride + tap.x;
    const float* red = from.radiance[0].data() + at + offset;
    const float* green = from.radiance[1].data() + at + offset;
    const float* blue = from.radiance[2].data() + at + offset;
    const float* shape = from.shape.data() + at + offset;
    const float* scale = from.scale.data() + at + offset;
    for (std::size_t i = 0; i < kStrip; ++i) {
        const float spread = S::weight(place, shape[i]) * scale[i];
        out.own[0][i] += spread * red[i];
        out.own[1][i] += spread * green[i];
        out.own[2][i] += spread * blue[i];
        out.own[3][i] += spread;
    }
}

/// The layers over each other.
Vec3 composed(const Layers& layers, std::size_t i) {
    const auto color = [&](const std::array<Strip, 4>& layer) { return Vec3{layer[0][i], layer[1][i], layer[2][i]}; };
    constexpr float kLittle = 1e-4F;
    const Vec3 own = color(layers.own);
    const float own_weight = layers.own[3][i];
    // Its own layer goes on behind what is before it.
    const float open = std::max(1 - layers.blocked[i], kLittle);
    const float own_share = std::min(own_weight / open, 1.0F);
    const Vec3 under =
        (color(layers.behind) + own * kLittle) / (layers.behind[3][i] + std::max(own_weight, kLittle) * kLittle);
    Vec3 out = own * (own_share / std::max(own_weight, kLittle)) + under * (1 - own_share);
    const float front_weight = layers.front[3][i];
    const float front_share = std::min(front_weight, 1.0F);
    if (front_weight > 0) out = color(layers.front) * (front_share / front_weight) + out * (1 - front_share);
    return out;
}

template <class S>
std::vector<Vec3> blurred(const SharpPicture& picture, const ThinLens& lens, const StopFlag& stop) {
    const Planes planes = planes_of<S>(picture, lens);
    const Squares squares(planes, S::kReach);
    const int columns = (picture.width + kStrip - 1) / kStrip;
    std::vector<Vec3> out(picture.radiance.begin(), picture.radiance.end());
    std::vector<Planes> squared;
    for (std::size_t level = 1; S::kSmooth && level < kSizes.size(); ++level)
        if (planes.margin > kZones_px[level - 1]) squared.push_back(squares_of<S>(planes, kSizes[level]));
    const auto make_strip = [&](int column, int y, const Surroundings& around, const std::vector<Tap>& taps) {
        const int x0 = column * kStrip;
        Layers layers;
        for (const Tap& tap : taps) {
            const Planes& from = tap.size == 1 ? planes : squared[tap.size == 2 ? 0 : 1];
            if (around.one_layer) add_own<S>(from, planes.at(x0, y), tap, layers);
            else add_layers<S>(planes, from, planes.at(x0, y), tap, layers);
        }
        for (int i = 0; i < kStrip && x0 + i < picture.width; ++i)
            out[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(x0 + i)] = composed(layers, static_cast<std::size_t>(i));
    };
    tbb::parallel_for(0, columns * ((picture.height + kStrip - 1) / kStrip), [&](int square) {
        const int column = square % columns, row = square / columns;
        const Surroundings around = squares.around(column, row);
        if (around.reach == 0) return;
        const std::vector<Tap> taps = taps_around(around.reach, S::kSmooth);
        for (int y = row * kStrip; y < std::min((row + 1) * kStrip, picture.height) && !stop.requested(); ++y)
            make_strip(column, y, around, taps);
    });
    if (stop.requested()) return {};
    return out;
}

}  // namespace

float signed_blur_px(const ThinLens& lens, float axis_depth) {
    const float blur = lens.scale_px * (1 / axis_depth - 1 / lens.focus);
    return std::clamp(blur, -kWidestBlur_px, kWidestBlur_px);
}

std::vector<Vec3> lens_blurred(const SharpPicture& picture, const ThinLens& lens, Spread spread, const StopFlag& stop) {
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (picture.width <= 0 || picture.height <= 0 || picture.radiance.size() != pixels ||
        picture.axis_depth.size() != pixels)
        throw std::invalid_argument("lens_blurred: a plane is not of the picture's size");
    return spread == Spread::disc ? blurred<Disc>(picture, lens, stop) : blurred<Gaussian>(picture, lens, stop);
}

}  // namespace sundog::postprocess
