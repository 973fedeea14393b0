// SPDX-License-Identifier: Apache-2.0
// Pigments into programs, textures of layers into the kernel's arrays.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "compile/interior_copies.h"
#include "compile/media_bound.h"
#include "device/render_scene.h"
#include "fields/host_fields.h"
#include "fields/pigment_code.h"
#include "scene/scene.h"

namespace sundog {

/// Compiles a scene's procedural surfaces into `patterned`, `layers` and `code` of a RenderScene, and its sky into
/// `sky_layers` and `fogs`. A texture that many surfaces share is compiled once.
class PatternCompiler {
public:
    /// All must outlive the compiler.
    PatternCompiler(const scene::Scene& scene, const InteriorCopies& copies, RenderScene& out)
        : scene_(scene), copies_(copies), out_(out), host_(std::make_shared<fields::HostFieldTable>(scene.textures)) {}

    /// The kernel's material for one whose `patterned` is set. Errors: InputError for more than MAX_LAYERS layers,
    /// pigment maps nested deeper than PROGRAM_SLOTS.
    kernel::Material compile_surface(const scene::Material& material);
    /// Sky spheres, fogs and the atmosphere's media. Errors as above.
    void compile_sky();
    /// A list of normals, into `code`.
    std::uint32_t normals_of(const scene::Normal& normal);
    /// All lists of media so far.
    [[nodiscard]] std::vector<MediaList> take_media_lists() { return std::move(media_lists_); }

private:
    struct Layers {
        std::uint32_t first = 0, count = 0;
        bool transparent = false, reflective = false, exponent = false, backlit = false, subsurface = false;
    };
    /// Its interior's number among the RenderScene's.
    std::uint32_t interior_of(const scene::PatternedSurface& surface);
    /// Where a light set's bits are in `code` (PatternedMaterial::light_set); `number` as PatternedSurface::light_set.
    std::uint32_t light_set_of(std::uint32_t number);
    const Layers& layers_of(const scene::Material& material);
    std::uint32_t program_of(const scene::Pigment& pigment, const scene::Pigment* weight = nullptr);
    /// Where a normal's pattern has warps: the program of its point; else NONE.
    std::uint32_t point_program_of(const scene::PatternNormal& part);
    /// Tells the RenderScene of what programs consist, and gives it the table of host fields, once there are any.
    void publish_programs();
    /// The rainbows, into `code`; NONE for none.
    std::uint32_t rainbows();
    /// A list of media, into `code`; NONE for none.
    std::uint32_t media_of(const std::vector<scene::Medium>& media, const Affine3d& medium_from_world);

    const scene::Scene& scene_;
    const InteriorCopies& copies_;
    RenderScene& out_;
    std::shared_ptr<fields::HostFieldTable> host_;
    fields::ShaderPrograms programs_;
    std::map<std::pair<const scene::LayeredTexture*, bool>, Layers> compiled_;  ///< With its own colours, or without.
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> looks_;  ///< By first layer, light set, double illumination.
    std::map<std::uint32_t, std::uint32_t> interiors_;             // By the scene's numbers.
    std::map<std::uint32_t, std::uint32_t> light_sets_;
    std::map<std::string, std::uint32_t> media_;  ///< By the list's address and place.
    std::vector<MediaList> media_lists_;
};

/// FEATURE_* bits that a material of layers needs; 0 for others.
std::uint32_t pattern_features(const RenderScene& scene, const kernel::Material& material);

}  // namespace sundog
