// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "compile/convert.h"
#include "compile/insides_at.h"
#include "compile/pattern_compiler.h"
#include "compile/quantile.h"
#include "fields/pigment_code.h"

namespace sundog {
namespace {

using scene::Pigment;
using scene::PigmentColor;

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

/// In the scene's units; a channel without any, in which povray's pictures are black, has hardly any.
kernel::vec3 translucency_of(const scene::Finish& finish, const scene::Scene& scene) {
    constexpr float kLeastMm = 1e-4F;
    const Vec3& t = finish.translucency;
    if (!scene.subsurface || !(std::max({t.x, t.y, t.z}) > 0)) return {0, 0, 0};
    const float unit = 1 / scene.mm_per_unit;
    return {std::max(t.x, kLeastMm) * unit, std::max(t.y, kLeastMm) * unit, std::max(t.z, kLeastMm) * unit};
}

kernel::Layer kernel_layer(const scene::TextureLayer& layer, std::uint32_t program) {
    const scene::Finish& f = layer.finish;
    kernel::Layer out{};
    out.program = program;
    out.flags =
        (f.reflection_fresnel ? kernel::LAYER_FRESNEL : 0U) | (f.conserve_energy ? kernel::LAYER_CONSERVE_ENERGY : 0U);
    if (layer.share) out.flags |= kernel::LAYER_PART;
    if (layer.first_part) out.flags |= kernel::LAYER_FIRST_PART;
    if (layer.parts_end) out.flags |= kernel::LAYER_PARTS_END;
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
    out.reflection_exponent = f.reflection_exponent > 0 ? f.reflection_exponent : 1;
    out.crand = f.crand;
    out.irid = f.irid, out.irid_thickness = f.irid_thickness, out.irid_turbulence = f.irid_turbulence;
    return out;
}

/// Samples of an interval, of method 1 at most. Povray's pictures show that method 3 has a sample for each two that are
/// asked for, and at least three; and that the other methods take more than one only where that is the least. There
/// povray takes as many as the samples' variance asks for, which method 2 has none of: it gets the mean of the least
/// and the most.
std::uint32_t samples_of_interval(const scene::Medium& m) {
    if (m.method == 3) return static_cast<std::uint32_t>(2 + std::max(m.samples, 3) / 2);
    if (m.method == 1)
        return static_cast<std::uint32_t>(m.samples < 2 || m.samples_most <= m.samples ? m.samples
                                                                                       : m.samples_most + 1);
    return static_cast<std::uint32_t>(m.samples <= 1 ? 1 : (m.samples + m.samples_most + 1) / 2);
}

constexpr int kMostColors = 1000;
/// Of povray's false caustics of an amount of 1, by its pictures of tilted panes.
constexpr float kCausticsExponent = 45;

bool reflects(const scene::Finish& f) { return !(f.reflection_min == Vec3{} && f.reflection_max == Vec3{}); }

std::uint32_t normal_kind(scene::PatternNormal::Kind kind) {
    using Kind = scene::PatternNormal::Kind;
    switch (kind) {
        case Kind::pattern:
            return kernel::NORMAL_PATTERN;
        case Kind::image:
            return kernel::NORMAL_IMAGE;
        case Kind::bumps:
            return kernel::NORMAL_BUMPS;
        case Kind::dents:
            return kernel::NORMAL_DENTS;
        case Kind::wrinkles:
            return kernel::NORMAL_WRINKLES;
        case Kind::ripples:
            return kernel::NORMAL_RIPPLES;
        case Kind::waves:
            return kernel::NORMAL_WAVES;
        case Kind::special:
            return kernel::NORMAL_QUILTED;
    }
    return kernel::NORMAL_BUMPS;
}

kernel::Fog kernel_fog(const scene::Fog& fog) {
    kernel::Fog out{};
    out.ground = fog.ground ? 1 : 0;
    out.distance = fog.distance;
    out.color = {fog.color.r, fog.color.g, fog.color.b};
    out.filter_share = fog.color.filter, out.transmit_share = fog.color.transmit;
    out.altitude = fog.altitude, out.offset = fog.offset;
    out.up = to_kernel(normalize(fog.up));
    out.turbulence = to_kernel(fog.turbulence);
    out.turb_depth = fog.turbulence == Vec3{} ? 0 : fog.turb_depth;
    out.lambda = fog.lambda, out.omega = fog.omega;
    out.octaves = static_cast<std::uint32_t>(fog.octaves);
    out.noise_generator = static_cast<std::uint32_t>(fog.noise_generator);
    return out;
}

}  // namespace

std::uint32_t PatternCompiler::program_of(const Pigment& pigment, const Pigment* weight) {
    const auto start = static_cast<std::uint32_t>(out_.code.size());
    fields::write_pigment_code(pigment, out_.code, *host_, weight, &programs_);
    publish_programs();
    return start;
}

std::uint32_t PatternCompiler::point_program_of(const scene::PatternNormal& part) {
    if (part.pattern.warps.empty()) return kernel::NONE;
    const auto start = static_cast<std::uint32_t>(out_.code.size());
    fields::write_point_code(part.pattern, part.where, out_.code, *host_, &programs_);
    publish_programs();
    return start;
}

void PatternCompiler::publish_programs() {
    out_.program_ops = programs_.ops, out_.program_fields = programs_.fields;
    if (!host_->empty()) out_.host_fields = host_;
    out_.first_host_field = host_->first_where();
}

std::uint32_t PatternCompiler::normals_of(const scene::Normal& normal) {
    // The programs that the list names go before it.
    std::vector<std::array<std::uint32_t, 3>> programs;
    for (const scene::PatternNormal& part : normal.parts)
        programs.push_back({part.weight ? program_of(*part.weight) : kernel::NONE,
                            part.height ? program_of(*part.height) : kernel::NONE, point_program_of(part)});
    const auto start = static_cast<std::uint32_t>(out_.code.size());
    const auto put = [&](double value) {
        out_.code.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    };
    const auto put_vector = [&](const Vec3d& v) { put(v.x), put(v.y), put(v.z); };
    out_.code.push_back(static_cast<std::uint32_t>(normal.parts.size()));
    for (std::size_t i = 0; i < normal.parts.size(); ++i) {
        const scene::PatternNormal& part = normal.parts[i];
        const scene::Pattern& pattern = part.pattern;
        using Kind = scene::PatternNormal::Kind;
        out_.code.push_back(programs[i][0]);
        const bool special = part.kind == Kind::special;
        const bool facets = special && pattern.kind == scene::Pattern::Kind::facets;
        out_.code.push_back(facets ? kernel::NORMAL_FACETS : normal_kind(part.kind));
        if (special) programs_.fields |= 1U << (facets ? kernel::FIELD_FACETS : kernel::FIELD_QUILTED);
        put(facets ? 1 : part.amount);
        out_.code.push_back(facets ? 2 : part.keeps_depth ? 1 : 0);
        out_.code.push_back(part.kind == Kind::dents ? fields::noise_generator_of(pattern)
                            : special                ? host_->add_shared(fields::make_host_normal(pattern))
                                                     : programs[i][1]);
        if (part.kind == Kind::pattern) put(std::max(part.accuracy, 1e-5)), put(0);
        else if (part.kind == Kind::image) put(part.texel_u), put(part.texel_v);
        else if (facets) put(pattern.facet_coords), put(pattern.facet_size);
        else if (special) put(pattern.control0), put(pattern.control1);
        else put(pattern.frequency), put(pattern.phase);
        const bool stirred = !(pattern.turbulence == Vec3d{});
        put(pattern.lambda), put(pattern.omega);
        out_.code.push_back(stirred ? static_cast<std::uint32_t>(std::clamp(pattern.octaves, 1, 10)) : 0);
        // Warps count for where the pattern is, not for where its normals point.
        Affine3d m = pattern.pattern_from_texture;
        for (auto step = pattern.warps.rbegin(); step != pattern.warps.rend(); ++step) m = m * step->warp_from_before;
        put_vector(m.x), put_vector(m.y), put_vector(m.z), put_vector(m.t);
        put_vector(pattern.turbulence);
        out_.code.push_back(programs[i][2]);
    }
    publish_programs();
    return start;
}

std::uint32_t PatternCompiler::media_of(const std::vector<scene::Medium>& media, const Affine3d& medium_from_world) {
    // Surfaces that share one interior must have the same list: rays leave it by any of them.
    std::string key;
    const scene::Medium* const first = media.data();
    key.append(reinterpret_cast<const char*>(&first),
               sizeof(first));  // NOLINT(bugprone-sizeof-expression): its address
    key.append(reinterpret_cast<const char*>(&medium_from_world), sizeof(medium_from_world));
    const auto [known, is_new] = media_.try_emplace(std::move(key), kernel::NONE);
    if (!is_new) return known->second;
    out_.has_media = out_.has_media || !media.empty();
    std::vector<std::uint32_t> densities;  // Where each medium's list of programs is.
    for (const scene::Medium& medium : media) {
        std::vector<std::uint32_t> programs;
        for (const auto& density : medium.densities) programs.push_back(program_of(*density));
        densities.push_back(static_cast<std::uint32_t>(out_.code.size()));
        out_.code.insert(out_.code.end(), programs.begin(), programs.end());
    }
    known->second = static_cast<std::uint32_t>(out_.code.size());
    const auto put = [&](float value) { out_.code.push_back(std::bit_cast<std::uint32_t>(value)); };
    const auto put_color = [&](Vec3 c) { put(c.x), put(c.y), put(c.z); };
    out_.code.push_back(static_cast<std::uint32_t>(media.size()));
    for (const Vec3d& column : {medium_from_world.x, medium_from_world.y, medium_from_world.z, medium_from_world.t})
        put_color(to_float(column));
    put(static_cast<float>(MediaBound(media, scene_.textures).most()));
    out_.code.push_back(kernel::NONE);
    media_lists_.push_back({known->second, media, medium_from_world});
    for (std::size_t i = 0; i < media.size(); ++i) {
        const scene::Medium& m = media[i];
        put_color(m.absorption), put_color(m.emission), put_color(m.scattering);
        put(m.extinction), put(m.eccentricity);
        out_.code.push_back(static_cast<std::uint32_t>(m.scattering_type));
        out_.code.push_back(static_cast<std::uint32_t>(m.densities.size()));
        out_.code.push_back(densities[i]);
        out_.code.push_back(samples_of_interval(m));
        out_.code.push_back(static_cast<std::uint32_t>(m.method));
        out_.code.push_back(
            static_cast<std::uint32_t>(std::clamp(m.aa_level, 1, static_cast<int>(kernel::MAX_HALVINGS))));
        put(m.aa_threshold);
        out_.code.push_back(static_cast<std::uint32_t>(std::max(m.intervals, 1)));
        put(m.jitter), put(m.ratio);
        out_.code.push_back(m.collects_photons ? 1 : 0);
        out_.code.push_back(static_cast<std::uint32_t>(std::max(m.samples, 1)));
        put(m.variance), put(static_cast<float>(normal_quantile(1 - std::clamp(m.confidence, 0.0F, 0.999999F))));
    }
    return known->second;
}

const PatternCompiler::Layers& PatternCompiler::layers_of(const scene::Material& material) {
    const scene::LayeredTexture& texture = *material.patterned->texture;
    const bool colorless = material.patterned->color.has_value();
    const auto [found, is_new] = compiled_.try_emplace({&texture, colorless});
    Layers& layers = found->second;
    if (!is_new) return layers;
    if (texture.layers.size() > kernel::MAX_LAYERS)
        throw InputError({Severity::error, material.where,
                          "a texture of " + std::to_string(texture.layers.size()) + " layers; at most " +
                              std::to_string(kernel::MAX_LAYERS) + " can be drawn",
                          "", "leave out the lowest"});
    layers.first = static_cast<std::uint32_t>(out_.layers.size());
    layers.count = static_cast<std::uint32_t>(texture.layers.size());
    layers.transparent = true;                    // as long as every layer over another lets light through
    bool before_parts = true, some_part = false;  // Of parts side by side, one that does is enough.
    for (auto layer = texture.layers.rbegin(); layer != texture.layers.rend(); ++layer) {
        const std::uint32_t program = colorless ? kernel::NONE : program_of(*layer->pigment, layer->share.get());
        out_.layers.push_back(kernel_layer(*layer, program));
        out_.layers.back().normal = kernel::NONE;
        out_.layers.back().translucency = translucency_of(layer->finish, scene_);
        layers.subsurface = layers.subsurface || out_.layers.back().translucency.x > 0;
        if (layer->normal && !layer->normal->is_flat()) {
            out_.layers.back().normal = normals_of(*layer->normal);
            out_.layers.back().normal_uses_uv = layer->normal->uv_mapping ? 1 : 0;
        }
        if (layer->first_part) before_parts = layers.transparent, some_part = false;
        else if (layer->share) some_part = some_part || layers.transparent;
        if (layer->share) layers.transparent = before_parts;
        layers.transparent = layers.transparent && lets_light_through(*layer->pigment, scene_.textures);
        if (layer->parts_end) layers.transparent = layers.transparent || some_part;
        layers.reflective = layers.reflective || reflects(layer->finish);
        layers.exponent = layers.exponent || (reflects(layer->finish) && out_.layers.back().reflection_exponent != 1);
        layers.backlit = layers.backlit || layer->finish.diffuse_back != 0;
    }
    return layers;
}

std::uint32_t PatternCompiler::interior_of(const scene::PatternedSurface& surface) {
    // The open air, and after it the interior of all objects that have none of their own: within glass, povray takes
    // them for bubbles of air.
    if (out_.interiors.empty()) out_.interiors.assign(kInteriorAround + 1, {1, 1, 0, {1, 1, 1}, 1, 1, 0, {0, 0, 0}});
    if (surface.interior_number == 0 && (!surface.interior || *surface.interior == scene::Interior{}))
        return kernel::INTERIOR_PLAIN;
    if (const auto known = interiors_.find(surface.interior_number);
        known != interiors_.end() && surface.interior_number != 0)
        return known->second;
    const scene::Interior& interior = *surface.interior;
    kernel::Interior out{};
    out.ior = interior.ior > 0 ? interior.ior : 1;
    out.fade_distance = interior.fade_distance > 0 ? interior.fade_distance : 1;
    out.fade_power = interior.fade_distance > 0 ? interior.fade_power : 0;
    out.fade_color = to_kernel(interior.fade_color);
    out.dispersion = interior.dispersion > 0 ? interior.dispersion : 1;
    out.dispersion_samples = static_cast<std::uint32_t>(std::clamp(interior.dispersion_samples, 2, kMostColors));
    out.caustics = kCausticsExponent * std::max(interior.caustics, 0.0F);
    // Beyond the numbers that rays can keep, objects share the last.
    const std::uint32_t count = copies_.count(surface.interior_number);
    if (out_.interiors.size() + count <= kernel::MAX_INTERIORS) out_.interiors.insert(out_.interiors.end(), count, out);
    const auto number = static_cast<std::uint32_t>(out_.interiors.size() - count);
    interiors_[surface.interior_number] = number;
    return number;
}

std::uint32_t PatternCompiler::light_set_of(std::uint32_t number) {
    std::uint32_t most = 0;
    for (const scene::Light& light : scene_.lights) most = std::max(most, light.group);
    if (most == 0 && scene_.light_sets.empty()) return 0;
    const auto [known, is_new] = light_sets_.try_emplace(number, static_cast<std::uint32_t>(out_.code.size()));
    if (!is_new) return known->second;
    constexpr std::uint32_t kBits = 32;
    const scene::LightSet set = number == 0 ? scene::LightSet{} : scene_.light_sets.at(number - 1);
    std::vector<std::uint32_t> words(most / kBits + 1);
    if (set.scene_lights) words[0] |= 1U;
    for (const std::uint32_t group : set.groups)
        if (group <= most) words[group / kBits] |= 1U << (group % kBits);
    out_.code.insert(out_.code.end(), words.begin(), words.end());
    return known->second;
}

kernel::Material PatternCompiler::compile_surface(const scene::Material& material) {
    const scene::PatternedSurface& surface = *material.patterned;
    const Layers& layers = layers_of(material);
    kernel::PatternedMaterial patterned{};
    const Affine3d& m = *surface.texture_from_world;
    patterned.texture_from_world_x = to_kernel(to_float(m.x)),
    patterned.texture_from_world_y = to_kernel(to_float(m.y));
    patterned.texture_from_world_z = to_kernel(to_float(m.z)),
    patterned.texture_from_world_t = to_kernel(to_float(m.t));
    patterned.first_layer = layers.first, patterned.layer_count = layers.count;
    patterned.interior = interior_of(surface);
    patterned.light_set = light_set_of(surface.light_set);
    patterned.double_illuminated = surface.double_illuminate ? 1 : 0;
    if (out_.interiors[patterned.interior].dispersion != 1)
        out_.only_on_cpu.push_back({material.where, "light is dispersed by the CPU only"});
    if (layers.subsurface)
        out_.only_on_cpu.push_back({material.where, "light below surfaces is drawn by the CPU only"});
    if (layers.exponent) out_.only_on_cpu.push_back({material.where, "reflection_exponent is for the CPU only"});

    patterned.medium = kernel::NONE;
    if (!surface.hollow) {
        patterned.medium = kernel::MEDIUM_SOLID;
    } else if (surface.interior && surface.interior->media && !surface.interior->media->empty()) {
        patterned.medium = media_of(*surface.interior->media, *surface.interior_from_world);
    }

    kernel::Material out{};
    out.flags = kernel::MATERIAL_PATTERNED;
    const bool transparent = surface.color ? lets_light_through(*surface.color) : layers.transparent;
    if (transparent) out.flags |= kernel::MATERIAL_TRANSPARENT;
    if (layers.backlit || surface.double_illuminate) out.flags |= kernel::MATERIAL_BACKLIT;
    if (layers.reflective) out.reflectance = {1, 1, 1};  // Only told to material_features; the layers say how much.
    if (transparent) out.transmittance = {1, 1, 1};
    out.ior = out_.interiors[patterned.interior].ior;
    out.patterned = static_cast<std::uint32_t>(out_.patterned.size());
    patterned.look = out.patterned;
    if (surface.color) {
        patterned.color = {surface.color->r, surface.color->g, surface.color->b};
        patterned.filtered = surface.color->filter, patterned.transmitted = surface.color->transmit;
        // Its one layer has no place.
        patterned.look =
            looks_.try_emplace({layers.first, patterned.light_set, patterned.double_illuminated}, out.patterned)
                .first->second;
    }
    out_.patterned.push_back(patterned);
    return out;
}

std::uint32_t PatternCompiler::rainbows() {
    if (scene_.rainbows.empty()) return kernel::NONE;
    std::vector<std::uint32_t> programs;
    for (const scene::Rainbow& bow : scene_.rainbows) programs.push_back(program_of(*bow.colors));
    const auto start = static_cast<std::uint32_t>(out_.code.size());
    out_.code.push_back(static_cast<std::uint32_t>(programs.size()));
    const auto put = [&](float value) { out_.code.push_back(std::bit_cast<std::uint32_t>(value)); };
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const scene::Rainbow& bow = scene_.rainbows[i];
        const Vec3 direction = normalize(bow.direction);
        const Vec3 up = normalize(bow.up - direction * dot(bow.up, direction));
        const float all_around = 4;
        // The arc ends sharply where no part of it fades out.
        const float arc = bow.arc_angle ? *bow.arc_angle / 2 : all_around;
        const float full = bow.arc_angle && bow.falloff_angle ? std::min(*bow.falloff_angle / 2, arc) : arc;
        for (const Vec3& v : {direction, up}) put(v.x), put(v.y), put(v.z);
        put(bow.angle), put(1 / bow.width), put(bow.distance), put(bow.jitter), put(arc), put(full);
        out_.code.push_back(programs[i]);
    }
    return start;
}

void PatternCompiler::compile_sky() {
    for (const scene::Fog& fog : scene_.fogs) out_.fogs.push_back(kernel_fog(fog));
    out_.rainbows = rainbows();
    out_.atmosphere = scene_.atmosphere.empty() ? kernel::NONE : media_of(scene_.atmosphere, {});
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
    if ((material.flags & kernel::MATERIAL_BACKLIT) != 0) features |= kernel::FEATURE_BACKLIT;
    if (scene.interiors[patterned.interior].dispersion != 1) features |= kernel::FEATURE_DISPERSION;
    if (scene.interiors[patterned.interior].caustics > 0) features |= kernel::FEATURE_CAUSTICS;
    for (std::uint32_t i = 0; i < patterned.layer_count; ++i) {
        const kernel::Layer& layer = scene.layers[patterned.first_layer + i];
        if (layer.normal != kernel::NONE) features |= kernel::FEATURE_NORMALS;
        if (layer.translucency.x > 0) features |= kernel::FEATURE_SUBSURFACE;
        if (layer.reflection_exponent != 1) features |= kernel::FEATURE_EXPONENTS;
        if (layer.uses_uv != 0 || (layer.normal != kernel::NONE && layer.normal_uses_uv != 0))
            features |= kernel::FEATURE_TEXTURES;
    }
    return features;
}

}  // namespace sundog
