// SPDX-License-Identifier: Apache-2.0
// Procedural surfaces as POV-Ray describes them (its reference, section 3.5 "Texture"): patterns, pigments, finishes,
// layers. Plain description; compile/ turns pigments into the kernel's bytecode.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/boxed.h"
#include "base/diagnostics.h"
#include "base/vec3d.h"
#include "scene/medium.h"
#include "scene/pattern.h"

namespace sundog::scene {

/// Linear RGB with what passes through: `filter` tinted by the colour, `transmit` untinted.
struct PigmentColor {
    float r = 0, g = 0, b = 0, filter = 0, transmit = 0;
};

struct Pigment;

/// A picture laid over a plane, sphere, … (image_map).
struct ImageMap {
    std::uint32_t texture = 0;  ///< Into Scene::textures.
    int map_type = 0;           ///< 0 planar (x, y in 0..1), 1 spherical, 2 cylindrical, 5 toroidal.
    bool once = false;          ///< Clear outside the unit square.
    bool smooth = false;        ///< Bilinear; else the texel that the point lies in.
    float filter_all = 0, transmit_all = 0;
};

/// Where a pigment stands in a map, or what the n-th choice of a list pattern is.
struct PigmentEntry {
    float at = 0;
    PigmentColor color;                      ///< Unless `pigment` is set.
    std::shared_ptr<const Pigment> pigment;  ///< pigment_map
};

/// A colour at every point of an object.
struct Pigment {
    enum class Kind : std::uint8_t { solid, mapped, choice, image };
    SourceLocation where;
    Kind kind = Kind::solid;
    PigmentColor color;  ///< solid
    /// mapped (a field through `entries`), choice (picks one of `entries`), image (where it lies)
    Pattern pattern;
    std::vector<PigmentEntry> entries;  ///< Ascending `at` when mapped.
    ImageMap image;
    bool uv_mapping = false;
    PigmentColor quick_color;  ///< At quality 5 and lower.
};

/// How a pattern bends a surface's normal (section 3.4.6.2 "Normal"), or a share of such a normal.
struct PatternNormal {
    enum class Kind : std::uint8_t { pattern, image, bumps, dents, wrinkles, ripples, waves, special };
    SourceLocation where;
    Kind kind = Kind::bumps;
    Pattern pattern;  ///< Where it lies, its turbulence; frequency and phase of ripples and waves; special: the
                      ///< pattern, quilted or facets.
    std::shared_ptr<const Pigment> height;  ///< pattern, image: its grey, asked at the pattern's own point; null: flat.
    double texel_u = 0, texel_v = 0;        ///< image: a texel's size.
    float amount = 0.5F;
    double accuracy = 0.02;                 ///< pattern: the distance over which its slope is found.
    bool keeps_depth = false;               ///< Scaling changes how steep it is (no_bump_scale), not how deep.
    std::shared_ptr<const Pigment> weight;  ///< Its share of the sum, red of this pigment; null: 1.
};

/// A sum of bent normals, made unit.
struct Normal {
    std::vector<PatternNormal> parts;
    bool uv_mapping = false;
    /// Whether it bends nothing, but has an amount and a place for normals that start from it.
    [[nodiscard]] bool is_flat() const {
        return parts.size() == 1 && parts[0].kind == PatternNormal::Kind::pattern && !parts[0].height;
    }
};

/// How a surface answers to light (section 3.5.4 "Finish"). Colours linear.
struct Finish {
    Vec3 ambient{0.1F, 0.1F, 0.1F};
    Vec3 emission{0, 0, 0};
    float diffuse = 0.6F, diffuse_back = 0;
    float brilliance = 1;
    float phong = 0, phong_size = 40;
    float specular = 0, roughness = 0.05F;
    float metallic = 0;  ///< Tints highlights with the pigment.
    Vec3 reflection_min{0, 0, 0}, reflection_max{0, 0, 0};
    float reflection_falloff = 1;   ///< Exponent of the angle's share between min and max.
    float reflection_exponent = 1;  ///< Of the reflected colour.
    float reflection_metallic = 0;
    bool reflection_fresnel = false;
    bool conserve_energy = false;
    float crand = 0;  ///< Each light's matt light is darkened by up to this much, at random.
    float irid = 0, irid_thickness = 0, irid_turbulence = 0;  ///< A thin film: how much it does, and what it is like.
    /// If the scene has Subsurface: mean free paths of red, green and blue light below the surface, in millimetres.
    Vec3 translucency{0, 0, 0};
};

/// One layer of a texture.
struct TextureLayer {
    std::shared_ptr<const Pigment> pigment;
    Finish finish;
    std::shared_ptr<const Normal> normal = nullptr;  ///< Null: the surface's own.
    /// The top layer of a part of a patterned texture (texture_map, checker of textures, …) has the part's share, red
    /// of this pigment. The parts' layers follow each other, and add up.
    std::shared_ptr<const Pigment> share = nullptr;
    bool first_part = false;  ///< Of the top layer of a patterned texture: no part is over it.
    bool parts_end = false;   ///< Of the lowest layer of a patterned texture.
};

/// What is inside a solid (section 3.5.7 "Interior").
struct Interior {
    float ior = 1;
    float dispersion = 1;  ///< Index of refraction of violet over that of red light.
    int dispersion_samples = 7;
    float caustics = 0;
    float fade_distance = 0, fade_power = 0;
    Vec3 fade_color{0, 0, 0};
    std::shared_ptr<const std::vector<Medium>> media;  ///< Added up; null: none.
    bool operator==(const Interior&) const = default;
};

/// A texture of one or more layers, the first below all others.
struct LayeredTexture {
    std::vector<TextureLayer> layers;
    /// Of parts: nearly the same, without parts; for what would have too many.
    std::shared_ptr<const LayeredTexture> blended = nullptr;
};

/// Whether it, or a pigment in it, looks at coordinates on the surface.
bool uses_uv(const Pigment& pigment);
bool uses_uv(const LayeredTexture& texture);

/// A texture on an object. Objects that carry the same texture share it and differ in where it lies, or in its colour.
struct PatternedSurface {
    std::shared_ptr<const LayeredTexture> texture;
    std::optional<PigmentColor> color;         ///< Of the texture's only layer, instead of its pigment.
    Boxed<Affine3d> texture_from_world;        ///< What the object's transforms did to the texture, inverted.
    std::shared_ptr<const Interior> interior;  ///< Null: air.
    Boxed<Affine3d> interior_from_world;       ///< Where its media lie.
    bool hollow = false;                ///< Fog and media around it go on inside; media of its own need that, too.
    std::uint32_t interior_number = 0;  ///< Surfaces of one object, and objects that share it, have the same; 0: none.
    std::uint32_t light_set = 0;        ///< Which lights reach it: Scene::light_sets, from 1; 0: those of group 0.
    bool double_illuminate = false;     ///< Lit from behind as from the front.
};

}  // namespace sundog::scene
