// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_photons.h"

#include <array>

#include "import/pov/photon_file.h"

namespace sundog::pov {
namespace {

constexpr std::array kItems{Keyword::spacing,     Keyword::count,    Keyword::gather,
                            Keyword::media,       Keyword::jitter,   Keyword::save_file,
                            Keyword::load_file,   Keyword::autostop, Keyword::max_trace_level,
                            Keyword::adc_bailout, Keyword::radius,   Keyword::expand_thresholds};

constexpr double kAny = 1e30;
constexpr int kMostPhotons = 100'000'000;
constexpr int kMostGathered = 100'000;

/// Reads the items of a block of global_settings.
class PhotonsReader {
public:
    PhotonsReader(BuildContext& context, const Block& block, scene::Photons start)
        : context_(context), items_(context, block), settings_(std::move(start)) {
        settings_.where = context.location(block.where);
    }

    scene::Photons read() {
        while (!items_.at_end())
            if (!read_numbers() && !read_gathering() && !read_file()) items_.unexpected(kItems);
        return settings_;
    }

private:
    float number(std::string_view what, double least, double most) {
        const double value = items_.number(what);
        if (!(value >= least && value <= most))
            items_.fail(std::string(what) + " out of range",
                        most < kAny ? "expected a number from 0 to 1" : "expected a number of at least 0");
        return static_cast<float>(value);
    }
    float positive(std::string_view what) {
        const double value = items_.number(what);
        if (!(value > 0 && value <= kAny))
            items_.fail(std::string(what) + " out of range", "expected a number above 0");
        return static_cast<float>(value);
    }

    bool read_numbers() {
        if (items_.take(Keyword::spacing)) {
            settings_.spacing = positive("a spacing");
            settings_.count = 0;
        } else if (items_.take(Keyword::count)) {
            settings_.count = items_.integer("a number of photons", 1, kMostPhotons);
            settings_.spacing = 0;
        } else if (items_.take(Keyword::media)) {
            settings_.media_steps = items_.integer("a number of steps", 0, kMostPhotons);
            if (items_.number_follows()) settings_.media_factor = positive("a factor");
        } else if (items_.take(Keyword::jitter)) {
            settings_.jitter = number("an amount of jitter", 0, kAny);
        } else if (items_.take(Keyword::max_trace_level)) {
            // The way from the light counts, too.
            settings_.max_depth = items_.integer("a level", 1, 256) - 1;
        } else if (items_.take(Keyword::adc_bailout)) {
            settings_.min_weight = number("a weight", 0, kAny);
        } else if (items_.take(Keyword::autostop)) {
            settings_.autostop = number("an autostop", 0, 1);
        } else {
            return false;
        }
        return true;
    }

    bool read_gathering() {
        if (items_.take(Keyword::gather)) {
            settings_.gather_min = items_.integer("the least number of photons", 1, kMostGathered);
            settings_.gather_max = items_.integer("the greatest number of photons", 1, kMostGathered);
            if (settings_.gather_max < settings_.gather_min)
                items_.fail("fewer photons at most than at least",
                            "expected a number of at least " + std::to_string(settings_.gather_min));
        } else if (items_.take(Keyword::expand_thresholds)) {
            settings_.expand_increase = number("an increase", 0, kAny);
            settings_.expand_min = items_.integer("a number of photons", 0, kMostGathered);
        } else if (items_.take(Keyword::radius)) {
            // All four may be left out; 0 stands for what is guessed, and for a factor of 1.
            const auto maybe = [&](float otherwise) {
                if (!items_.number_follows()) return otherwise;
                const float value = number("a radius", 0, kAny);
                return value > 0 ? value : otherwise;
            };
            settings_.radius = maybe(0);
            settings_.radius_factor = maybe(1);
            settings_.media_radius = maybe(0);
            settings_.media_radius_factor = maybe(1);
        } else {
            return false;
        }
        return true;
    }

    bool read_file() {
        if (items_.take(Keyword::load_file)) {
            const std::string name = items_.text("the name of a file of photons");
            if (settings_.store) fail_both();
            settings_.loaded = load_photons(context_, name, items_.taken_where());
        } else if (items_.take(Keyword::save_file)) {
            const std::string name = items_.text("the name of a file of photons");
            if (settings_.loaded) fail_both();
            settings_.store = photon_store(context_, name, items_.taken_where());
        } else {
            return false;
        }
        return true;
    }
    [[noreturn]] void fail_both() { items_.fail("photons are either loaded or saved", "leave out one of both"); }

    BuildContext& context_;
    ItemReader items_;
    scene::Photons settings_;
};

/// Takes `refraction` or `reflection` with its switch, which is on where none is written.
template <class Settings>
bool read_switch(ItemReader& items, Settings& settings) {
    const auto value = [&] { return items.flag() ? scene::PhotonSwitch::on : scene::PhotonSwitch::off; };
    if (items.take(Keyword::refraction)) {
        settings.refraction = value();
    } else if (items.take(Keyword::reflection)) {
        settings.reflection = value();
    } else {
        return false;
    }
    return true;
}

}  // namespace

scene::Photons read_photons(BuildContext& context, const Block& block, scene::Photons start) {
    return PhotonsReader(context, block, std::move(start)).read();
}

scene::ObjectPhotons read_object_photons(BuildContext& context, const Block& block, scene::ObjectPhotons start) {
    static constexpr std::array kValid{Keyword::target, Keyword::refraction, Keyword::reflection, Keyword::collect,
                                       Keyword::pass_through};
    ItemReader items(context, block);
    while (!items.at_end()) {
        if (items.take(Keyword::target)) {
            // `target 0`, `target off`: not one.
            const double spacing = items.maybe_number().value_or(1);
            if (spacing < 0) items.fail("a negative spacing", "expected a number above 0");
            start.target = spacing > 0;
            start.spacing = start.target ? static_cast<float>(spacing) : 1;
        } else if (items.take(Keyword::collect)) {
            start.collect = items.flag();
        } else if (items.take(Keyword::pass_through)) {
            start.pass_through = items.flag();
        } else if (!read_switch(items, start)) {
            items.unexpected(kValid);
        }
    }
    return start;
}

scene::LightPhotons read_light_photons(BuildContext& context, const Block& block, scene::LightPhotons start) {
    static constexpr std::array kValid{Keyword::refraction, Keyword::reflection, Keyword::area_light};
    ItemReader items(context, block);
    while (!items.at_end()) {
        if (items.take(Keyword::area_light)) start.area_light = items.flag();
        else if (!read_switch(items, start)) items.unexpected(kValid);
    }
    return start;
}

}  // namespace sundog::pov
