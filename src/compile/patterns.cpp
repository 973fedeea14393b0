// SPDX-License-Identifier: Apache-2.0
#include "compile/patterns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "compile/convert.h"

namespace sundog {
namespace {

using scene::Pattern;
using scene::Pigment;
using scene::PigmentColor;

std::optional<std::uint32_t> field_of(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::gradient:
            return kernel::FIELD_GRADIENT;
        case Pattern::Kind::onion:
            return kernel::FIELD_ONION;
        case Pattern::Kind::spherical:
            return kernel::FIELD_SPHERICAL;
        case Pattern::Kind::cylindrical:
            return kernel::FIELD_CYLINDRICAL;
        case Pattern::Kind::planar:
            return kernel::FIELD_PLANAR;
        case Pattern::Kind::boxed:
            return kernel::FIELD_BOXED;
        case Pattern::Kind::radial:
            return kernel::FIELD_RADIAL;
        case Pattern::Kind::leopard:
            return kernel::FIELD_LEOPARD;
        case Pattern::Kind::wood:
            return kernel::FIELD_WOOD;
        case Pattern::Kind::marble:
            return kernel::FIELD_MARBLE;
        case Pattern::Kind::spiral1:
            return kernel::FIELD_SPIRAL1;
        case Pattern::Kind::spiral2:
            return kernel::FIELD_SPIRAL2;
        case Pattern::Kind::bozo:
        case Pattern::Kind::bumps:
        case Pattern::Kind::spotted:
            return kernel::FIELD_NOISE;
        case Pattern::Kind::granite:
            return kernel::FIELD_GRANITE;
        case Pattern::Kind::agate:
            return kernel::FIELD_AGATE;
        case Pattern::Kind::wrinkles:
            return kernel::FIELD_WRINKLES;
        case Pattern::Kind::dents:
            return kernel::FIELD_DENTS;
        case Pattern::Kind::cells:
            return kernel::FIELD_CELLS;
        case Pattern::Kind::crackle:
            return kernel::FIELD_CRACKLE;
        case Pattern::Kind::ripples:
            return kernel::FIELD_RIPPLES;
        case Pattern::Kind::waves:
            return kernel::FIELD_WAVES;
        default:
            return std::nullopt;
    }
}

std::optional<std::uint32_t> choice_of(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::checker:
            return kernel::CHOICE_CHECKER;
        case Pattern::Kind::brick:
            return kernel::CHOICE_BRICK;
        case Pattern::Kind::hexagon:
            return kernel::CHOICE_HEXAGON;
        case Pattern::Kind::square:
            return kernel::CHOICE_SQUARE;
        case Pattern::Kind::triangular:
            return kernel::CHOICE_TRIANGULAR;
        case Pattern::Kind::cubic:
            return kernel::CHOICE_CUBIC;
        default:
            return std::nullopt;
    }
}

/// The wave form of a pattern that names none.
std::uint32_t standard_wave(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::marble:
        case Pattern::Kind::wood:
        case Pattern::Kind::spiral1:
            return kernel::WAVE_TRIANGLE;
        case Pattern::Kind::spiral2:
            return kernel::WAVE_NONE;
        default:
            return kernel::WAVE_RAMP;
    }
}

std::uint32_t wave_of(const Pattern& pattern) {
    switch (pattern.wave) {
        case Pattern::Wave::standard:
            return standard_wave(pattern.kind);
        case Pattern::Wave::ramp:
            return kernel::WAVE_RAMP;
        case Pattern::Wave::triangle:
            return kernel::WAVE_TRIANGLE;
        case Pattern::Wave::sine:
            return kernel::WAVE_SINE;
        case Pattern::Wave::scallop:
            return kernel::WAVE_SCALLOP;
        case Pattern::Wave::cubic:
            return kernel::WAVE_CUBIC;
        case Pattern::Wave::poly:
            return kernel::WAVE_POLY;
    }
    return kernel::WAVE_RAMP;
}

bool lets_light_through(const PigmentColor& color) { return color.filter > 0 || color.transmit > 0; }

/// True where the pigment's colours may let light through somewhere.
bool lets_light_through(const Pigment& pigment, const std::vector<scene::Texture>& textures) {
    if (pigment.kind == Pigment::Kind::solid) return lets_light_through(pigment.color);
    if (pigment.kind == Pigment::Kind::image) {
        const scene::ImageMap& image = pigment.image;
        if (image.once || image.filter_all > 0 || image.transmit_all > 0) return true;
        const auto& texels = textures.at(image.texture).rgba8;
        return std::any_of(texels.begin(), texels.end(), [](std::uint32_t texel) { return texel >> 24U != 255U; });
    }
    return std::any_of(pigment.entries.begin(), pigment.entries.end(), [&](const scene::PigmentEntry& entry) {
        return entry.pigment ? lets_light_through(*entry.pigment, textures) : lets_light_through(entry.color);
    });
}

/// Writes one pigment's program.
class ProgramWriter {
public:
    explicit ProgramWriter(std::vector<std::uint32_t>& code) : code_(code) {}

    /// The pigment's colour into colour slot `slot`; slots from there on, and values likewise, are free to use.
    void write(const Pigment& pigment, std::uint32_t slot) {
        if (slot >= kernel::PROGRAM_SLOTS)
            throw InputError(
                {Severity::error, pigment.where,
                 "pigment maps are nested deeper than " + std::to_string(kernel::PROGRAM_SLOTS) + " levels", "",
                 "take a level out"});
        switch (pigment.kind) {
            case Pigment::Kind::solid:
                write_solid(pigment.color, slot);
                break;
            case Pigment::Kind::mapped:
                write_field(pigment.pattern, slot);
                write_entries(pigment, slot);
                break;
            case Pigment::Kind::choice:
                write_choice(pigment.pattern, slot);
                write_entries(pigment, slot);
                break;
            case Pigment::Kind::image:
                write_image(pigment.image, slot);
                break;
        }
    }
    void end() { instruction(kernel::OP_END, 0); }

private:
    // Every pattern starts from the texture's own point, so one more is enough.
    static constexpr std::uint32_t kPatternPoint = 1;

    void instruction(std::uint32_t op, std::uint32_t target, std::uint32_t source = 0, std::uint32_t source2 = 0) {
        code_.push_back(op | target << 8U | source << 16U | source2 << 24U);
    }
    void put(double value) { code_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
    void put(const Vec3d& v) { put(v.x), put(v.y), put(v.z); }
    void put(const PigmentColor& c) { put(c.r), put(c.g), put(c.b), put(c.filter), put(c.transmit); }

    void write_solid(const PigmentColor& color, std::uint32_t slot) {
        instruction(kernel::OP_SOLID, slot);
        put(color);
    }

    /// The number of the point that a pattern is to be asked at.
    std::uint32_t write_point(const Affine3d& pattern_from_texture) {
        if (pattern_from_texture == Affine3d{}) return 0;
        instruction(kernel::OP_TRANSFORM, kPatternPoint, 0);
        put(pattern_from_texture.x), put(pattern_from_texture.y), put(pattern_from_texture.z);
        put(pattern_from_texture.t);
        return kPatternPoint;
    }

    /// The same, with the pattern's turbulence.
    std::uint32_t write_stirred_point(const Pattern& pattern) {
        const std::uint32_t point = write_point(pattern.pattern_from_texture);
        if (pattern.turbulence == Vec3d{}) return point;
        instruction(kernel::OP_TURBULENCE, kPatternPoint, point);
        put(pattern.turbulence);
        code_.push_back(static_cast<std::uint32_t>(std::clamp(pattern.octaves, 1, 10)));
        put(pattern.lambda), put(pattern.omega);
        return kPatternPoint;
    }

    void write_field(const Pattern& pattern, std::uint32_t slot) {
        const std::optional<std::uint32_t> field = field_of(pattern.kind);
        const std::uint32_t point = write_stirred_point(pattern);
        instruction(kernel::OP_FIELD, slot, point);
        code_.push_back(field.value_or(kernel::FIELD_GRADIENT));
        const bool spiral = pattern.kind == Pattern::Kind::spiral1 || pattern.kind == Pattern::Kind::spiral2;
        Vec3d parameters = normalize(pattern.axis);
        if (spiral) parameters = {static_cast<double>(pattern.arms), 0, 0};
        if (pattern.kind == Pattern::Kind::agate) parameters = {pattern.agate_turbulence, 0, 0};
        put(field ? parameters : Vec3d{});
        code_.push_back(static_cast<std::uint32_t>(std::clamp(pattern.noise_generator, 1, 3)));
        instruction(kernel::OP_WAVE, slot);
        // What isn't drawn yet takes the middle of its map everywhere.
        code_.push_back(field ? wave_of(pattern) : kernel::WAVE_RAMP);
        put(field ? pattern.frequency : 0), put(field ? pattern.phase : 0.5), put(pattern.exponent);
    }

    void write_choice(const Pattern& pattern, std::uint32_t slot) {
        // Floors and walls lie on the borders of squares all the time (a checker on plane { y, -1 }); single precision
        // would draw lots there. POV-Ray gives such a border to the upper side.
        constexpr double kBorder = 1e-4;
        Pattern raised = pattern;
        raised.pattern_from_texture.t += Vec3d{kBorder, kBorder, kBorder};
        const std::uint32_t point = write_stirred_point(raised);
        instruction(kernel::OP_CHOICE, slot, point);
        code_.push_back(choice_of(pattern.kind).value_or(kernel::CHOICE_CHECKER));
        put(pattern.brick_size);
        put(pattern.mortar);
    }

    void write_entries(const Pigment& pigment, std::uint32_t slot) {
        const bool map = pigment.kind == Pigment::Kind::mapped;
        const std::vector<scene::PigmentEntry>& entries = pigment.entries;
        const bool plain =
            std::none_of(entries.begin(), entries.end(), [](const auto& e) { return e.pigment != nullptr; });
        if (plain) {
            instruction(map ? kernel::OP_MAP : kernel::OP_PICK, slot, slot);
            code_.push_back(static_cast<std::uint32_t>(entries.size()));
            for (const scene::PigmentEntry& entry : entries) {
                if (map) put(entry.at);
                put(entry.color);
            }
            return;
        }
        instruction(kernel::OP_CLEAR, slot);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i].pigment) write(*entries[i].pigment, slot + 1);
            else write_solid(entries[i].color, slot + 1);
            if (map) {
                instruction(kernel::OP_BLEND_MAP, slot, slot + 1, slot);
                put(i > 0 ? entries[i - 1].at : -2.0);
                put(entries[i].at);
                put(i + 1 < entries.size() ? entries[i + 1].at : 3.0);
            } else {
                instruction(kernel::OP_BLEND_PICK, slot, slot + 1, slot);
                put(static_cast<double>(i));
            }
        }
    }

    void write_image(const scene::ImageMap& image, std::uint32_t slot) {
        const std::uint32_t point = write_point(image.pattern_from_texture);
        instruction(kernel::OP_IMAGE, slot, point);
        code_.push_back(image.texture);
        code_.push_back((image.once ? kernel::IMAGE_ONCE : 0U) | (image.smooth ? kernel::IMAGE_SMOOTH : 0U));
        code_.push_back(static_cast<std::uint32_t>(image.map_type));
        put(image.filter_all), put(image.transmit_all);
    }

    std::vector<std::uint32_t>& code_;
};

kernel::Layer kernel_layer(const scene::TextureLayer& layer, std::uint32_t program) {
    const scene::Finish& f = layer.finish;
    kernel::Layer out{};
    out.program = program;
    out.flags =
        (f.reflection_fresnel ? kernel::LAYER_FRESNEL : 0U) | (f.conserve_energy ? kernel::LAYER_CONSERVE_ENERGY : 0U);
    out.uses_uv = layer.pigment->uv_mapping ? 1 : 0;
    out.ambient = to_kernel(f.ambient);
    out.emission = to_kernel(f.emission);
    out.diffuse = f.diffuse, out.diffuse_back = f.diffuse_back;
    out.brilliance = f.brilliance;
    out.phong = f.phong, out.phong_size = f.phong_size;
    out.specular = f.specular, out.specular_exponent = 1 / std::max(f.roughness, 1e-5F);
    out.metallic = f.metallic;
    out.reflection_min = to_kernel(f.reflection_min), out.reflection_max = to_kernel(f.reflection_max);
    out.reflection_falloff = f.reflection_falloff;
    out.reflection_metallic = f.reflection_metallic;
    return out;
}

bool reflects(const scene::Finish& f) { return !(f.reflection_min == Vec3{} && f.reflection_max == Vec3{}); }

kernel::Fog kernel_fog(const scene::Fog& fog) {
    kernel::Fog out{};
    out.ground = fog.ground ? 1 : 0;
    out.distance = fog.distance;
    out.color = {fog.color.r, fog.color.g, fog.color.b};
    out.filter_share = fog.color.filter, out.transmit_share = fog.color.transmit;
    out.altitude = fog.altitude, out.offset = fog.offset;
    out.up = to_kernel(normalize(fog.up));
    return out;
}

}  // namespace

std::uint32_t PatternCompiler::program_of(const Pigment& pigment) {
    const auto start = static_cast<std::uint32_t>(out_.code.size());
    ProgramWriter writer(out_.code);
    writer.write(pigment, 0);
    writer.end();
    return start;
}

const PatternCompiler::Layers& PatternCompiler::layers_of(const scene::Material& material) {
    const scene::LayeredTexture& texture = *material.patterned->texture;
    const auto [found, is_new] = compiled_.try_emplace(&texture);
    Layers& layers = found->second;
    if (!is_new) return layers;
    if (texture.layers.size() > kernel::MAX_LAYERS)
        throw InputError({Severity::error, material.where,
                          "a texture of " + std::to_string(texture.layers.size()) + " layers; at most " +
                              std::to_string(kernel::MAX_LAYERS) + " can be drawn",
                          "", "leave out the lowest"});
    layers.first = static_cast<std::uint32_t>(out_.layers.size());
    layers.count = static_cast<std::uint32_t>(texture.layers.size());
    layers.transparent = true;  // as long as every layer over another lets light through
    for (auto layer = texture.layers.rbegin(); layer != texture.layers.rend(); ++layer) {
        out_.layers.push_back(kernel_layer(*layer, program_of(*layer->pigment)));
        layers.transparent = layers.transparent && lets_light_through(*layer->pigment, scene_.textures);
        layers.reflective = layers.reflective || reflects(layer->finish);
    }
    return layers;
}

kernel::Material PatternCompiler::compile_surface(const scene::Material& material) {
    const scene::PatternedSurface& surface = *material.patterned;
    const Layers& layers = layers_of(material);
    kernel::PatternedMaterial patterned{};
    const Affine3d& m = surface.texture_from_world;
    patterned.texture_from_world_x = to_kernel(to_float(m.x)),
    patterned.texture_from_world_y = to_kernel(to_float(m.y));
    patterned.texture_from_world_z = to_kernel(to_float(m.z)),
    patterned.texture_from_world_t = to_kernel(to_float(m.t));
    patterned.first_layer = layers.first, patterned.layer_count = layers.count;
    patterned.ior = surface.interior.ior > 0 ? surface.interior.ior : 1;
    patterned.fade_distance = surface.interior.fade_distance;
    patterned.fade_power = surface.interior.fade_distance > 0 ? surface.interior.fade_power : 0;
    patterned.fade_color = to_kernel(surface.interior.fade_color);

    kernel::Material out{};
    out.flags = kernel::MATERIAL_PATTERNED;
    if (layers.transparent) out.flags |= kernel::MATERIAL_TRANSPARENT;
    if (layers.reflective) out.reflectance = {1, 1, 1};  // Only told to material_features; the layers say how much.
    if (layers.transparent) out.transmittance = {1, 1, 1};
    out.ior = patterned.ior;
    for (kernel::TextureRef* ref : {&out.diffuse_texture, &out.specular_texture, &out.emission_texture,
                                    &out.opacity_texture, &out.bump_texture, &out.normal_texture})
        ref->texture = kernel::NONE;
    out.patterned = static_cast<std::uint32_t>(out_.patterned.size());
    out_.patterned.push_back(patterned);
    return out;
}

void PatternCompiler::compile_sky() {
    for (const scene::Fog& fog : scene_.fogs) out_.fogs.push_back(kernel_fog(fog));
    for (const scene::SkySphere& sky : scene_.sky_spheres) {
        for (const auto& pigment : sky.pigments) {
            kernel::SkyLayer layer{};
            layer.program = program_of(*pigment);
            layer.sky_from_world_x = to_kernel(to_float(sky.sky_from_world.x));
            layer.sky_from_world_y = to_kernel(to_float(sky.sky_from_world.y));
            layer.sky_from_world_z = to_kernel(to_float(sky.sky_from_world.z));
            layer.emission = {sky.emission.r, sky.emission.g, sky.emission.b};
            out_.sky_layers.push_back(layer);
        }
    }
}

std::uint32_t pattern_features(const RenderScene& scene, const kernel::Material& material) {
    if ((material.flags & kernel::MATERIAL_PATTERNED) == 0) return 0;
    const kernel::PatternedMaterial& patterned = scene.patterned[material.patterned];
    std::uint32_t features = kernel::FEATURE_PATTERNED;
    for (std::uint32_t i = 0; i < patterned.layer_count; ++i)
        if (scene.layers[patterned.first_layer + i].uses_uv != 0) features |= kernel::FEATURE_TEXTURES;
    return features;
}

}  // namespace sundog
