// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_normal.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "import/pov/build_image.h"
#include "import/pov/build_pigment.h"

namespace sundog::pov {
namespace {

using scene::Normal;
using scene::PatternNormal;
using scene::Pigment;
using scene::PigmentColor;

PigmentColor gray(double value) {
    const auto v = static_cast<float>(value);
    return {v, v, v, 0, 0};
}

/// Patterns with formulas of their own.
std::optional<PatternNormal::Kind> special_kind(scene::Pattern::Kind kind) {
    switch (kind) {
        case scene::Pattern::Kind::bumps:
            return PatternNormal::Kind::bumps;
        case scene::Pattern::Kind::dents:
            return PatternNormal::Kind::dents;
        case scene::Pattern::Kind::wrinkles:
            return PatternNormal::Kind::wrinkles;
        case scene::Pattern::Kind::ripples:
            return PatternNormal::Kind::ripples;
        case scene::Pattern::Kind::waves:
            return PatternNormal::Kind::waves;
        case scene::Pattern::Kind::quilted:
        case scene::Pattern::Kind::facets:
            return PatternNormal::Kind::special;
        default:
            return std::nullopt;
    }
}

/// Where a slope_map's curve passes, and how steep.
struct SlopeEntry {
    double at = 0, height = 0, slope = 0;
};

/// The cubic curve through a slope_map's entries, whose slopes count from one entry to the next, as heights close
/// enough together to look smooth.
PigmentEntries heights_of(std::vector<SlopeEntry> slopes) {
    constexpr int kSteps = 16;
    std::stable_sort(slopes.begin(), slopes.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    PigmentEntries heights;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const SlopeEntry& a = slopes[i];
        heights.push_back({static_cast<float>(a.at), gray(a.height), nullptr});
        if (i + 1 == slopes.size() || slopes[i + 1].at <= a.at) continue;
        const SlopeEntry& b = slopes[i + 1];
        const double width = b.at - a.at;
        for (int step = 1; step < kSteps; ++step) {
            const double t = static_cast<double>(step) / kSteps;
            const double h = (1 + 2 * t) * (1 - t) * (1 - t) * a.height + t * (1 - t) * (1 - t) * a.slope +
                             t * t * (3 - 2 * t) * b.height - t * t * (1 - t) * b.slope;
            heights.push_back({static_cast<float>(a.at + t * width), gray(h), nullptr});
        }
    }
    return heights;
}

/// Whether a pattern's turbulence is part of its slope. Others only have it moved.
bool is_stirred_inside(scene::Pattern::Kind kind) {
    return kind == scene::Pattern::Kind::marble || kind == scene::Pattern::Kind::wood;
}

/// The pattern as heights, at its own points.
std::shared_ptr<const Pigment> height_of(const scene::Pattern& pattern, PigmentEntries heights, SourceLocation where) {
    auto pigment = std::make_shared<Pigment>();
    pigment->where = std::move(where);
    pigment->pattern = pattern;
    pigment->pattern.pattern_from_texture = {};
    pigment->pattern.warps.clear();
    if (!is_stirred_inside(pattern.kind)) pigment->pattern.turbulence = {};
    pigment->entries = std::move(heights);
    const std::size_t choices = choice_count(pattern.kind);
    pigment->kind = choices > 0 ? Pigment::Kind::choice : Pigment::Kind::mapped;
    if (choices > 0) {
        pigment->entries.clear();
        for (std::size_t i = 0; i < choices; ++i)
            pigment->entries.push_back({0, gray(static_cast<double>(i) / static_cast<double>(choices - 1)), nullptr});
    } else if (pigment->entries.empty()) {
        pigment->entries = {{0, gray(0), nullptr}, {1, gray(1), nullptr}};
    }
    return pigment;
}

/// A share that is the same everywhere, of a weight (null: 1).
std::shared_ptr<const Pigment> scaled(const std::shared_ptr<const Pigment>& weight, double share) {
    auto pigment = std::make_shared<Pigment>();
    if (!weight) {
        pigment->color = gray(share);
        return pigment;
    }
    pigment->kind = Pigment::Kind::mapped;
    pigment->pattern.kind = scene::Pattern::Kind::average;
    pigment->entries = {{static_cast<float>(1 - share), gray(0), nullptr}, {static_cast<float>(share), {}, weight}};
    return pigment;
}

class NormalReader {
public:
    NormalReader(BuildContext& context, const Block& block, const NormalPointer& entry_start)
        : context_(context), block_(block), entry_start_(entry_start) {}

    NormalPointer read(const NormalPointer& start) {
        if (start && start->parts.size() == 1 && !start->parts[0].weight) {
            // Another pattern takes over what was said of the first: its amount, its place, its waves.
            parts_.pattern = start->parts[0].pattern;
            start_amount_ = start->parts[0].amount;
        }
        read_items(block_);
        Normal result;
        if (image_) {
            result.parts.push_back(image_part());
        } else if (!parts_.given) {
            if (!start && !amount_) return nullptr;
            if (start) result = *start;
            else result.parts.push_back(part()), result.parts[0].kind = PatternNormal::Kind::pattern;
            for (PatternNormal& part : result.parts) {
                if (amount_) part.amount = *amount_;
                part.keeps_depth |= keeps_depth_;
            }
        } else if (!entries_.empty()) {
            const NormalPointer blended = blend_normals(parts_.pattern, entries_);
            if (!blended) return nullptr;
            result = *blended;
            for (PatternNormal& part : result.parts) part.keeps_depth |= keeps_depth_;
        } else {
            result.parts.push_back(pattern_part());
        }
        result.uv_mapping |= uv_mapping_;
        place(
            parts_, [&](const Affine3d& old_from_new) { move_normal(result, old_from_new); },
            [&](const scene::Warp& warp) { bend_normal(result, warp); });
        return std::make_shared<const Normal>(std::move(result));
    }

private:
    void read_items(const Block& block) {
        ItemReader items(context_, block);
        while (!items.at_end()) {
            if (const auto base = items.take_block(Keyword::normal)) {
                read_items(*base);
            } else if (const auto image = items.take_block(Keyword::bump_map)) {
                read_bump_map(*image);
            } else if (const auto map = items.take_block(Keyword::normal_map)) {
                entries_.clear();
                read_normal_map(*map);
            } else if (const auto slopes = items.take_block(Keyword::slope_map)) {
                slopes_.clear();
                read_slope_map(*slopes);
            } else if (items.take(Keyword::bump_size)) {
                amount_ = static_cast<float>(items.number("a bump_size"));
            } else if (items.take(Keyword::accuracy)) {
                accuracy_ = items.number("an accuracy");
                if (!(accuracy_ > 0)) items.fail("an accuracy that isn't above 0", "expected a distance such as 0.02");
            } else if (items.take(Keyword::no_bump_scale)) {
                keeps_depth_ = items.flag();
            } else if (items.take(Keyword::uv_mapping)) {
                uv_mapping_ = items.flag();
            } else if (!(image_ && read_image_modifier(items, *image_))) {
                read_pattern(items);
            }
        }
    }

    void read_pattern(ItemReader& items) {
        const bool given = parts_.given;
        parts_.given = false;
        if (!read_pattern_item(items, parts_)) {
            static constexpr std::array kValid{Keyword::bump_map,  Keyword::normal_map, Keyword::slope_map,
                                               Keyword::bump_size, Keyword::accuracy,   Keyword::bumps,
                                               Keyword::dents,     Keyword::ripples,    Keyword::waves,
                                               Keyword::wrinkles,  Keyword::turbulence, Keyword::translate,
                                               Keyword::rotate,    Keyword::scale,      Keyword::no_bump_scale};
            items.unexpected(kValid, "a pattern or a pattern's modifier");
        }
        if (parts_.given) {
            entries_.clear(), slopes_.clear(), image_.reset();
            if (const auto amount = items.maybe_number()) amount_ = static_cast<float>(*amount);
            if (const auto list = std::exchange(parts_.list, nullptr)) {
                ItemReader inside(context_, *list);
                read_choices(inside);
            } else {
                read_choices(items);
            }
        }
        parts_.given |= given;
    }

    [[nodiscard]] NormalPointer read_entry(const Block& block) const {
        return read_normal(context_, block, entry_start_, entry_start_);
    }

    void read_choices(ItemReader& items) {
        const std::size_t count = choice_count(parts_.pattern.kind);
        while (entries_.size() < count) {
            const auto block = items.take_block(Keyword::normal);
            if (!block) break;
            entries_.push_back({0, read_entry(*block)});
        }
    }

    void read_bump_map(const Block& block) {
        Block image = block;
        image.items.clear();
        ItemReader items(context_, block);
        while (!items.at_end()) {
            if (items.take(Keyword::bump_size)) {
                amount_ = static_cast<float>(items.number("a bump_size"));
            } else {
                image.items.push_back(*items.peek());
                items.skip();
            }
        }
        image_ = read_image_map(context_, image, ImageUse::data);
    }

    void read_normal_map(const Block& block) {
        ItemReader items(context_, block);
        while (!items.at_end()) {
            if (const auto base = items.take_block(Keyword::normal_map)) {
                read_normal_map(*base);
                continue;
            }
            const auto row = items.take_row();
            if (!row) items.unexpected("a row in square brackets");
            ItemReader inside(context_, *row, Keyword::normal_map);
            const auto at = inside.maybe_number();
            const Block normal = block_of_row(*row, at ? 1 : 0, Keyword::normal, block_);
            entries_.push_back({at.value_or(1), read_entry(normal)});
        }
    }

    void read_slope_map(const Block& block) {
        ItemReader items(context_, block);
        while (!items.at_end()) {
            if (const auto base = items.take_block(Keyword::slope_map)) {
                read_slope_map(*base);
                continue;
            }
            const auto row = items.take_row();
            if (!row) items.unexpected("a row in square brackets");
            ItemReader inside(context_, *row, Keyword::slope_map);
            const double at = inside.number("the place of a slope in its map");
            const std::array<double, 2> slope = inside.vector2("a height and a slope");
            slopes_.push_back({at, slope[0], slope[1]});
        }
    }

    [[nodiscard]] PatternNormal part() const {
        PatternNormal part;
        part.where = context_.location(block_.where);
        part.pattern = parts_.pattern;
        part.amount = amount_.value_or(start_amount_);
        part.accuracy = accuracy_;
        part.keeps_depth = keeps_depth_;
        return part;
    }

    [[nodiscard]] PatternNormal image_part() const {
        PatternNormal result = part();
        result.kind = PatternNormal::Kind::image;
        auto height = std::make_shared<Pigment>();
        height->where = context_.location(block_.where);
        height->kind = Pigment::Kind::image;
        height->image = *image_;
        result.height = std::move(height);
        const scene::Texture& texture = context_.scene.textures[image_->texture];
        result.texel_u = 1.0 / std::max(texture.width, 1U);
        result.texel_v = 1.0 / std::max(texture.height, 1U);
        return result;
    }

    [[nodiscard]] PatternNormal pattern_part() const {
        PatternNormal result = part();
        const auto special = special_kind(parts_.pattern.kind);
        result.kind = special.value_or(PatternNormal::Kind::pattern);
        if (!special) {
            result.height = height_of(parts_.pattern, heights_of(slopes_), context_.location(block_.where));
            if (is_stirred_inside(result.pattern.kind)) result.pattern.turbulence = {};
        }
        return result;
    }

    BuildContext& context_;
    const Block& block_;
    PatternParts parts_;
    std::optional<scene::ImageMap> image_;
    std::vector<NormalEntry> entries_;
    std::vector<SlopeEntry> slopes_;
    const NormalPointer& entry_start_;
    std::optional<float> amount_;
    float start_amount_ = 0.5F;
    double accuracy_ = 0.02;
    bool keeps_depth_ = false, uv_mapping_ = false;
};

}  // namespace

void move_normal(Normal& normal, const Affine3d& old_from_new) {
    if (old_from_new == Affine3d{}) return;
    for (PatternNormal& part : normal.parts) {
        part.pattern.move(old_from_new);
        if (!part.weight) continue;
        auto moved = std::make_shared<Pigment>(*part.weight);
        move_pigment(*moved, old_from_new);
        part.weight = std::move(moved);
    }
}

void bend_normal(Normal& normal, const scene::Warp& warp) {
    for (PatternNormal& part : normal.parts) {
        part.pattern.bend(warp);
        if (!part.weight) continue;
        auto bent = std::make_shared<Pigment>(*part.weight);
        bend_pigment(*bent, warp);
        part.weight = std::move(bent);
    }
}

NormalPointer blend_normals(const scene::Pattern& pattern, std::vector<NormalEntry> entries) {
    if (std::none_of(entries.begin(), entries.end(),
                     [](const NormalEntry& e) { return e.normal && !e.normal->is_flat(); }))
        return nullptr;
    const bool choice = choice_count(pattern.kind) > 0;
    const bool average = pattern.kind == scene::Pattern::Kind::average;
    if (!choice && !average)
        std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    double total = 0;
    for (const NormalEntry& entry : entries) total += entry.at;
    Normal result;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        Normal own;
        if (entries[i].normal && !entries[i].normal->is_flat()) own = *entries[i].normal;
        else own.parts.emplace_back().amount = 0;
        result.uv_mapping |= own.uv_mapping;
        for (PatternNormal& part : own.parts) {
            if (average) {
                part.weight = scaled(part.weight, total > 0 ? entries[i].at / total : 0);
            } else {
                auto weight = std::make_shared<Pigment>();
                weight->kind = choice ? Pigment::Kind::choice : Pigment::Kind::mapped;
                weight->pattern = pattern;
                for (std::size_t k = 0; k < entries.size(); ++k)
                    weight->entries.push_back(
                        {static_cast<float>(entries[k].at), gray(k == i ? 1 : 0), k == i ? part.weight : nullptr});
                part.weight = std::move(weight);
            }
            result.parts.push_back(std::move(part));
        }
    }
    return std::make_shared<const Normal>(std::move(result));
}

NormalPointer read_normal(BuildContext& context, const Block& block, const NormalPointer& start,
                          const NormalPointer& entry_start) {
    return NormalReader(context, block, entry_start).read(start);
}

}  // namespace sundog::pov
