// SPDX-License-Identifier: Apache-2.0
// Focal blur (POV-Ray reference, section 3.4.2.3): rays start all over a lens and meet in the plane in focus. How large
// the lens is, how 4, 7, 19 and 37 samples are laid out, and when a pixel has enough of them is as POV-Ray 3.7's
// pictures and its counts of rays show.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "compile/camera.h"
#include "compile/quantile.h"
#include "fields/pigment_evaluator.h"
#include "kernel/cameras/projections.h"
#include "kernel/patterns/noise.h"

namespace sundog {
namespace {

/// A number in [0, 1) from a hash.
float unit(std::uint32_t hash) { return static_cast<float>(hash >> 8U) * 0x1p-24F; }

/// Element `i` of the additive sequence of `step` (a fraction of 2^32) that starts at `start`.
float in_sequence(std::uint32_t start, std::uint32_t step, std::uint32_t i) { return unit(start + step * i); }

// The plastic number's powers fill the square evenly, those of the root of x^4 = x + 1 the cube (Roberts 2018).
constexpr std::uint32_t kPlane1 = 0xc13fa9a9U, kPlane2 = 0x91e10da5U;
constexpr std::uint32_t kSpace1 = 0xd1b54a33U, kSpace2 = 0xabc98388U;

/// Places on a lens of radius 1, each of them the middle of a square.
struct Cells {
    std::vector<Vec2> places;
    float side = 0;
};

/// Hexagonal rings around a middle, as many as make the number of samples, or a square of four.
Cells cells_of(int samples) {
    if (samples == 4) return {{{-0.5F, 0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, -0.5F}}, 1};
    if (samples != 7 && samples != 19 && samples != 37) return {};
    const int rings = samples == 7 ? 1 : samples == 19 ? 2 : 3;
    const float row = 1.0F / static_cast<float>(rings + 1);
    const float column = row * 2 / std::numbers::sqrt3_v<float>;
    std::vector<Vec2> places;
    for (int y = -rings; y <= rings; ++y) {
        const int count = 2 * rings + 1 - std::abs(y);
        for (int x = 0; x < count; ++x)
            places.push_back(
                {(static_cast<float>(x) - static_cast<float>(count - 1) / 2) * column, static_cast<float>(y) * row});
    }
    // A pixel that gets along with few of them has these from all sides: 5 divides none of 7, 19 and 37.
    Cells cells{{}, column};
    for (std::size_t i = 0; i < places.size(); ++i) cells.places.push_back(places[i * 5 % places.size()]);
    return cells;
}

/// The unit square onto the unit disc, areas keeping their shares (Shirley and Chiu 1997).
Vec2 on_disc(float u, float v) {
    const float a = 2 * u - 1;
    const float b = 2 * v - 1;
    if (a == 0 && b == 0) return {0, 0};
    constexpr float kQuarter = std::numbers::pi_v<float> / 4;
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    const float angle = wide ? kQuarter * b / a : 2 * kQuarter - kQuarter * a / b;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Places on a lens that is brighter in places: the square's part of each is as large as its share of the light.
class Brightness {
public:
    explicit Brightness(const scene::Pigment& pigment, std::span<const scene::Texture> textures) {
        const std::shared_ptr<const scene::Pigment> alone(std::shared_ptr<const void>{}, &pigment);
        const fields::PigmentEvaluator evaluator(std::span(&alone, 1), textures);
        double total = 0;
        for (int row = 0; row < kSide; ++row) {
            double sum = 0;
            for (int column = 0; column < kSide; ++column) {
                const auto c = evaluator.color(0, (column + 0.5) / kSide, (row + 0.5) / kSide, 0);
                const auto part = [&](std::size_t i) { return static_cast<float>(c[i]); };
                sum += std::max(0.0F, kernel::gray_of({part(0), part(1), part(2)}));
                up_to_column_[index(row, column)] = static_cast<float>(sum);
            }
            total += sum;
            up_to_row_[static_cast<std::size_t>(row)] = static_cast<float>(total);
        }
    }
    /// Whether there is any light.
    [[nodiscard]] bool some() const { return up_to_row_.back() > 0; }
    /// In [-1, 1] each.
    [[nodiscard]] Vec2 place(float u, float v) const {
        const float y = inverted(std::span(up_to_row_), v);
        const auto row = std::min(static_cast<std::size_t>(y), up_to_row_.size() - 1);
        const float x = inverted(std::span(up_to_column_).subspan(row * kSide, kSide), u);
        return {x * (2.0F / kSide) - 1, y * (2.0F / kSide) - 1};
    }

private:
    static constexpr int kSide = 128;
    static std::size_t index(int row, int column) {
        return static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column);
    }
    static float inverted(std::span<const float> sums, float share) {
        const float wanted = share * sums.back();
        auto found = static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), wanted) - sums.begin());
        found = std::min(found, sums.size() - 1);
        const float before = found == 0 ? 0 : sums[found - 1];
        const float width = sums[found] - before;
        return static_cast<float>(found) + (width > 0 ? std::clamp((wanted - before) / width, 0.0F, 1.0F) : 0.5F);
    }
    std::array<float, kSide> up_to_row_{};
    std::array<float, std::size_t{kSide} * kSide> up_to_column_{};
};

class LensCamera final : public CameraRays {
public:
    LensCamera(const scene::ProjectionCamera& camera, std::span<const scene::Texture> textures)
        : blur_(camera.blur),
          cells_(cells_of(blur_.most_samples)),
          radius_(static_cast<float>(blur_.aperture / 4)),
          doubt_(normal_quantile(1 - std::clamp(blur_.confidence, 0.0, 1 - 1e-9))) {
        const Vec3d forward = normalize(camera.direction);
        right_ = to_float(normalize(camera.right));
        up_ = to_float(normalize(camera.up));
        forward_ = to_float(forward);
        focus_ = static_cast<float>(std::abs(dot(blur_.focal_point - camera.location, forward)));
        if (blur_.bokeh) {
            brightness_.emplace(*blur_.bokeh, textures);
            if (!brightness_->some()) brightness_.reset();
        }
    }

    [[nodiscard]] std::uint32_t most_rays() const override { return static_cast<std::uint32_t>(blur_.most_samples); }
    [[nodiscard]] std::uint32_t least_rays() const override { return static_cast<std::uint32_t>(blur_.least_samples); }

    /// The true variance is with `confidence` not larger than that of the samples times f/q, where f = n - 1 and q is
    /// the chi-squared distribution's quantile (Wilson and Hilferty 1931). Of the mean of n samples it is the n-th
    /// part; the pixel has enough where that is under the asked for one times the share n/most of samples spent.
    [[nodiscard]] float enough_variance(std::uint32_t rays) const override {
        const double n = rays;
        const double spread = 2 / (9 * (n - 1));
        const double quantile = std::max(1 - spread + doubt_ * std::sqrt(spread), 0.0);
        return static_cast<float>(blur_.variance * n * n / blur_.most_samples * quantile * quantile * quantile);
    }

    [[nodiscard]] std::optional<Ray> ray(const kernel::FrameParams& frame, const Place& place) const override {
        const std::uint32_t pixel =
            kernel::hash_word(kernel::hash_word(kernel::hash_word(place.sample) + place.y) + place.x);
        const std::uint32_t other = kernel::hash_word(pixel ^ 0x9e3779b9U);
        const std::uint32_t third = kernel::hash_word(other);
        // Anywhere in a pixel's square around the sample's place.
        const float px = in_sequence(third, kSpace1, place.ray) - 0.5F;
        const float py = in_sequence(kernel::hash_word(third), kSpace2, place.ray) - 0.5F;
        const kernel::Ray chief =
            kernel::camera_ray(frame, (static_cast<float>(place.x) + place.dx + px) / static_cast<float>(frame.width),
                               (static_cast<float>(place.y) + place.dy + py) / static_cast<float>(frame.height));
        if (!(chief.t_max > chief.t_min)) return std::nullopt;
        const Vec3 origin{chief.origin.x, chief.origin.y, chief.origin.z};
        const Vec3 direction{chief.direction.x, chief.direction.y, chief.direction.z};
        const Vec2 lens = on_lens(pixel, other, place.ray);
        const Vec3 start = origin + right_ * lens.x + up_ * lens.y;
        // Cameras that see in all directions are in focus at a distance.
        const bool flat =
            frame.camera_kind == kernel::CAMERA_PERSPECTIVE || frame.camera_kind == kernel::CAMERA_ORTHOGRAPHIC;
        const float along = flat ? dot(direction, forward_) : 1;
        const Vec3 focused = origin + direction * (focus_ / along);
        const Vec3 way = focused - start;
        return Ray{start, dot(way, way) > 0 ? normalize(way) : direction, chief.t_max};
    }

private:
    /// Where ray `i` starts, from the middle of the lens.
    [[nodiscard]] Vec2 on_lens(std::uint32_t start1, std::uint32_t start2, std::uint32_t i) const {
        const Vec2 place = on_unit_lens(start1, start2, i);
        return {place.x * radius_, place.y * radius_};
    }
    [[nodiscard]] Vec2 on_unit_lens(std::uint32_t start1, std::uint32_t start2, std::uint32_t i) const {
        const float u = in_sequence(start1, kPlane1, i);
        const float v = in_sequence(start2, kPlane2, i);
        if (brightness_) return brightness_->place(u, v);
        if (cells_.places.empty()) return on_disc(u, v);
        // Anywhere in a cell; each pixel begins with another one.
        const Vec2 cell = cells_.places[(i + start1 % cells_.places.size()) % cells_.places.size()];
        const std::uint32_t hash = kernel::hash_word(start1 + i * 0x9e3779b9U);
        return {cell.x + (unit(hash) - 0.5F) * cells_.side,
                cell.y + (unit(kernel::hash_word(hash)) - 0.5F) * cells_.side};
    }

    scene::FocalBlur blur_;
    Cells cells_;
    float radius_ = 0, focus_ = 0;
    double doubt_ = 0;
    Vec3 right_, up_, forward_;
    std::optional<Brightness> brightness_;
};

}  // namespace

std::shared_ptr<const CameraRays> make_lens_camera(const scene::ProjectionCamera& camera,
                                                   std::span<const scene::Texture> textures) {
    return std::make_shared<LensCamera>(camera, textures);
}

}  // namespace sundog
