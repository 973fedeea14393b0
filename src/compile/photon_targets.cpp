// SPDX-License-Identifier: Apache-2.0
#include "compile/photon_targets.h"

#include <algorithm>
#include <map>

#include "compile/materials_of.h"

namespace sundog {
namespace {

using scene::PhotonSwitch;

/// What mirrors less of the light that meets it head-on isn't worth shooting at: the gloss of plastic has 0.04.
constexpr float kLeastMirror = 0.1F;
/// Of targets that are found, so many at most are shot at one by one.
constexpr std::size_t kMostFound = 256;

// What a material does with light: bits of a MaterialUse.
using MaterialUse = std::uint8_t;
constexpr MaterialUse kReflects = 1, kRefracts = 2;
constexpr MaterialUse kShows = 4;         ///< Photons light it.
constexpr MaterialUse kLetsStraight = 8;  ///< Light passes it straight on,
constexpr MaterialUse kStops = 16;        ///< or much of it doesn't pass.

std::uint32_t object_flags(const scene::ObjectPhotons& photons) {
    return (photons.refraction == PhotonSwitch::on ? kernel::PHOTONS_REFRACT : 0U) |
           (photons.refraction == PhotonSwitch::off ? kernel::PHOTONS_NEVER_REFRACT : 0U) |
           (photons.reflection == PhotonSwitch::on ? kernel::PHOTONS_REFLECT : 0U) |
           (photons.reflection == PhotonSwitch::off ? kernel::PHOTONS_NEVER_REFLECT : 0U) |
           (photons.collect ? kernel::PHOTONS_COLLECT : 0U);
}

float largest(const kernel::vec3& v) { return std::max({v.x, v.y, v.z}); }

MaterialUse use_of(const RenderScene& scene, const kernel::Material& m) {
    bool shows = largest(m.diffuse) > 0;
    float mirrors = largest(m.reflectance);
    float ior = m.ior;
    const bool passes = (m.flags & kernel::MATERIAL_TRANSPARENT) != 0;
    if (passes && (m.flags & kernel::MATERIAL_FRESNEL) != 0) {
        const float root = (ior - 1) / (ior + 1);
        mirrors *= root * root;
    }
    if ((m.flags & kernel::MATERIAL_PATTERNED) != 0) {
        const kernel::PatternedMaterial& patterned = scene.patterned[m.patterned];
        shows = true;
        ior = scene.interiors[patterned.interior].ior;
        for (std::uint32_t i = 0; i < patterned.layer_count; ++i)
            mirrors = std::max(mirrors, largest(scene.layers[patterned.first_layer + i].reflection_max));
    }
    // What light passes straight through is the shadow rays' business.
    const bool refracts = passes && ior != 1;
    const bool reflects = mirrors >= (refracts ? 1e-3F : kLeastMirror);
    const bool straight = passes && ior == 1;
    // Nearer to all than to nothing.
    const bool mostly = largest(m.transmittance) >= 0.5F &&
                        scene.material_maps[m.maps].opacity.texture == kernel::NONE &&
                        (m.flags & kernel::MATERIAL_VERTEX_ALPHA) == 0;
    MaterialUse uses = straight && mostly ? 0 : kStops;
    if (reflects) uses |= kReflects;
    if (refracts) uses |= kRefracts;
    if (shows) uses |= kShows;
    if (straight) uses |= kLetsStraight;
    return uses;
}

}  // namespace

std::uint32_t photon_flags(const scene::LightPhotons& photons) {
    return (photons.refraction == PhotonSwitch::on ? kernel::LIGHT_PHOTONS_REFRACT : 0U) |
           (photons.refraction == PhotonSwitch::off ? kernel::LIGHT_PHOTONS_NEVER_REFRACT : 0U) |
           (photons.reflection == PhotonSwitch::on ? kernel::LIGHT_PHOTONS_REFLECT : 0U) |
           (photons.reflection == PhotonSwitch::off ? kernel::LIGHT_PHOTONS_NEVER_REFLECT : 0U) |
           (photons.area_light ? kernel::LIGHT_PHOTONS_AREA : 0U);
}

PhotonTargets::PhotonTargets(const scene::Scene& scene, RenderScene& out) : scene_(scene), out_(out) {
    if (!scene.photons) return;
    constexpr std::size_t kMost = (1U << (32U - kernel::PHOTONS_TARGET_SHIFT)) - 1;
    if (finds_targets()) find_targets();
    numbers_.resize(scene.objects.size());
    std::map<std::uint32_t, std::uint32_t> wholes;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        const auto number = static_cast<std::uint32_t>(i);
        const scene::ObjectPhotons& photons = photons_at(number);
        if (!photons.target || is_passed(number) || object.projects > 0 || out.photon_targets.size() == kMost) continue;
        const auto next = static_cast<std::uint32_t>(out.photon_targets.size() + 1);
        numbers_[i] = photons.whole == 0 ? next : wholes.try_emplace(photons.whole, next).first->second;
        if (numbers_[i] == next) out.photon_targets.push_back({{}, {}, photons.spacing, object_flags(photons)});
        else out.photon_targets[numbers_[i] - 1].flags |= found_.empty() ? 0U : object_flags(photons);
    }
}

bool PhotonTargets::finds_targets() const {
    return scene_.photons->find_targets && !scene_.photons->loaded &&
           std::none_of(scene_.objects.begin(), scene_.objects.end(),
                        [](const scene::Object& object) { return object.photons->target; });
}

void PhotonTargets::find_targets() {
    material_uses_.reserve(out_.materials.size());
    for (const kernel::Material& m : out_.materials) material_uses_.push_back(use_of(out_, m));
    found_.reserve(scene_.objects.size());
    std::uint32_t wholes = 0;
    for (const scene::Object& object : scene_.objects) {
        std::uint32_t uses = 0;
        for_each_material(object, [&](std::uint32_t material) {
            if (material < material_uses_.size()) uses |= material_uses_[material];
        });
        scene::ObjectPhotons photons = *object.photons;
        // What an object says of itself holds.
        const bool reflects = (uses & kReflects) != 0 && photons.reflection != PhotonSwitch::off;
        const bool refracts = (uses & kRefracts) != 0 && photons.refraction != PhotonSwitch::off;
        const bool lets_straight = (uses & kLetsStraight) != 0 && photons.refraction != PhotonSwitch::off;
        photons.target = reflects || refracts;
        if (reflects) photons.reflection = PhotonSwitch::on;
        if (refracts || lets_straight) photons.refraction = PhotonSwitch::on;
        photons.collect = photons.collect && (uses & kShows) != 0;
        // Panes in the way to a target let photons pass: untinted, for those that meet anything else first are dropped.
        if (lets_straight && (uses & kStops) == 0 && !photons.target && !photons.pass_through)
            photons.pass_through = true;
        if (photons.target) {
            // What goes by one name is one thing, as GeometryList has it; and there are not too many of them.
            const scene::Object* before = found_.empty() ? nullptr : &object - 1;
            const bool continues = before != nullptr && found_.back().target && before->name == object.name;
            if (!continues && wholes < kMostFound) ++wholes;
            photons.whole = wholes;
        }
        found_.push_back(photons);
    }
}

const scene::ObjectPhotons& PhotonTargets::photons_at(std::uint32_t object) const {
    return found_.empty() ? *scene_.objects[object].photons : found_[object];
}

bool PhotonTargets::is_passed(std::uint32_t number) const {
    const scene::Object& object = scene_.objects[number];
    // As in povray, what the camera doesn't see photons don't see either.
    return photons_at(number).pass_through.value_or(!object.casts_shadow) || !object.seen_by_camera;
}

std::uint32_t PhotonTargets::hidden_from(std::uint32_t number) const {
    if (numbers_.empty() || !is_passed(number)) return 0;
    // pass_through is for the way to a target alone; what casts no shadow is not there for the rest of it either.
    const scene::Object& object = scene_.objects[number];
    const bool altogether = !object.casts_shadow || !object.seen_by_camera;
    return kernel::RAY_PHOTON | (altogether ? kernel::RAY_LATER_PHOTON : 0U);
}

std::uint32_t PhotonTargets::photons_of(std::uint32_t object) const {
    if (numbers_.empty()) return 0;
    return object_flags(photons_at(object)) | numbers_[object] << kernel::PHOTONS_TARGET_SHIFT;
}

void PhotonTargets::add_bounds(std::uint32_t object, const Bounds3& bounds, std::uint32_t instance) {
    if (numbers_.empty() || numbers_[object] == 0) return;
    PhotonTarget& target = out_.photon_targets[numbers_[object] - 1];
    if (bounds.empty()) {
        if (endless_.empty() || endless_.back() != object) endless_.push_back(object);
        return;
    }
    Bounds3 met = bounds;
    const auto* mesh = std::get_if<Boxed<scene::Mesh>>(&scene_.objects[object].shape);
    if (!found_.empty() && mesh != nullptr) {
        // A room and the glass in it may be one mesh.
        met = {};
        for (const scene::Mesh::Triangle& t : (*mesh)->triangles) {
            if ((material_uses_[t.material] & (kReflects | kRefracts)) == 0) continue;
            for (const std::uint32_t p : t.position) met.include((*mesh)->positions[p]);
        }
    }
    if (instance == kernel::NONE) target.bounds.include(met);
    else target.moving.push_back({instance, met});
}

void PhotonTargets::finish(const WarningSink& warn) {
    const auto say = [&](const SourceLocation& where, const std::string& what, const std::string& hint) {
        if (warn) warn({Severity::warning, where, what, "", hint});
    };
    for (const std::uint32_t object : endless_) {
        if (found_.empty()) {
            out_.photon_targets[numbers_[object] - 1].bounds = {};
        } else {
            // Shadow rays bring the light through it, then.
            for (std::size_t i = 0; i < out_.geometries.size(); ++i)
                if (out_.geometry_objects[i] == object)
                    out_.geometries[i].photons &= (1U << kernel::PHOTONS_TARGET_SHIFT) - 1;
        }
        say(scene_.objects[object].where,
            "photons can't be shot at '" + scene_.objects[object].name + "': it has no end",
            found_.empty() ? "bounded_by gives it one" : "");
    }
    if (!scene_.photons || !scene_.photons->find_targets || scene_.photons->loaded) return;
    if (out_.photon_targets.empty())
        say(scene_.photons->where, "no photons are shot: nothing in the scene mirrors or refracts light", "");
    else if (scene_.lights.empty())
        say(scene_.photons->where, "no photons are shot: the scene has no lamp, sun or spot to shoot them", "");
}

}  // namespace sundog
