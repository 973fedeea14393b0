// SPDX-License-Identifier: Apache-2.0
#include "compile/photon_targets.h"

#include <algorithm>
#include <map>

namespace sundog {
namespace {

using scene::PhotonSwitch;

/// Photons don't see such an object on their way to what they are shot at. As in povray, what the camera doesn't see
/// photons don't see either.
bool is_passed(const scene::Object& object) {
    return object.photons->pass_through.value_or(!object.casts_shadow) || !object.seen_by_camera;
}

std::uint32_t object_flags(const scene::ObjectPhotons& photons) {
    return (photons.refraction == PhotonSwitch::on ? kernel::PHOTONS_REFRACT : 0U) |
           (photons.refraction == PhotonSwitch::off ? kernel::PHOTONS_NEVER_REFRACT : 0U) |
           (photons.reflection == PhotonSwitch::on ? kernel::PHOTONS_REFLECT : 0U) |
           (photons.reflection == PhotonSwitch::off ? kernel::PHOTONS_NEVER_REFLECT : 0U) |
           (photons.collect ? kernel::PHOTONS_COLLECT : 0U);
}

}  // namespace

std::uint32_t hidden_from_photons(const scene::Object& object) {
    if (!is_passed(object)) return 0;
    // pass_through is for the way to a target alone; what casts no shadow is not there for the rest of it either.
    const bool altogether = !object.casts_shadow || !object.seen_by_camera;
    return kernel::RAY_PHOTON | (altogether ? kernel::RAY_LATER_PHOTON : 0U);
}

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
    numbers_.resize(scene.objects.size());
    std::map<std::uint32_t, std::uint32_t> wholes;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        const scene::ObjectPhotons& photons = *object.photons;
        if (!photons.target || is_passed(object) || object.projects > 0 || out.photon_targets.size() == kMost) continue;
        const auto next = static_cast<std::uint32_t>(out.photon_targets.size() + 1);
        numbers_[i] = photons.whole == 0 ? next : wholes.try_emplace(photons.whole, next).first->second;
        if (numbers_[i] == next) out.photon_targets.push_back({{}, photons.spacing, object_flags(photons)});
    }
}

std::uint32_t PhotonTargets::photons_of(std::uint32_t object) const {
    if (numbers_.empty()) return 0;
    return object_flags(*scene_.objects[object].photons) | numbers_[object] << kernel::PHOTONS_TARGET_SHIFT;
}

void PhotonTargets::add_bounds(std::uint32_t object, const Bounds3& bounds) {
    if (numbers_.empty() || numbers_[object] == 0) return;
    if (bounds.empty()) {
        if (endless_.empty() || endless_.back() != object) endless_.push_back(object);
        return;
    }
    out_.photon_targets[numbers_[object] - 1].bounds.include(bounds);
}

void PhotonTargets::finish(const WarningSink& warn) {
    for (const std::uint32_t object : endless_) {
        out_.photon_targets[numbers_[object] - 1].bounds = {};
        if (warn)
            warn({Severity::warning, scene_.objects[object].where,
                  "photons can't be shot at '" + scene_.objects[object].name + "': it has no end", "",
                  "bounded_by gives it one"});
    }
}

}  // namespace sundog
