// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_pigment.h"

#include <algorithm>
#include <array>
#include <utility>

#include "import/pov/build_image.h"

namespace sundog::pov {
namespace {

using scene::Pigment;
using scene::PigmentColor;
using scene::PigmentEntry;

/// What choices have where entries are left out, as pictures of povray 3.7 show it.
PigmentColor default_choice(scene::Pattern::Kind kind, std::size_t index) {
    constexpr PigmentColor kRed{1, 0, 0, 0, 0}, kGreen{0, 1, 0, 0, 0}, kBlue{0, 0, 1, 0, 0}, kYellow{1, 1, 0, 0, 0},
        kCyan{0, 1, 1, 0, 0}, kMagenta{1, 0, 1, 0, 0}, kMortar{0.5F, 0.5F, 0.5F, 0, 0},
        kBrick{0.6F, 0.15F, 0.15F, 0, 0};
    constexpr std::array kTiles{kBlue, kGreen, kRed};
    constexpr std::array kSides{kRed, kGreen, kBlue, kYellow, kCyan, kMagenta};
    if (kind == scene::Pattern::Kind::brick) return index == 0 ? kMortar : kBrick;
    const bool few = kind == scene::Pattern::Kind::checker || kind == scene::Pattern::Kind::hexagon;
    return few ? kTiles[index % kTiles.size()] : kSides[index % kSides.size()];
}

/// The map of a pattern that has none of its own, as pictures of povray 3.7 show it.
PigmentEntries default_map(const scene::Pattern& pattern) {
    const auto entry = [](float at, float r, float g, float b) { return PigmentEntry{at, {r, g, b, 0, 0}, nullptr}; };
    using Kind = scene::Pattern::Kind;
    switch (pattern.kind) {
        case Kind::agate:
            return {entry(0, 1, 1, 1),
                    entry(0.5F, 0.95F, 0.75F, 0.5F),
                    entry(0.5F, 0.9F, 0.7F, 0.5F),
                    entry(0.6F, 0.9F, 0.7F, 0.4F),
                    entry(0.6F, 1, 0.7F, 0.4F),
                    entry(1, 0.6F, 0.3F, 0)};
        case Kind::bozo:
            return {entry(0.4F, 1, 1, 1), entry(0.4F, 0, 1, 0), entry(0.6F, 0, 1, 0),
                    entry(0.6F, 0, 0, 1), entry(0.8F, 0, 0, 1), entry(0.8F, 1, 0, 0)};
        case Kind::marble:
            return {entry(0, 0.9F, 0.8F, 0.8F), entry(0.9F, 0.9F, 0.08F, 0.08F), entry(0.9F, 0, 0, 0)};
        case Kind::radial:
            return {entry(0, 0, 1, 1), entry(0.33333333F, 1, 1, 0), entry(0.66666667F, 1, 0, 1), entry(1, 0, 1, 1)};
        case Kind::wood:
            return {entry(0.6F, 0.666F, 0.312F, 0.2F), entry(0.6F, 0.4F, 0.133F, 0.066F)};
        case Kind::fractal:
            if (pattern.fractal.julia || pattern.fractal.formula != scene::FractalForm::Formula::power) break;
            return {entry(0.001F, 0, 0, 0), entry(0.001F, 0, 1, 1), entry(0.012F, 1, 1, 0), entry(0.015F, 1, 0, 1),
                    entry(0.1F, 0, 1, 1)};
        default:
            break;
    }
    return {entry(0, 0, 0, 0), entry(1, 1, 1, 1)};
}

std::shared_ptr<const Pigment> read_shared(BuildContext& context, const Block& block) {
    return std::make_shared<const Pigment>(read_pigment(context, block, {}));
}

/// `[0.3 rgb 1]`, `[0.3 pigment items]` or the older `[0.3 0.5 color A color B]`.
void read_row(BuildContext& context, const Row& row, const Block& map, PigmentEntries& entries) {
    ItemReader items(context, row, map.keyword);
    if (map.keyword == Keyword::pigment_map) {
        // In an average the number is a weight, which may be left out.
        const std::optional<double> given = items.maybe_number();
        const float at = given ? static_cast<float>(*given) : 1.0F;
        entries.push_back({at, {}, read_shared(context, block_of_row(row, given ? 1 : 0, Keyword::pigment, map))});
        return;
    }
    const auto at = static_cast<float>(items.number("the place of a color in its map"));
    if (!items.number_follows()) {
        entries.push_back({at, items.color("a color"), nullptr});
    } else {
        const double second = items.number("a color");
        if (items.at_end()) {  // [0.3 0.5]: a grey in every component
            const auto gray = static_cast<float>(second);
            entries.push_back({at, {gray, gray, gray, gray, gray}, nullptr});
        } else {
            entries.push_back({at, items.color("a color"), nullptr});
            const PigmentColor end = items.at_end() ? entries.back().color : items.color("a color");
            entries.push_back({static_cast<float>(second), end, nullptr});
        }
    }
    if (!items.at_end()) items.unexpected("']'");
}

PigmentEntries read_map(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    PigmentEntries entries;
    while (!items.at_end()) {
        if (const auto base = items.take_block(block.keyword)) {
            entries = read_map(context, *base);
        } else if (const auto row = items.take_row()) {
            read_row(context, *row, block, entries);
        } else {
            items.unexpected("a row in square brackets");
        }
    }
    if (entries.empty()) context.fail(block.where, "a map without entries", "expected [place color]");
    sort_entries(entries);
    return entries;
}

/// The colours or pigments that follow a pattern which chooses among them.
PigmentEntries read_choices(ItemReader& items, std::size_t count) {
    PigmentEntries entries;
    while (entries.size() < count) {
        if (items.value_follows()) {
            entries.push_back({0, items.color("a color"), nullptr});
        } else if (const auto block = items.take_block(Keyword::pigment)) {
            entries.push_back({0, {}, read_shared(items.context(), *block)});
        } else {
            break;
        }
    }
    return entries;
}

class PigmentReader {
public:
    PigmentReader(BuildContext& context, const Block& block, Pigment start)
        : context_(context), block_(block), items_(context, block), pigment_(std::move(start)) {}

    Pigment read() {
        pigment_.where = context_.location(block_.where);
        while (!items_.at_end()) read_item();
        finish();
        return std::move(pigment_);
    }

private:
    void read_item() {
        if (items_.value_follows()) {
            pigment_.kind = Pigment::Kind::solid;
            pigment_.color = items_.color("a color");
        } else if (const auto base = items_.take_block(Keyword::pigment)) {
            pigment_ = read_pigment(context_, *base, std::move(pigment_));
            parts_.pattern = pigment_.pattern;
        } else if (const auto image = items_.take_block(Keyword::image_map)) {
            filters_.clear();
            pigment_.image = read_image_map(context_, *image, ImageUse::color, &filters_);
            pigment_.kind = Pigment::Kind::image;
        } else if (!read_map_block() && !read_keyword()) {
            unexpected();
        }
    }

    bool read_map_block() {
        for (const Keyword keyword : {Keyword::color_map, Keyword::pigment_map}) {
            if (const auto map = items_.take_block(keyword)) {
                pigment_.entries = read_map(context_, *map);
                map_given_ = true;
                return true;
            }
        }
        return false;
    }

    bool read_keyword() {
        if (items_.take(Keyword::quick_color)) {
            pigment_.quick_color = items_.color("a color");
            return true;
        }
        if (items_.take(Keyword::uv_mapping)) {
            pigment_.uv_mapping = items_.flag();
            return true;
        }
        if (items_.take(Keyword::color)) return true;
        if (pigment_.kind == Pigment::Kind::image && read_image_modifier(items_, pigment_.image, &filters_))
            return true;
        const bool pattern_before = parts_.given;
        parts_.given = false;
        const bool taken = read_pattern_item(items_, parts_);
        if (taken && parts_.given) take_pattern();
        parts_.given |= pattern_before;
        return taken;
    }

    void take_pattern() {
        const std::size_t count = choice_count(parts_.pattern.kind);
        if (count == 0) {
            if (pigment_.kind == Pigment::Kind::choice) pigment_.entries.clear();
            pigment_.kind = Pigment::Kind::mapped;
            return;
        }
        if (const auto list = std::exchange(parts_.list, nullptr)) {
            ItemReader inside(context_, *list);
            set_choices(read_choices(inside, count), count);
        } else {
            set_choices(read_choices(items_, count), count);
        }
    }

    void set_choices(PigmentEntries choices, std::size_t count) {
        while (choices.size() < count)
            choices.push_back({0, default_choice(parts_.pattern.kind, choices.size()), nullptr});
        pigment_.entries = std::move(choices);
        pigment_.kind = Pigment::Kind::choice;
    }

    void finish() {
        pigment_.pattern = parts_.pattern;
        if (map_given_ && pigment_.kind == Pigment::Kind::solid)
            context_.fail(block_.where, "a map without a pattern", "expected a pattern such as gradient or bozo");
        if (pigment_.kind == Pigment::Kind::mapped && pigment_.entries.empty())
            pigment_.entries = default_map(pigment_.pattern);
        if (pigment_.kind == Pigment::Kind::image && !filters_.empty()) choose_by_palette();
        place(
            parts_, [this](const Affine3d& old_from_new) { move_pigment(pigment_, old_from_new); },
            [this](const scene::Warp& warp) { bend_pigment(pigment_, warp); });
    }

    /// Where entries of the palette have filters of their own, the number of the palette chooses among images.
    void choose_by_palette() {
        const scene::Index numbers = numbered_texture(context_, pigment_.image.texture);
        if (numbers == pigment_.image.texture) {
            context_.warn_once("filter without palette", block_.where, "the filter of a palette's entry has no effect",
                               "only PNG files with a palette are read as such");
            return;
        }
        auto number = std::make_shared<Pigment>();
        number->where = pigment_.where;
        number->kind = Pigment::Kind::image;
        number->image = {numbers, pigment_.image.map_type, pigment_.image.once, false, 0, 0};
        constexpr int kMostColors = 256;
        const int count = std::min(filters_.rbegin()->first + 2, kMostColors);  // One for all that follow.
        std::vector<scene::PigmentEntry> entries;
        for (int i = 0; i < count; ++i) {
            auto entry = std::make_shared<Pigment>(pigment_);
            const auto filter = filters_.find(static_cast<std::uint8_t>(i));
            if (filter != filters_.end()) entry->image.filter_all = filter->second;
            entries.push_back({0, {}, std::move(entry)});
        }
        pigment_.kind = Pigment::Kind::choice;
        pigment_.entries = std::move(entries);
        pigment_.pattern.kind = scene::Pattern::Kind::material;
        pigment_.pattern.choices = count;
        pigment_.pattern.pigment = std::move(number);
    }

    [[noreturn]] void unexpected() {
        static constexpr std::array kValid{
            Keyword::color_map, Keyword::pigment_map, Keyword::image_map,  Keyword::quick_color, Keyword::checker,
            Keyword::hexagon,   Keyword::brick,       Keyword::square,     Keyword::triangular,  Keyword::gradient,
            Keyword::frequency, Keyword::phase,       Keyword::turbulence, Keyword::uv_mapping,  Keyword::translate,
            Keyword::rotate,    Keyword::scale,       Keyword::matrix,     Keyword::warp};
        items_.unexpected(kValid, "a color, a pattern or a pattern's modifier");
    }

    BuildContext& context_;
    const Block& block_;
    ItemReader items_;
    Pigment pigment_;
    PatternParts parts_{pigment_.pattern, false, nullptr, {}, {}};
    bool map_given_ = false;
    PaletteFilters filters_;
};

/// Changes a pigment's own pigments, those that lie anywhere in particular.
template <class Change>
void for_entries(Pigment& pigment, Change change) {
    for (PigmentEntry& entry : pigment.entries) {
        if (!entry.pigment || !is_positional(*entry.pigment)) continue;
        auto changed = std::make_shared<Pigment>(*entry.pigment);
        change(*changed);
        entry.pigment = std::move(changed);
    }
}

}  // namespace

void sort_entries(PigmentEntries& entries) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const PigmentEntry& a, const PigmentEntry& b) { return a.at < b.at; });
}

void move_pigment(Pigment& pigment, const Affine3d& old_from_new) {
    if (pigment.kind == Pigment::Kind::solid || old_from_new == Affine3d{}) return;
    pigment.pattern.move(old_from_new);
    for_entries(pigment, [&](Pigment& entry) { move_pigment(entry, old_from_new); });
}

void bend_pigment(Pigment& pigment, const scene::Warp& warp) {
    if (pigment.kind == Pigment::Kind::solid) return;
    pigment.pattern.bend(warp);
    for_entries(pigment, [&](Pigment& entry) { bend_pigment(entry, warp); });
}

bool is_positional(const Pigment& pigment) { return pigment.kind != Pigment::Kind::solid; }

Pigment read_pigment(BuildContext& context, const Block& block, Pigment start) {
    return PigmentReader(context, block, std::move(start)).read();
}

}  // namespace sundog::pov
