// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_radiosity.h"

#include <algorithm>
#include <array>

#include "import/pov/radiosity_file.h"

namespace sundog::pov {
namespace {

constexpr std::array kItems{
    Keyword::adc_bailout,   Keyword::always_sample,  Keyword::brightness,       Keyword::count,
    Keyword::error_bound,   Keyword::gray_threshold, Keyword::low_error_factor, Keyword::max_sample,
    Keyword::maximum_reuse, Keyword::media,          Keyword::minimum_reuse,    Keyword::nearest_count,
    Keyword::normal,        Keyword::pretrace_end,   Keyword::pretrace_start,   Keyword::recursion_limit,
    Keyword::subsurface,    Keyword::importance,     Keyword::save_file,        Keyword::load_file};

/// Reads the items of one block.
class RadiosityReader {
public:
    RadiosityReader(BuildContext& context, const Block& block, scene::Radiosity start)
        : context_(context), items_(context, block), settings_(std::move(start)) {
        settings_.where = context.location(block.where);
        settings_.keeps_ambient = block.version < 370;
    }

    scene::Radiosity read() {
        while (!items_.at_end())
            if (!read_counts() && !read_errors() && !read_light() && !read_switch() && !read_file())
                items_.unexpected(kItems);
        settle_reuse();
        return settings_;
    }

private:
    /// The next number, which must lie in the given limits.
    float number(std::string_view what, double least, double most) {
        const double value = items_.number(what);
        if (!(value >= least && value <= most)) {
            items_.fail(std::string(what) + " out of range",
                        most < 1e30 ? "expected a number from " + short_number(least) + " to " + short_number(most)
                                    : "expected a number of at least " + short_number(least));
        }
        return static_cast<float>(value);
    }
    static std::string short_number(double value) {
        std::string text = std::to_string(value);
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        return text;
    }

    bool read_counts() {
        if (items_.take(Keyword::count)) {
            settings_.count = items_.integer("a number of rays", 1, 1 << 20);
            items_.maybe_number();  // of how many directions they are chosen: all points use the same ones
        } else if (items_.take(Keyword::nearest_count)) {
            settings_.nearest_count = items_.integer("a number of samples", 1, 20);
            items_.maybe_number();  // where a pass may end early: it makes no difference to the picture
        } else if (items_.take(Keyword::recursion_limit)) {
            settings_.recursion_limit = items_.integer("a number of bounces", 1, 20);
        } else {
            return false;
        }
        return true;
    }

    bool read_errors() {
        if (items_.take(Keyword::error_bound)) {
            settings_.error_bound = number("an error bound", 1e-6, 1e30);
        } else if (items_.take(Keyword::low_error_factor)) {
            settings_.low_error_factor = number("a factor", 1e-6, 1e30);
        } else if (items_.take(Keyword::minimum_reuse)) {
            settings_.minimum_reuse = number("a minimum_reuse", 0, 1e30);
            minimum_written_ = true;
        } else if (items_.take(Keyword::maximum_reuse)) {
            settings_.maximum_reuse = number("a maximum_reuse", 1e-9, 1e30);
            maximum_written_ = true;
        } else if (items_.take(Keyword::pretrace_start)) {
            settings_.pretrace_start = number("a pretrace_start", 0, 1);
        } else if (items_.take(Keyword::pretrace_end)) {
            settings_.pretrace_end = number("a pretrace_end", 0, 1);
        } else {
            return false;
        }
        return true;
    }

    bool read_light() {
        if (items_.take(Keyword::adc_bailout)) {
            settings_.adc_bailout = number("a weight", 0, 1e30);
        } else if (items_.take(Keyword::brightness)) {
            settings_.brightness = number("a brightness", 0, 1e30);
        } else if (items_.take(Keyword::gray_threshold)) {
            settings_.gray_threshold = number("a gray_threshold", 0, 1);
        } else if (items_.take(Keyword::max_sample)) {
            settings_.max_sample = static_cast<float>(items_.number("a brightness"));
        } else if (items_.take(Keyword::importance)) {
            number("an importance", 0, 1);  // how many rays are worth following: all are
        } else {
            return false;
        }
        return true;
    }

    bool read_switch() {
        if (items_.take(Keyword::normal)) {
            settings_.normal = items_.flag();
        } else if (items_.take(Keyword::media)) {
            settings_.media = items_.flag();
        } else if (items_.take(Keyword::always_sample)) {
            settings_.always_sample = items_.flag();
        } else if (items_.take(Keyword::subsurface)) {
            items_.flag();
        } else {
            return false;
        }
        return true;
    }

    bool read_file() {
        if (items_.take(Keyword::load_file)) {
            const std::string name = items_.text("the name of a file of radiosity");
            settings_.loaded = load_radiosity(context_, name, items_.taken_where());
        } else if (items_.take(Keyword::save_file)) {
            const std::string name = items_.text("the name of a file of radiosity");
            settings_.store = radiosity_store(context_, name, items_.taken_where());
        } else {
            return false;
        }
        return true;
    }

    /// Of the two limits of reuse the one that isn't written gives way (reference 3.4.4.3.3.9).
    void settle_reuse() {
        if (settings_.minimum_reuse >= settings_.maximum_reuse && minimum_written_ && maximum_written_)
            items_.fail("a minimum_reuse of at least maximum_reuse");
        if (settings_.minimum_reuse <= settings_.maximum_reuse / 2) return;
        if (!maximum_written_) {
            settings_.maximum_reuse = settings_.minimum_reuse * 2;
        } else if (!minimum_written_) {
            settings_.minimum_reuse = settings_.maximum_reuse / 2;
        }
        items_.warn("minimum_reuse is over half of maximum_reuse");
    }

    BuildContext& context_;
    ItemReader items_;
    scene::Radiosity settings_;
    bool minimum_written_ = false, maximum_written_ = false;
};

}  // namespace

scene::Radiosity read_radiosity(BuildContext& context, const Block& block, scene::Radiosity start) {
    return RadiosityReader(context, block, std::move(start)).read();
}

void use_radiosity_file(BuildContext& context) {
    const PovRadiosityFile& file = context.options.radiosity_file;
    if (!context.scene.radiosity || (!file.load && !file.save)) return;
    // Of the scene as a whole: no place in it says so.
    const Place nowhere{};
    if (file.load && context.find_file(file.name, nowhere).empty())
        context.warn(nowhere, "there is no file of radiosity " + in_quotes(file.name) + " yet", "all is gathered anew");
    else if (file.load) context.scene.radiosity->loaded = load_radiosity(context, file.name, nowhere);
    if (file.save) context.scene.radiosity->store = radiosity_store(context, file.name, nowhere);
}

void read_importance(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    while (!items.at_end()) {
        static constexpr std::array kValid{Keyword::importance};
        if (!items.take(Keyword::importance)) items.unexpected(kValid);
        items.number("an importance");
    }
}

}  // namespace sundog::pov
