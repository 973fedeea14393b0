// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_atmosphere.h"

#include <algorithm>
#include <array>

#include "import/pov/build_photons.h"
#include "import/pov/build_pigment.h"
#include "import/pov/build_radiosity.h"
#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

Vec3 rgb_of(const scene::PigmentColor& c) { return {c.r, c.g, c.b}; }

scene::Fog fog_of(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    scene::Fog fog;
    fog.noise_generator = context.noise_generator;
    const auto number = [&](std::string_view what) { return static_cast<float>(items.number(what)); };
    while (!items.at_end()) {
        Affine3d moved;
        if (const auto base = items.take_block(Keyword::fog)) {
            fog = fog_of(context, *base);
        } else if (items.take(Keyword::fog_type)) {
            fog.ground = items.integer("a fog_type", 1, 2) == 2;
        } else if (items.take(Keyword::distance)) {
            fog.distance = number("a distance");
        } else if (items.take(Keyword::fog_offset)) {
            fog.offset = number("an offset");
        } else if (items.take(Keyword::fog_alt)) {
            fog.altitude = number("an altitude");
        } else if (items.take(Keyword::up)) {
            fog.up = to_float(normalize(items.vector("a direction upwards")));
        } else if (items.take(Keyword::turbulence)) {
            fog.turbulence = to_float(items.vector("an amount of turbulence"));
        } else if (items.take(Keyword::turb_depth)) {
            fog.turb_depth = number("a share of the turbulence");
        } else if (items.take(Keyword::lambda)) {
            fog.lambda = number("a ratio of frequencies");
        } else if (items.take(Keyword::omega)) {
            fog.omega = number("a ratio of strengths");
        } else if (items.take(Keyword::octaves)) {
            fog.octaves = items.integer("a number of octaves", 1, 10);
        } else if (items.value_follows()) {
            fog.color = items.color("a color");
        } else if (read_transform(items, moved)) {
            fog.up = to_float(normalize(transform_vector(moved, to_double(fog.up))));
        } else {
            static constexpr std::array kValid{
                Keyword::fog_type,   Keyword::distance, Keyword::fog_offset, Keyword::fog_alt, Keyword::up,
                Keyword::turbulence, Keyword::octaves,  Keyword::lambda,     Keyword::omega,   Keyword::turb_depth};
            items.unexpected(kValid);
        }
    }
    return fog;
}

/// The colours of `color_map { }` along x.
std::shared_ptr<const scene::Pigment> colors_along_x(BuildContext& context, const Block& rainbow, const Block& map) {
    scene::Pigment gradient;
    gradient.where = context.location(map.where);
    gradient.kind = scene::Pigment::Kind::mapped;
    Block pigment = rainbow;
    pigment.keyword = Keyword::pigment;
    pigment.items = {Item{map.where, std::make_shared<const Block>(map)}};
    return std::make_shared<const scene::Pigment>(read_pigment(context, pigment, std::move(gradient)));
}

scene::Rainbow rainbow_of(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    scene::Rainbow bow;
    const auto number = [&](std::string_view what) { return static_cast<float>(items.number(what)); };
    const auto radians = [&] { return number("an angle in degrees") * 0.0174532925F; };
    while (!items.at_end()) {
        if (const auto base = items.take_block(Keyword::rainbow)) {
            bow = rainbow_of(context, *base);
        } else if (const auto map = items.take_block(Keyword::color_map)) {
            bow.colors = colors_along_x(context, block, *map);
        } else if (items.take(Keyword::direction)) {
            bow.direction = to_float(items.vector("a direction"));
        } else if (items.take(Keyword::up)) {
            bow.up = to_float(items.vector("a direction upwards"));
        } else if (items.take(Keyword::angle)) {
            bow.angle = radians();
        } else if (items.take(Keyword::width)) {
            bow.width = radians();
        } else if (items.take(Keyword::distance)) {
            bow.distance = number("a distance");
        } else if (items.take(Keyword::jitter)) {
            bow.jitter = number("an amount of jitter");
        } else if (items.take(Keyword::arc_angle)) {
            bow.arc_angle = radians();
        } else if (items.take(Keyword::falloff_angle)) {
            bow.falloff_angle = radians();
        } else {
            static constexpr std::array kValid{Keyword::direction, Keyword::up,        Keyword::angle,
                                               Keyword::width,     Keyword::distance,  Keyword::jitter,
                                               Keyword::color_map, Keyword::arc_angle, Keyword::falloff_angle};
            items.unexpected(kValid);
        }
    }
    bow.where = context.location(block.where);
    return bow;
}

scene::SkySphere sky_sphere_of(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    scene::SkySphere sky;
    Affine3d world_from_sky;
    while (!items.at_end()) {
        if (const auto base = items.take_block(Keyword::sky_sphere)) {
            sky = sky_sphere_of(context, *base);
        } else if (const auto pigment = items.take_block(Keyword::pigment)) {
            sky.pigments.push_back(std::make_shared<const scene::Pigment>(read_pigment(context, *pigment, {})));
        } else if (items.take(Keyword::emission)) {
            sky.emission = items.color("a color");
        } else if (!read_transform(items, world_from_sky)) {
            static constexpr std::array kValid{Keyword::pigment, Keyword::emission, Keyword::rotate,
                                               Keyword::scale,   Keyword::matrix,   Keyword::transform};
            items.unexpected(kValid);
        }
    }
    sky.sky_from_world = sky.sky_from_world * inverse(world_from_sky);
    return sky;
}

scene::Subsurface read_subsurface(BuildContext& context, const Block& block, scene::Subsurface settings) {
    constexpr int kMost = 100'000;
    ItemReader items(context, block);
    settings.where = context.location(block.where);
    while (!items.at_end()) {
        if (items.take(Keyword::samples)) {
            settings.samples = items.integer("a number of samples", 1, kMost);
            if (items.number_follows()) settings.single_samples = items.integer("a number of samples", 1, kMost);
        } else if (items.take(Keyword::radiosity)) {
            if (items.flag())
                context.warn_once("subsurface radiosity", items.taken_where(),
                                  "subsurface: light of radiosity is not spread below surfaces");
        } else {
            static constexpr std::array kValid{Keyword::samples, Keyword::radiosity};
            items.unexpected(kValid);
        }
    }
    return settings;
}

/// Settings of what isn't drawn yet, or makes no difference to how Sundog computes.
constexpr std::array kNumbersWithoutEffect{Keyword::max_intersections, Keyword::number_of_waves, Keyword::hf_gray_16};

}  // namespace

void read_background(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    while (!items.at_end()) {
        if (const auto base = items.take_block(Keyword::background)) {
            read_background(context, *base);
        } else if (!items.take(Keyword::color)) {
            const scene::PigmentColor color = items.color("a color");
            context.scene.sky = rgb_of(color);
            // Before version 3.7 no background is part of a picture that has alpha.
            context.scene.sky_alpha =
                block.version < 370 ? 0 : 1 - std::clamp(color.filter + color.transmit, 0.0F, 1.0F);
        }
    }
}

void read_fog(BuildContext& context, const Block& block) {
    const scene::Fog fog = fog_of(context, block);
    if (fog.distance > 0) {
        context.scene.fogs.push_back(fog);
    } else {
        context.warn(block.where, "a fog without distance; left out");
    }
}

void read_rainbow(BuildContext& context, const Block& block) {
    const scene::Rainbow bow = rainbow_of(context, block);
    if (bow.direction == Vec3{} || !(bow.width > 0) || !(bow.angle > 0) || !bow.colors)
        context.warn(block.where, "a rainbow without direction, angle, width or color_map; left out");
    else context.scene.rainbows.push_back(bow);
}

void read_sky_sphere(BuildContext& context, const Block& block) {
    context.scene.sky_spheres.push_back(sky_sphere_of(context, block));
}

void read_global_settings(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    scene::Scene& scene = context.scene;
    while (!items.at_end()) {
        if (const auto radiosity = items.take_block(Keyword::radiosity)) {
            scene.radiosity = read_radiosity(context, *radiosity, scene.radiosity.value_or(scene::Radiosity{}));
        } else if (const auto photons = items.take_block(Keyword::photons)) {
            scene.photons = read_photons(context, *photons, scene.photons.value_or(scene::Photons{}));
        } else if (const auto below = items.take_block(Keyword::subsurface)) {
            scene.subsurface = read_subsurface(context, *below, scene.subsurface.value_or(scene::Subsurface{}));
        } else if (items.take(Keyword::mm_per_unit)) {
            const double mm = items.number("millimetres");
            if (!(mm > 0)) items.fail("an mm_per_unit that is not positive", "expected millimetres, such as 10");
            scene.mm_per_unit = static_cast<float>(mm);
        } else if (items.take(Keyword::assumed_gamma)) {
            const double gamma = items.take(Keyword::srgb) ? kLegacyGamma : items.number("a gamma");
            if (!(gamma > 0)) items.fail("an assumed_gamma that is not positive", "expected 1.0, 2.2 or srgb");
            context.color_space.assumed_gamma = gamma;
        } else if (items.take(Keyword::adc_bailout)) {
            scene.settings.min_weight = static_cast<float>(items.number("a weight"));
        } else if (items.take(Keyword::max_trace_level)) {
            // The eye's ray counts, too.
            scene.settings.max_depth = items.integer("a level", 1, 256) - 1;
        } else if (items.take(Keyword::irid_wavelength)) {
            scene.irid_wavelength = rgb_of(items.color("a color"));
        } else if (items.take(Keyword::ambient_light)) {
            scene.ambient = rgb_of(items.color("a color"));
        } else if (items.take(Keyword::noise_generator)) {
            context.noise_generator = items.integer("a noise generator", 1, 3);
        } else if (items.take(Keyword::charset)) {
            if (!items.take(Keyword::ascii) && !items.take(Keyword::utf8) && !items.take(Keyword::sys))
                items.unexpected("ascii, utf8 or sys");
        } else {
            const std::optional<Keyword> keyword = items.peek_keyword();
            if (!keyword || std::find(kNumbersWithoutEffect.begin(), kNumbersWithoutEffect.end(), *keyword) ==
                                kNumbersWithoutEffect.end()) {
                static constexpr std::array kValid{
                    Keyword::adc_bailout,     Keyword::ambient_light,   Keyword::assumed_gamma,
                    Keyword::charset,         Keyword::irid_wavelength, Keyword::max_intersections,
                    Keyword::max_trace_level, Keyword::mm_per_unit,     Keyword::noise_generator,
                    Keyword::number_of_waves, Keyword::photons,         Keyword::radiosity,
                    Keyword::subsurface,      Keyword::hf_gray_16};
                items.unexpected(kValid);
            }
            items.skip();
            if (items.value_follows()) items.skip();
        }
    }
}

}  // namespace sundog::pov
