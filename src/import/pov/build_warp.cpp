// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_warp.h"

#include <array>
#include <cmath>

namespace sundog::pov {
namespace {

using scene::Warp;

void read_turbulence(ItemReader& items, Warp& warp) {
    warp.kind = Warp::Kind::turbulence;
    warp.turbulence = items.vector("an amount of turbulence");
}

void read_repeat(ItemReader& items, Warp& warp) {
    warp.kind = Warp::Kind::repeat;
    warp.repeat = items.vector("a direction and width to repeat along");
    int axes = 0;
    for (std::size_t i = 0; i < 3; ++i) axes += warp.repeat[i] != 0 ? 1 : 0;
    if (axes != 1) items.warn("a repeat that isn't along one axis", "the largest component counts");
}

void read_black_hole(ItemReader& items, Warp& warp) {
    warp.kind = Warp::Kind::black_hole;
    warp.center = items.vector("the center of a black hole");
    warp.radius = items.number("the radius of a black hole");
}

void read_planar(ItemReader& items, Warp& warp) {
    warp.kind = Warp::Kind::planar;
    if (!items.value_follows()) return;
    warp.orientation = items.vector("the normal of a plane");
    if (const auto distance = items.maybe_number()) warp.distance = *distance;
}

bool read_kind(ItemReader& items, Warp& warp) {
    if (items.take(Keyword::turbulence)) read_turbulence(items, warp);
    else if (items.take(Keyword::repeat)) read_repeat(items, warp);
    else if (items.take(Keyword::black_hole)) read_black_hole(items, warp);
    else if (items.take(Keyword::planar)) read_planar(items, warp);
    else if (items.take(Keyword::cylindrical)) warp.kind = Warp::Kind::cylindrical;
    else if (items.take(Keyword::spherical)) warp.kind = Warp::Kind::spherical;
    else if (items.take(Keyword::toroidal)) warp.kind = Warp::Kind::toroidal;
    else if (items.take(Keyword::cubic)) warp.kind = Warp::Kind::cubic;
    else return false;
    return true;
}

bool read_modifier(ItemReader& items, Warp& warp) {
    if (items.take(Keyword::octaves)) warp.octaves = items.integer("a number of octaves", -1000, 1000);
    else if (items.take(Keyword::lambda)) warp.lambda = items.number("lambda");
    else if (items.take(Keyword::omega)) warp.omega = items.number("omega");
    else if (items.take(Keyword::offset)) warp.offset = items.vector("an offset");
    else if (items.take(Keyword::flip)) warp.flip = items.vector("axes to mirror");
    else if (items.take(Keyword::strength)) warp.strength = items.number("a strength");
    else if (items.take(Keyword::falloff)) warp.falloff = items.number("a falloff");
    else if (items.take(Keyword::inverse)) warp.inverse = items.flag();
    else if (items.take(Keyword::type)) items.number("a type");
    else if (items.take(Keyword::repeat)) warp.repeat = items.vector("the size of a block");
    else if (items.take(Keyword::turbulence)) warp.turbulence = items.vector("an amount of turbulence");
    else if (items.take(Keyword::orientation)) warp.orientation = items.vector("an orientation");
    else if (items.take(Keyword::dist_exp)) warp.distance_exponent = items.number("an exponent");
    else if (items.take(Keyword::major_radius)) warp.major_radius = items.number("a radius");
    else return false;
    return true;
}

}  // namespace

Warp read_warp(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    Warp warp;
    if (const auto base = items.take_block(Keyword::warp)) warp = read_warp(context, *base);
    else if (!read_kind(items, warp))
        items.unexpected("turbulence, repeat, black_hole, planar, cylindrical, spherical, toroidal or cubic");
    while (!items.at_end())
        if (!read_modifier(items, warp)) items.unexpected("a modifier of the warp");
    return warp;
}

}  // namespace sundog::pov
