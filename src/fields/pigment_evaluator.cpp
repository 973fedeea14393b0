// SPDX-License-Identifier: Apache-2.0
#include "fields/pigment_evaluator.h"

#include <algorithm>
#include <cmath>

#include "base/srgb.h"
#include "fields/pigment_code.h"
#include "fields/pigment_lanes.h"
#include "fields/slope_limits.h"
#include "kernel/patterns/program.h"

namespace sundog::fields {
namespace {

using Ranges = std::array<std::array<double, 2>, 5>;

void include(Ranges& ranges, const std::array<double, 5>& color) {
    for (std::size_t i = 0; i < 5; ++i) {
        ranges[i][0] = std::min(ranges[i][0], color[i]);
        ranges[i][1] = std::max(ranges[i][1], color[i]);
    }
}

void include(Ranges& ranges, const scene::PigmentColor& c) {
    include(ranges, std::array<double, 5>{c.r, c.g, c.b, c.filter, c.transmit});
}

/// All colours that a pigment can show: they are mixed from those that it names.
void include(Ranges& ranges, const scene::Pigment& pigment) {
    switch (pigment.kind) {
        case scene::Pigment::Kind::solid:
            include(ranges, pigment.color);
            return;
        case scene::Pigment::Kind::image:
            include(ranges, scene::PigmentColor{});
            include(ranges, scene::PigmentColor{1, 1, 1, 1, 1});
            return;
        default:
            // Before the first and after the last entry there is nothing but them; an empty map is black.
            if (pigment.entries.empty()) include(ranges, scene::PigmentColor{});
            for (const scene::PigmentEntry& entry : pigment.entries) {
                if (entry.pigment) include(ranges, *entry.pigment);
                else include(ranges, entry.color);
            }
    }
}

/// Far beyond what single precision can tell apart; so that what is no number has a colour, too.
kernel::vec3 kept(Vec3d p) {
    const auto kept_one = [](double v) { return static_cast<float>(v > -1e12 ? std::min(v, 1e12) : -1e12); };
    return {kept_one(p.x), kept_one(p.y), kept_one(p.z)};
}

}  // namespace

PigmentEvaluator::PigmentEvaluator(std::span<const std::shared_ptr<const scene::Pigment>> pigments,
                                   std::span<const scene::Texture> textures)
    : host_(textures) {
    for (const auto& pigment : pigments) {
        starts_.push_back(static_cast<std::uint32_t>(code_.size()));
        write_pigment_code(*pigment, code_, host_);
        keep_images(*pigment, textures);
        Ranges ranges;
        ranges.fill({INFINITY, -INFINITY});
        include(ranges, *pigment);
        // The kernel's rounding in mixing.
        for (auto& range : ranges) {
            const double slack = 1e-5 * std::max(std::abs(range[0]), std::abs(range[1]));
            range[0] -= slack, range[1] += slack;
        }
        ranges_.push_back(ranges);
        slope_limits_.push_back(pigment_slope_limit(*pigment));
    }
}

void PigmentEvaluator::keep_images(const scene::Pigment& pigment, std::span<const scene::Texture> textures) {
    for (const scene::PigmentEntry& entry : pigment.entries)
        if (entry.pigment) keep_images(*entry.pigment, textures);
    if (pigment.pattern.pigment) keep_images(*pigment.pattern.pigment, textures);
    if (pigment.kind != scene::Pigment::Kind::image) return;
    if (infos_.size() <= pigment.image.texture) infos_.resize(pigment.image.texture + std::size_t{1});
    kernel::TextureInfo& info = infos_[pigment.image.texture];
    if (info.width != 0) return;
    if (pigment.image.texture >= textures.size() || textures[pigment.image.texture].rgba8.empty()) {
        info = {static_cast<std::uint32_t>(texels_.size()), 1, 1, 0};
        texels_.push_back(0xff000000U);
        return;
    }
    const scene::Texture& texture = textures[pigment.image.texture];
    info = {static_cast<std::uint32_t>(texels_.size()), texture.width, texture.height,
            texture.srgb ? kernel::TEXTURE_SRGB : 0U};
    texels_.insert(texels_.end(), texture.rgba8.begin(), texture.rgba8.end());
}

kernel::SceneView PigmentEvaluator::view() const {
    kernel::SceneView view{};
    view.code = code_.data();
    view.host_fields = &host_;
    view.textures = infos_.data();
    view.texels = texels_.data();
    view.tables = linear_of_srgb8().data();
    return view;
}

std::array<double, 5> PigmentEvaluator::color(std::uint32_t index, double x, double y, double z) const {
    const kernel::vec3 p = kept({x, y, z});
    const kernel::PigmentColor c = kernel::run_program(view(), starts_[index], kernel::real3(p.x, p.y, p.z));
    return {c.rgb.x, c.rgb.y, c.rgb.z, c.filtered, c.transmitted};
}

std::vector<std::array<double, 5>> PigmentEvaluator::colors(std::uint32_t index, std::span<const Vec3d> points) const {
    std::vector<kernel::vec3> places;
    places.reserve(points.size());
    for (const Vec3d& p : points) places.push_back(kept(p));
    std::vector<std::array<float, 5>> found(points.size());
    const auto run = __builtin_cpu_supports("avx2") ? pigment_colors_8 : pigment_colors_4;
    run(view(), starts_[index], places, found);
    std::vector<std::array<double, 5>> colors;
    colors.reserve(points.size());
    for (const std::array<float, 5>& c : found) colors.push_back({c[0], c[1], c[2], c[3], c[4]});
    return colors;
}

std::array<double, 2> PigmentEvaluator::range(std::uint32_t index, std::uint8_t component) const {
    return ranges_[index][component];
}

}  // namespace sundog::fields
