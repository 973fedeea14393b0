// SPDX-License-Identifier: Apache-2.0
// What devices are given: the compiled scene (fixed) and the frame (new for every picture).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/irradiance.h"
#include "base/photons.h"
#include "base/vec.h"
#include "device/camera_rays.h"
#include "kernel/shared.h"

namespace sundog {

namespace render_scene_detail {
// The kernel's types, under the names that kernel/arrays.h uses.
using namespace kernel;
struct Arrays {
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) std::vector<type> name;
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
};
}  // namespace render_scene_detail

namespace kernel {
class HostFields;
}
namespace solids {
class CompiledSolid;
}

/// The solid that a Geometry of kind GEOMETRY_SOLID stands for. Its hits' materials are indices into `materials`.
struct PlacedSolid {
    std::shared_ptr<const solids::CompiledSolid> solid;
    std::uint32_t geometry = 0;  ///< Index into `geometries`.
    SourceLocation where;        ///< Of the object in the scene's file.
    Bounds3 bounds;              ///< World space, at rest; infinite where it has no end.
};

/// What of a scene only the CPU device draws, and where the file asks for it.
struct CpuFeature {
    SourceLocation where;
    std::string sentence;
};

/// What photons are shot at: an object, or several as one.
struct PhotonTarget {
    /// What of it moves.
    struct Moving {
        std::uint32_t instance = 0;  ///< Into Frame::instances.
        Bounds3 bounds;              ///< In its own space.
    };
    Bounds3 bounds;  ///< World space, of what rests.
    std::vector<Moving> moving;
    float spacing = 1;        ///< Times that of the frame.
    std::uint32_t flags = 0;  ///< PHOTONS_*, without a number.
};

/// A mesh around something solid, whose triangles nobody sees from behind who isn't within its bounds.
struct ClosedMesh {
    std::uint32_t geometry = 0;
    Bounds3 bounds;  ///< In the space of its vertices.
};

/// A triangle or sphere whose material shines.
struct ShiningPrimitive {
    std::uint32_t geometry = 0, primitive = 0;
};

/// A compiled scene: the kernel's arrays (see kernel/arrays.h), immutable once made by compile(), shared by devices.
/// `materials` are those of the Scene, in its order.
struct RenderScene : render_scene_detail::Arrays {
    std::uint32_t features = 0;  ///< FEATURE_* bits that the scene itself needs (shadows and culling are the frame's).
    Bounds3 bounds;              ///< World bounds of all finite geometry at rest.
    std::vector<std::string> geometry_names;      ///< One for each of `geometries`; the scene object's name.
    std::vector<std::uint32_t> geometry_objects;  ///< One for each of `geometries`: index into Scene::objects.
    std::uint32_t program_ops = 0;                ///< OP_* that programs in `code` have, as bits.
    std::uint32_t program_fields = 0;             ///< FIELD_* likewise.
    std::uint32_t rainbows = kernel::NONE;        ///< A list of them in `code`.
    std::uint32_t atmosphere = kernel::NONE;      ///< Media that are everywhere: a list of them in `code`.
    bool has_media = false;                       ///< Some list of media in `code` isn't empty.
    std::vector<PlacedSolid> solids;              ///< Ascending by geometry.
    std::vector<ShiningPrimitive> shining;        ///< What paths may aim at.
    std::vector<ClosedMesh> closed_one_sided;     ///< Those with MATERIAL_ONE_SIDED; others set FEATURE_ONE_SIDED.
    kernel::Environment environment{};            ///< Its `probability` is the frame's; width 0: there is none.
    double environment_mean = 0;                  ///< Mean luminance of it over all directions.
    std::optional<SourceLocation> radiosity;      ///< Where the scene asks for it, if it does.
    std::optional<SourceLocation> photons;        ///< Where the scene asks for them, if it does.
    std::vector<PhotonTarget> photon_targets;     ///< By their numbers less one.
    /// Instead of the kernel's camera; null: the kernel's. Devices that can't ask it say so.
    std::shared_ptr<const CameraRays> camera_rays;
    std::uint32_t camera_normal = kernel::NONE;  ///< A list of normals, into `code`, that bends the camera's rays.
    std::string camera_feature;                  ///< What of the camera needs either of them; for messages.
    SourceLocation camera_where;
    /// Of which programs in `code` ask what only the host computes; null: none does.
    std::shared_ptr<const kernel::HostFields> host_fields;
    std::optional<SourceLocation> first_host_field;  ///< The first pattern that no shader computes, if there is one.
    std::vector<CpuFeature> only_on_cpu;             ///< Finishes and interiors.
};

/// Bytes of all arrays.
std::size_t memory_bytes(const RenderScene& scene);

/// How light that surfaces send each other is found by irradiance caching (Ward, Rubinstein and Clear, SIGGRAPH 1988);
/// names and meanings are those of POV-Ray's reference, section 3.4.4.3 "Radiosity".
struct IrradianceCaching {
    int count = 35;                 ///< Rays for each value; half as many at each further bounce.
    int recursion_limit = 2;        ///< Bounces.
    int nearest_count = 5;          ///< Values that must be at hand before no new one is gathered.
    float error_bound = 1.8F;       ///< Of a value where it is used: its share of error by Ward's estimate.
    float low_error_factor = 0.5F;  ///< Times error_bound while values are gathered.
    float minimum_reuse = 0.015F, maximum_reuse = 0.2F;  ///< A value's reach over the distance from the eye.
    float pretrace_start = 0.08F, pretrace_end = 0.04F;  ///< Sizes of steps over the picture's width.
    float gray_threshold = 0;                            ///< 0: light keeps its colour; 1: it is grey.
    float brightness = 1;
    float max_sample = 0;                           ///< Rays that bring more than this are dimmed to it; 0: none.
    float min_weight = 0.01F;                       ///< As FrameParams::min_weight, of rays that gather.
    bool bent_normals = false;                      ///< Patterned normals count.
    bool through_media = false;                     ///< Fog dims and tints what is gathered.
    bool always_sample = false;                     ///< Values are gathered while the picture is made, too.
    std::shared_ptr<const StoredRadiosity> loaded;  ///< Known from the start.
    std::shared_ptr<const RadiosityStore> store;    ///< Where they are kept once all are gathered; null: nowhere.
    friend bool operator==(const IrradianceCaching&, const IrradianceCaching&) = default;
};

/// How caustics are found by photons; names and meanings are those of POV-Ray's reference, section 3.4.4.4 "Photons".
struct PhotonMapping {
    /// What a light's place is inside of, in the forms of FrameParams::eye_insides and eye_interiors_*.
    struct LightInsides {
        std::array<std::uint32_t, kernel::MAX_MEDIA_INSIDES> media{};
        std::uint32_t interiors_inner = 0, interiors_outer = 0;
        friend bool operator==(const LightInsides&, const LightInsides&) = default;
    };
    float spacing = 0;  ///< Between photons where they are shot at something; 0: as `count` says.
    int count = 0;      ///< How many are shot.
    int gather_min = 20, gather_max = 100;
    int media_steps = 0;     ///< Most photons along a stretch of a medium; 0: none are stored there.
    float media_factor = 1;  ///< How much wider they stand there.
    float jitter = 0.4F;     ///< Share of the way to the next one by which they are moved.
    std::uint32_t max_depth = 0;
    float min_weight = 0;
    float autostop = 1;
    float expand_increase = 0.2F;  ///< A wider search doesn't count if it finds light denser by more than this …
    int expand_min = 40;           ///< … and at least so many photons.
    float radius = 0, radius_factor = 1, media_radius = 0, media_radius_factor = 1;  ///< Radius 0: guessed.
    std::vector<LightInsides> insides;                                               ///< For each light.
    std::vector<Bounds3> targets;                 ///< Where they are, by their numbers less one; empty: nowhere.
    std::shared_ptr<const StoredPhotons> loaded;  ///< Instead of shooting.
    std::shared_ptr<const PhotonStore> store;     ///< Where they are kept once shot; null: nowhere.
    friend bool operator==(const PhotonMapping&, const PhotonMapping&) = default;
};

/// Everything about a picture that is not the RenderScene. `lights`, `instances` and `emitters` are never empty (one
/// zeroed element stands in; params.light_count says how many lights count).
struct Frame {
    kernel::FrameParams params{};
    std::vector<kernel::Light> lights;
    std::vector<kernel::Instance> instances;        ///< As many as the scene's geometries refer to.
    std::vector<kernel::Emitter> emitters;          ///< Of INTEGRATOR_PATH: params.emitter_count says how many count.
    std::optional<IrradianceCaching> radiosity;     ///< Set where params.features has FEATURE_RADIOSITY.
    std::optional<PhotonMapping> photons;           ///< Set where params.features has FEATURE_PHOTONS.
    std::shared_ptr<const CameraRays> camera_rays;  ///< As in RenderScene, unless the caller has a camera of its own.
    std::uint32_t camera_normal = kernel::NONE;
};

}  // namespace sundog
