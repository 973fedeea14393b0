// SPDX-License-Identifier: Apache-2.0
// What one frame of the film shows, as plain data: solids, materials, textures, lamps, sky and camera. Space is that of
// docs/conventions.md: right-handed, Z up, colours linear.
#pragma once

#include "kernel/compat/compat.h"

namespace sundog::intro {

using kernel::uint;
using kernel::vec3;

/// A convex body in a solid's own space, of which solids are cut.
enum class PartKind : uint { kBall, kBox, kTube, kHalfSpace };

struct Part {
    PartKind kind;
    uint axis;     ///< kTube: along which axis it is infinite, 0 to 2.
    vec3 place;    ///< Middle; kHalfSpace: unit normal, pointing out.
    vec3 half;     ///< kBox: half its size.
    float radius;  ///< kBall, kTube; kHalfSpace: distance of its face from the origin along the normal.
};

/// kCarved: what the first `base_count` parts have in common, without the `cut_count` parts after them.
enum class SolidKind : uint { kPlane, kSphere, kTorus, kCarved };

struct Solid {
    SolidKind kind;
    uint first_part, base_count, cut_count;
    uint material;
    bool casts_shadow;
    vec3 middle;       ///< Of a sphere that holds it, world space; kPlane: its unit normal.
    float radius;      ///< Of that sphere; kPlane: dot(normal, p) on it.
    vec3 origin;       ///< World position of its own space's origin ...
    vec3 x, y, z;      ///< ... and its axes there, orthonormal.
    float ring, tube;  ///< kTorus: radii of the circle around its z and of the tube around that.
};

struct Material {
    vec3 diffuse{};  ///< Times the texture's colour.
    vec3 emission{};
    float highlight{};  ///< Strength of Blinn's highlight, 0 for none ...
    float shininess{};  ///< ... and its exponent.
    vec3 mirror{};  ///< Reflectance seen from straight ahead; it rises to `mirror_edge` at grazing angles (Schlick).
    float mirror_edge{};
    uint texture{};  ///< Into World::textures; 0: plain.
    float waves{};   ///< Steepness of water's bumps; 0: smooth.
};

/// A palette, looked up at a phase that noise bends: marble, wood, clouds and tiles by other numbers.
struct Texture {
    vec3 stripes{};      ///< Phases per unit of length ...
    float rings{};       ///< ... and per unit of distance from the z axis.
    vec3 noise_scale{};  ///< Periods of the noise volume per unit of length ...
    float noise{};       ///< ... which moves the phase by this at most.
    float tiles{};       ///< Tiles per unit of length along x and y, of two kinds: the palette's halves; 0: no tiles.
    uint palette{};
    vec3 shift{};  ///< Added to places; clouds drift by it.
};

struct Lamp {
    kernel::Light light;  ///< kernel/shared.h: LIGHT_LAMP, LIGHT_SUN or LIGHT_SPOT.
    float reach;          ///< Distance at which it has lost half its strength; 0: never.
    float glow;           ///< Light that the air around it scatters towards the eye.
};

/// What is around everything.
struct Air {
    uint bounces{};    ///< Mirrors on a path at most.
    float vignette{};  ///< How much darker corners are, 0 to 1.
    float fog{};       ///< Halvings of light per unit of length; 0: clear air.
    vec3 fog_color{};
    vec3 ambient_up{}, ambient_down{};  ///< Light from above and from below that reaches everything.
    vec3 zenith{}, horizon{};           ///< The sky's colours.
};

/// What stands in the sky.
struct Sky {
    vec3 sun_place{};  ///< Unit direction towards the sun.
    vec3 sun_color{};  ///< 0: no sun.
    vec3 dogs[2]{};    ///< Unit directions towards the two sun dogs.
    float halo{};      ///< Strength of the ring of 22 degrees and of its dogs.
    vec3 clouds{};     ///< Their colour.
    uint texture{};    ///< Of the clouds; 0: a clear sky.
};

inline constexpr uint kMaxSolids = 64, kMaxParts = 192, kMaxMaterials = 24, kMaxTextures = 12, kMaxLamps = 4;
inline constexpr uint kMaxBounces = 5;

struct World {
    uint solid_count, part_count, material_count, texture_count, lamp_count;
    float exposure;  ///< All light times this; fades are made with it.
    float seconds;   ///< Film time, which moves water.
    kernel::Camera camera;
    Air air;
    Sky sky;
    Solid solids[kMaxSolids];
    Part parts[kMaxParts];
    Material materials[kMaxMaterials];
    Texture textures[kMaxTextures];
    Lamp lamps[kMaxLamps];
};

}  // namespace sundog::intro
