// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_finish.h"

#include <algorithm>
#include <array>

#include "import/pov/build_media.h"
#include "import/pov/byte_key.h"

namespace sundog::pov {
namespace {

using scene::Finish;
using scene::Interior;

Vec3 rgb_of(const scene::PigmentColor& c) { return {c.r, c.g, c.b}; }

/// An amount, and whether it is written as an albedo: what the surface reflects in all, not at its brightest.
struct Amount {
    float value = 0;
    bool albedo = false;
};

Amount read_amount(ItemReader& items, std::string_view what) {
    Amount amount;
    amount.albedo = items.take(Keyword::albedo);
    amount.value = static_cast<float>(items.number(what));
    return amount;
}

class FinishReader {
public:
    FinishReader(BuildContext& context, const Block& block, FinishParts start)
        : context_(context), items_(context, block), parts_(std::move(start)) {}

    FinishParts read() {
        while (!items_.at_end()) {
            if (const auto base = items_.take_block(Keyword::finish)) {
                parts_ = read_finish(context_, *base, parts_);
            } else if (const auto reflection = items_.take_block(Keyword::reflection)) {
                read_reflection(*reflection);
            } else if (const auto film = items_.take_block(Keyword::irid)) {
                read_film(*film);
            } else if (const auto below = items_.take_block(Keyword::subsurface)) {
                read_subsurface(*below);
            } else if (!read_light() && !read_mirror() && !read_old_interior()) {
                unexpected();
            }
        }
        apply_albedo();
        return parts_;
    }

private:
    float number(std::string_view what) { return static_cast<float>(items_.number(what)); }

    bool read_light() {
        Finish& f = parts_.finish;
        if (items_.take(Keyword::ambient)) {
            f.ambient = rgb_of(items_.color("a color"));
        } else if (items_.take(Keyword::emission)) {
            f.emission = rgb_of(items_.color("a color"));
        } else if (items_.take(Keyword::diffuse)) {
            const Amount amount = read_amount(items_, "an amount of diffuse reflection");
            f.diffuse = amount.value, diffuse_albedo_ = amount.albedo;
            f.diffuse_back = static_cast<float>(items_.maybe_number().value_or(0));
        } else if (items_.take(Keyword::brilliance)) {
            f.brilliance = number("a brilliance");
        } else if (items_.take(Keyword::phong)) {
            const Amount amount = read_amount(items_, "an amount of highlight");
            f.phong = amount.value, phong_albedo_ = amount.albedo;
        } else if (items_.take(Keyword::phong_size)) {
            f.phong_size = number("a phong_size");
        } else if (items_.take(Keyword::specular)) {
            const Amount amount = read_amount(items_, "an amount of highlight");
            f.specular = amount.value, specular_albedo_ = amount.albedo;
        } else if (items_.take(Keyword::roughness)) {
            read_roughness();
        } else if (items_.take(Keyword::metallic)) {
            f.metallic = static_cast<float>(items_.maybe_number().value_or(1));
        } else if (items_.take(Keyword::crand)) {
            f.crand = number("an amount of graininess");
        } else {
            return false;
        }
        return true;
    }

    void read_roughness() {
        const float roughness = number("a roughness");
        if (roughness == 0) items_.fail("a roughness of 0", "expected a small number such as 0.001");
        parts_.finish.roughness = roughness;
    }

    bool read_mirror() {
        Finish& f = parts_.finish;
        if (items_.take(Keyword::reflection)) {
            f.reflection_max = rgb_of(items_.color("a color"));
            f.reflection_min = f.reflection_max;
        } else if (items_.take(Keyword::reflection_exponent)) {
            f.reflection_exponent = number("an exponent");
        } else if (items_.take(Keyword::conserve_energy)) {
            f.conserve_energy = items_.flag();
        } else if (items_.take(Keyword::irid)) {
            f.irid = number("an amount");
        } else {
            return false;
        }
        return true;
    }

    void read_film(const Block& block) {
        ItemReader items(context_, block);
        Finish& f = parts_.finish;
        f.irid = static_cast<float>(items.number("an amount of iridescence"));
        while (!items.at_end()) {
            if (items.take(Keyword::thickness)) {
                f.irid_thickness = static_cast<float>(items.number("a thickness"));
            } else if (items.take(Keyword::turbulence)) {
                f.irid_turbulence = static_cast<float>(items.number("an amount of turbulence"));
            } else {
                static constexpr std::array kValid{Keyword::thickness, Keyword::turbulence};
                items.unexpected(kValid);
            }
        }
    }

    void read_subsurface(const Block& block) {
        ItemReader items(context_, block);
        while (!items.at_end()) {
            static constexpr std::array kValid{Keyword::translucency};
            if (!items.take(Keyword::translucency)) items.unexpected(kValid);
            const Vec3 translucency = rgb_of(items.color("a color"));
            if (!(std::min({translucency.x, translucency.y, translucency.z}) >= 0))
                items.fail("a translucency under 0", "expected mean free paths of light, in millimetres");
            parts_.finish.translucency = translucency;
        }
    }

    void read_reflection(const Block& block) {
        ItemReader items(context_, block);
        Finish& f = parts_.finish;
        int colors = 0;
        while (!items.at_end()) {
            if (items.value_follows()) {
                f.reflection_max = rgb_of(items.color("a color"));
                if (++colors == 1) f.reflection_min = f.reflection_max;
            } else if (items.take(Keyword::fresnel)) {
                f.reflection_fresnel = items.flag();
            } else if (items.take(Keyword::falloff)) {
                f.reflection_falloff = static_cast<float>(items.number("a falloff"));
            } else if (items.take(Keyword::exponent)) {
                f.reflection_exponent = static_cast<float>(items.number("an exponent"));
            } else if (items.take(Keyword::metallic)) {
                f.reflection_metallic = static_cast<float>(items.maybe_number().value_or(1));
            } else {
                static constexpr std::array kValid{Keyword::fresnel, Keyword::falloff, Keyword::exponent,
                                                   Keyword::metallic};
                items.unexpected(kValid);
            }
        }
        // As povray's pictures show: Fresnel's equations have all of a single colour.
        if (colors == 1 && f.reflection_fresnel) f.reflection_min = {};
    }

    /// What was the finish's before version 3.1 and is the interior's since.
    bool read_old_interior() {
        Interior& interior = parts_.interior;
        if (items_.take(Keyword::ior)) {
            interior.ior = number("an index of refraction");
        } else if (items_.take(Keyword::caustics)) {
            interior.caustics = number("an amount of caustics");
        } else if (items_.take(Keyword::fade_distance)) {
            interior.fade_distance = number("a distance");
        } else if (items_.take(Keyword::fade_power)) {
            interior.fade_power = number("a power");
        } else if (items_.take(Keyword::refraction)) {
            if (items_.number("on or off") == 0) interior.ior = 1;
        } else {
            return false;
        }
        parts_.has_interior = true;
        return true;
    }

    /// Turns albedos into amounts at the brightest: a lobe of cos^n reflects 2/(n+1) of what a perfectly diffuse
    /// surface of the same amount does (its integral over the hemisphere, in units of pi).
    void apply_albedo() {
        Finish& f = parts_.finish;
        if (diffuse_albedo_) {
            f.diffuse *= (f.brilliance + 1) / 2;
            f.diffuse_back *= (f.brilliance + 1) / 2;
        }
        if (phong_albedo_) f.phong *= (f.phong_size + 1) / 2;
        if (specular_albedo_) {
            const float n = 1 / f.roughness;
            f.specular *= (n + 2) / 8;  // Blinn's halfway vectors
        }
    }

    [[noreturn]] void unexpected() {
        static constexpr std::array kValid{Keyword::ambient,    Keyword::emission,        Keyword::diffuse,
                                           Keyword::brilliance, Keyword::crand,           Keyword::phong,
                                           Keyword::phong_size, Keyword::specular,        Keyword::roughness,
                                           Keyword::metallic,   Keyword::reflection,      Keyword::irid,
                                           Keyword::subsurface, Keyword::conserve_energy, Keyword::reflection_exponent};
        items_.unexpected(kValid);
    }

    BuildContext& context_;
    ItemReader items_;
    FinishParts parts_;
    bool diffuse_albedo_ = false, phong_albedo_ = false, specular_albedo_ = false;
};

}  // namespace

std::string bytes_of(const scene::Finish& f) {
    std::string key;
    append_bytes(key, f.ambient, f.emission, f.diffuse, f.diffuse_back, f.brilliance, f.phong, f.phong_size, f.specular,
                 f.roughness, f.metallic, f.reflection_min, f.reflection_max, f.reflection_falloff,
                 f.reflection_exponent, f.reflection_metallic, f.reflection_fresnel, f.conserve_energy, f.crand, f.irid,
                 f.irid_thickness, f.irid_turbulence, f.translucency);
    return key;
}

FinishParts read_finish(BuildContext& context, const Block& block, FinishParts start) {
    return FinishReader(context, block, std::move(start)).read();
}

Interior read_interior(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    Interior interior;
    const auto number = [&](std::string_view what) { return static_cast<float>(items.number(what)); };
    while (!items.at_end()) {
        if (const auto base = items.take_block(Keyword::interior)) {
            interior = read_interior(context, *base);
        } else if (const auto medium = items.take_block(Keyword::media)) {
            auto media = std::make_shared<std::vector<scene::Medium>>();
            if (interior.media) *media = *interior.media;
            media->push_back(read_medium(context, *medium));
            interior.media = std::move(media);
        } else if (items.take(Keyword::ior)) {
            interior.ior = number("an index of refraction");
        } else if (items.take(Keyword::caustics)) {
            interior.caustics = number("an amount of caustics");
        } else if (items.take(Keyword::dispersion)) {
            interior.dispersion = number("a dispersion");
        } else if (items.take(Keyword::dispersion_samples)) {
            interior.dispersion_samples = items.integer("a number of samples", 2, 1000);
        } else if (items.take(Keyword::fade_distance)) {
            interior.fade_distance = number("a distance");
        } else if (items.take(Keyword::fade_power)) {
            interior.fade_power = number("a power");
        } else if (items.take(Keyword::fade_color)) {
            interior.fade_color = rgb_of(items.color("a color"));
        } else {
            static constexpr std::array kValid{Keyword::ior,           Keyword::caustics,          Keyword::dispersion,
                                               Keyword::fade_distance, Keyword::fade_power,        Keyword::fade_color,
                                               Keyword::media,         Keyword::dispersion_samples};
            items.unexpected(kValid);
        }
    }
    return interior;
}

}  // namespace sundog::pov
