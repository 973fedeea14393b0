// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_media.h"

#include <algorithm>
#include <array>

#include "import/pov/build_pigment.h"
#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

using scene::Medium;

Vec3 rgb_of(const scene::PigmentColor& c) { return {c.r, c.g, c.b}; }

/// A density's block as a pigment's: they have the same items under other names.
Block as_pigment(const Block& density);

std::vector<Item> as_pigment(const std::vector<Item>& items) {
    std::vector<Item> renamed = items;
    for (Item& item : renamed) {
        if (auto* block = std::get_if<std::shared_ptr<const Block>>(&item.content)) {
            const Keyword keyword = (*block)->keyword;
            if (keyword == Keyword::density || keyword == Keyword::density_map)
                *block = std::make_shared<const Block>(as_pigment(**block));
        } else if (auto* row = std::get_if<std::shared_ptr<const Row>>(&item.content)) {
            *row = std::make_shared<const Row>(Row{(*row)->where, as_pigment((*row)->items)});
        }
    }
    return renamed;
}

Block as_pigment(const Block& density) {
    Block pigment = density;
    pigment.keyword = density.keyword == Keyword::density_map ? Keyword::pigment_map : Keyword::pigment;
    pigment.items = as_pigment(density.items);
    return pigment;
}

void move_densities(Medium& medium, const Affine3d& old_from_new) {
    for (auto& density : medium.densities) {
        auto moved = std::make_shared<scene::Pigment>(*density);
        move_pigment(*moved, old_from_new);
        density = std::move(moved);
    }
}

class MediumReader {
public:
    MediumReader(BuildContext& context, const Block& block) : context_(context), items_(context, block) {
        medium_.where = context.location(block.where);
    }

    Medium read() {
        while (!items_.at_end()) {
            Affine3d moved;
            if (const auto base = items_.take_block(Keyword::media)) {
                const SourceLocation where = medium_.where;
                medium_ = read_medium(context_, *base);
                medium_.where = where;
            } else if (const auto density = items_.take_block(Keyword::density)) {
                read_density(*density);
            } else if (const auto scattering = items_.take_block(Keyword::scattering)) {
                read_scattering(*scattering);
            } else if (read_transform(items_, moved)) {
                move_densities(medium_, inverse(moved));
            } else if (!read_color() && !read_sampling()) {
                static constexpr std::array kValid{
                    Keyword::absorption, Keyword::emission, Keyword::scattering,   Keyword::density,  Keyword::method,
                    Keyword::intervals,  Keyword::samples,  Keyword::confidence,   Keyword::variance, Keyword::ratio,
                    Keyword::jitter,     Keyword::aa_level, Keyword::aa_threshold, Keyword::collect};
                items_.unexpected(kValid);
            }
        }
        return std::move(medium_);
    }

private:
    void read_density(const Block& block) {
        const Block pigment = as_pigment(block);
        // A density that says nothing is 1 everywhere.
        scene::Pigment one;
        one.color = {1, 1, 1, 0, 0};
        medium_.densities.push_back(
            std::make_shared<const scene::Pigment>(read_pigment(context_, pigment, std::move(one))));
    }

    void read_scattering(const Block& block) {
        ItemReader items(context_, block);
        medium_.scattering_type = items.integer("a scattering type from 1 to 5", 1, 5);
        medium_.scattering = rgb_of(items.color("a color"));
        while (!items.at_end()) {
            if (items.take(Keyword::eccentricity)) {
                medium_.eccentricity =
                    std::clamp(static_cast<float>(items.number("an eccentricity")), -0.9999F, 0.9999F);
            } else if (items.take(Keyword::extinction)) {
                medium_.extinction = static_cast<float>(items.number("an extinction"));
            } else {
                static constexpr std::array kValid{Keyword::eccentricity, Keyword::extinction};
                items.unexpected(kValid);
            }
        }
    }

    bool read_color() {
        if (items_.take(Keyword::absorption)) {
            medium_.absorption = rgb_of(items_.color("a color"));
        } else if (items_.take(Keyword::emission)) {
            medium_.emission = rgb_of(items_.color("a color"));
        } else {
            return false;
        }
        return true;
    }

    bool read_sampling() {
        constexpr int kMost = 10000;
        if (items_.take(Keyword::method)) {
            medium_.method = items_.integer("a method from 1 to 3", 1, 3);
        } else if (items_.take(Keyword::intervals)) {
            medium_.intervals = items_.integer("a number of intervals", 1, kMost);
        } else if (items_.take(Keyword::samples)) {
            medium_.samples = items_.integer("the least number of samples", 1, kMost);
            medium_.samples_most = medium_.samples;
            if (items_.number_follows())
                medium_.samples_most =
                    std::max(items_.integer("the greatest number of samples", 1, kMost), medium_.samples);
        } else if (items_.take(Keyword::aa_level)) {
            medium_.aa_level = items_.integer("a level", 1, 1000);
        } else if (items_.take(Keyword::aa_threshold)) {
            medium_.aa_threshold = static_cast<float>(items_.number("a threshold"));
        } else if (items_.take(Keyword::jitter)) {
            medium_.jitter = static_cast<float>(items_.maybe_number().value_or(1));
        } else if (items_.take(Keyword::ratio)) {
            medium_.ratio = static_cast<float>(items_.number("a ratio"));
        } else if (items_.take(Keyword::collect)) {
            medium_.collects_photons = items_.flag();
        } else if (items_.take(Keyword::confidence)) {
            medium_.confidence = static_cast<float>(items_.number("a confidence"));
        } else if (items_.take(Keyword::variance)) {
            medium_.variance = static_cast<float>(items_.number("a variance"));
        } else {
            return false;
        }
        return true;
    }

    BuildContext& context_;
    ItemReader items_;
    Medium medium_;
};

}  // namespace

Medium read_medium(BuildContext& context, const Block& block) { return MediumReader(context, block).read(); }

void move_interior(scene::Interior& interior, const Affine3d& old_from_new) {
    if (!interior.media || old_from_new == Affine3d{}) return;
    auto moved = std::make_shared<std::vector<Medium>>(*interior.media);
    for (Medium& medium : *moved) move_densities(medium, old_from_new);
    interior.media = std::move(moved);
}

}  // namespace sundog::pov
