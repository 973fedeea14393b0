// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/photons.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/diagnostics.h"
#include "kernel/integrators/photon_shot.h"
#include "kernel/lights/light.h"
#include "kernel/lights/photon_flags.h"

namespace sundog::cpu {
namespace {

/// Photons of a piece, about.
constexpr std::uint32_t kPiece = 1024;
/// Of those that are shot before it is known whether a pattern goes on.
constexpr std::uint64_t kRound = 32768;
constexpr double kMostShot = 1e9;
/// Guessed radii, over those that as many photons take as are gathered at most: povray's are as wide.
constexpr float kWider = 6, kWiderInMedia = 3;
constexpr int kExpansions = 2;
/// Of a disc or ball that photons are spread over.
constexpr float kLeastSize = 1e-30F;

constexpr auto kPi = static_cast<float>(std::numbers::pi);

Vec3 from_kernel(const kernel::vec3& v) { return {v.x, v.y, v.z}; }
kernel::vec3 kernel_vec(const Vec3& v) { return {v.x, v.y, v.z}; }

/// True if a ray comes through a box.
bool meets(const Bounds3& box, const BatchPhoton& p) {
    float enter = 0, leave = 3e38F;
    const auto clip = [&](float origin, float direction, float low, float high) {
        const float inverse = 1 / direction;
        const float a = (low - origin) * inverse, b = (high - origin) * inverse;
        // Where it lies in a side's plane both are no numbers: then it may meet.
        if (a <= b || a > b) {
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
    };
    const Vec3 slack = (box.extent() + Vec3{1, 1, 1} * 1e-6F) * 1e-4F;
    const Vec3 low = box.lower - slack, high = box.upper + slack;
    clip(p.origin.x, p.direction.x, low.x, high.x);
    clip(p.origin.y, p.direction.y, low.y, high.y);
    clip(p.origin.z, p.direction.z, low.z, high.z);
    return enter <= leave;
}

/// How a spot's or a cylinder's light is spread, without its fading.
float spread_of(const kernel::Light& light, const BatchPhoton& p) {
    kernel::Light even = light;
    even.fade_power = 0;
    if (light.kind == kernel::LIGHT_SPOT) even.place = kernel_vec(p.origin);
    return light_share(even, kernel_vec(p.origin + p.direction), kernel_vec(p.direction * -1.0F), 1);
}

}  // namespace

Photons::Photons(const RenderScene& scene, const Frame& frame, const kernel::SceneView& view, PhotonKernel trace)
    : scene_(scene), frame_(frame), settings_(*frame.photons), view_(view), trace_(trace) {}

bool Photons::prepare(const StopFlag& stop) {
    if (settings_.loaded) {
        index(*settings_.loaded);
        return true;
    }
    for (std::uint32_t light = 0; light < frame_.params.light_count; ++light)
        for (std::uint32_t target = 1; target <= scene_.photon_targets.size(); ++target) add_shots(light, target);
    space_shots();
    StoredPhotons stored;
    for (;;) {
        std::vector<Piece> pieces;
        for (std::size_t shot = 0; shot < shots_.size(); ++shot) add_pieces(shot, pieces);
        if (pieces.empty()) break;
        std::vector<PhotonHarvest> harvests(pieces.size());
        tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
            if (!stop.requested()) harvests[i] = shoot(pieces[i]);
        });
        if (stop.requested()) return false;
        take(pieces, harvests, stored);
    }
    if (settings_.store) settings_.store->keep(stored);
    index(stored);
    return true;
}

void Photons::add_shots(std::uint32_t light_number, std::uint32_t target_number) {
    const kernel::Light& light = frame_.lights[light_number];
    const PhotonTarget& target = scene_.photon_targets[target_number - 1];
    if (settings_.targets[target_number - 1].empty()) return;
    if (!kernel::photons_reflect(target.flags, light.flags) && !kernel::photons_refract(target.flags, light.flags))
        return;
    const std::uint32_t columns = light.area_count_u, rows = light.area_count_v;
    if ((light.flags & kernel::LIGHT_PHOTONS_AREA) == 0 || columns * rows <= 1 || light.kind == kernel::LIGHT_CYLINDER)
        return add_shot(light_number, target_number, 1, target.spacing, from_kernel(light.place));
    const auto count = static_cast<float>(columns * rows);
    const Vec3 toward = normalize(from_kernel(light.place) - settings_.targets[target_number - 1].center());
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
        const float s = kernel::place_in_row(i % columns, columns), t = kernel::place_in_row(i / columns, rows);
        // As many photons for all of them together as for a point.
        add_shot(light_number, target_number, 1 / count, target.spacing * std::sqrt(count),
                 from_kernel(area_light_place(light, s, t, kernel_vec(toward))));
    }
}

void Photons::add_shot(std::uint32_t light_number, std::uint32_t target_number, float share, float spacing,
                       Vec3 place) {
    const kernel::Light& light = frame_.lights[light_number];
    const Bounds3& bounds = settings_.targets[target_number - 1];
    const Vec3 center = bounds.center();
    const float radius = 0.5F * length(bounds.extent());
    if (!(radius > 0)) return;
    Shot shot{light_number, target_number, share, spacing, {}, 0, false};
    if (light.kind == kernel::LIGHT_SUN) {
        // From before everything that may stand in the way.
        const float beyond = length(scene_.bounds.empty() ? Vec3{} : scene_.bounds.extent());
        shot.pattern = PhotonPattern::parallel(normalize(place) * -1.0F, 2 * radius + beyond, center, radius);
    } else if (light.kind == kernel::LIGHT_CYLINDER) {
        const Vec3 axis = from_kernel(light.axis);
        shot.pattern = PhotonPattern::parallel(axis, dot(center - place, axis), center, radius);
    } else {
        shot.pattern = PhotonPattern::from_point(place, center, radius);
    }
    shots_.push_back(shot);
}

void Photons::space_shots() {
    spacing_ = settings_.spacing;
    if (!(spacing_ > 0)) {
        double area = 0;
        for (const Shot& shot : shots_) area += shot.pattern.area() / (shot.spacing * shot.spacing);
        spacing_ = std::sqrt(area / std::max(settings_.count, 1));
    }
    double count = 0;
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        const double spacing = spacing_ * shots_[i].spacing;
        count += shots_[i].pattern.area() / (spacing * spacing);
        shots_[i].pattern.set_spacing(std::max(spacing, 1e-30), settings_.jitter, static_cast<std::uint32_t>(i));
    }
    if (!(count < kMostShot))
        throw DeviceError("the scene asks for " + std::to_string(std::llround(std::min(count, 1e18))) +
                          " photons; at most " + std::to_string(std::llround(kMostShot)) + " can be shot");
}

void Photons::add_pieces(std::size_t number, std::vector<Piece>& pieces) {
    Shot& shot = shots_[number];
    const bool may_stop = settings_.autostop < 1;
    std::uint64_t sum = 0;
    Piece piece{number, 0, 0, 0, 0};
    std::uint64_t in_piece = 0;
    const auto close = [&] {
        if (in_piece > 0) pieces.push_back(piece);
        in_piece = 0;
    };
    while (shot.next_ring < shot.pattern.ring_count() && (!may_stop || sum < kRound)) {
        const std::uint32_t ring = shot.next_ring++;
        const std::uint32_t count = shot.pattern.count_in(ring);
        sum += count;
        if (count >= 2 * kPiece) {
            close();
            for (std::uint32_t first = 0; first < count; first += kPiece)
                pieces.push_back({number, ring, ring, first, std::min(first + kPiece, count)});
            continue;
        }
        if (in_piece == 0) piece = {number, ring, ring, 0, count};
        piece.last_ring = ring;
        in_piece += count;
        // Where it may stop after a ring, rings are apart.
        if (may_stop || in_piece >= kPiece) close();
    }
    close();
}

std::vector<BatchPhoton> Photons::photons_of(const Piece& piece) const {
    const Shot& shot = shots_[piece.shot];
    const kernel::Light& light = frame_.lights[shot.light];
    const Bounds3& bounds = settings_.targets[shot.target - 1];
    const Vec3 color = from_kernel(light.color) * shot.share;
    std::vector<BatchPhoton> photons;
    for (std::uint32_t ring = piece.first_ring; ring <= piece.last_ring; ++ring) {
        const bool only = piece.first_ring == piece.last_ring;
        const std::uint32_t end = only ? piece.end_number : shot.pattern.count_in(ring);
        for (std::uint32_t i = only ? piece.first_number : 0; i < end; ++i) {
            BatchPhoton photon = shot.pattern.photon(ring, i);
            if (!meets(bounds, photon)) continue;
            photon.power = color * (photon.power.x * spread_of(light, photon));
            if (!(photon.power == Vec3{})) photons.push_back(photon);
        }
    }
    return photons;
}

PhotonHarvest Photons::shoot(const Piece& piece) const {
    const Shot& shot = shots_[piece.shot];
    const std::vector<BatchPhoton> photons = photons_of(piece);
    PhotonHarvest harvest;
    if (photons.empty()) return harvest;
    kernel::SceneView view = view_;
    const PhotonMapping::LightInsides& insides = settings_.insides[shot.light];
    std::copy(insides.media.begin(), insides.media.end(), std::begin(view.frame.eye_insides));
    view.frame.eye_interiors_inner = insides.interiors_inner;
    view.frame.eye_interiors_outer = insides.interiors_outer;
    kernel::PhotonShot kernel_shot;
    kernel_shot.light = shot.light;
    kernel_shot.target = shot.target;
    kernel_shot.max_depth = settings_.max_depth;
    kernel_shot.min_weight = settings_.min_weight;
    kernel_shot.media_steps = static_cast<std::uint32_t>(settings_.media_steps);
    kernel_shot.media_step = static_cast<float>(spacing_ * shot.spacing) * settings_.media_factor;
    trace_(view, kernel_shot, photons, harvest);
    return harvest;
}

void Photons::take(const std::vector<Piece>& pieces, std::vector<PhotonHarvest>& harvests, StoredPhotons& out) {
    const bool may_stop = settings_.autostop < 1;
    for (std::size_t i = 0; i < pieces.size();) {
        Shot& shot = shots_[pieces[i].shot];
        // All pieces of one ring.
        std::size_t end = i + 1;
        while (end < pieces.size() && pieces[end].shot == pieces[i].shot &&
               pieces[end].first_ring == pieces[i].first_ring)
            ++end;
        bool met = false;
        for (std::size_t k = i; k < end; ++k) {
            const PhotonHarvest& harvest = harvests[k];
            met = met || std::find(harvest.met.begin(), harvest.met.end(), 1) != harvest.met.end();
            rays_.rays += harvest.rays.rays;
            out.surface.insert(out.surface.end(), harvest.stored.surface.begin(), harvest.stored.surface.end());
            out.media.insert(out.media.end(), harvest.stored.media.begin(), harvest.stored.media.end());
            harvests[k] = {};
        }
        const std::uint32_t ring = pieces[i].first_ring;
        const bool stops =
            may_stop && shot.has_met && !met && shot.pattern.progress(ring) >= static_cast<double>(settings_.autostop);
        shot.has_met = shot.has_met || met;
        i = end;
        if (!stops) continue;
        shot.next_ring = shot.pattern.ring_count();
        while (i < pieces.size() && pieces[i].shot == pieces[end - 1].shot) ++i;
    }
}

void Photons::index(const StoredPhotons& photons) {
    surface_ = PhotonMap(photons.surface);
    media_ = PhotonMap(photons.media);
    const int most = settings_.gather_max;
    radius_ = settings_.radius > 0 ? settings_.radius : surface_.typical_radius(most) * kWider;
    media_radius_ = settings_.media_radius > 0 ? settings_.media_radius : media_.typical_radius(most) * kWiderInMedia;
    radius_ = std::max(radius_ * settings_.radius_factor, 1e-15F);
    media_radius_ = std::max(media_radius_ * settings_.media_radius_factor, 1e-12F);
}

namespace {

void set_answer(kernel::PhotonQuery& q, std::size_t lane, const PhotonMap::Found& found, float per_power,
                const Vec3& otherwise) {
    const Vec3 light = found.power * per_power;
    const Vec3 from = found.toward == Vec3{} ? otherwise : normalize(found.toward);
    q.red[lane] = light.x, q.green[lane] = light.y, q.blue[lane] = light.z;
    q.from_x[lane] = from.x, q.from_y[lane] = from.y, q.from_z[lane] = from.z;
}

}  // namespace

PhotonMap::Found Photons::gather(const PhotonMap& map, PhotonMap::Search search, int power,
                                 PhotonMap::Scratch& scratch) const {
    const auto density = [power](const PhotonMap::Found& found) {
        const Vec3& p = found.power;
        return (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)) /
               std::max(std::pow(found.radius, static_cast<float>(power)), kLeastSize);
    };
    PhotonMap::Found found = map.find(search, scratch);
    for (int i = 0; i < kExpansions && found.count < settings_.gather_min; ++i) {
        search.radius *= 2;
        const PhotonMap::Found wider = map.find(search, scratch);
        // Beyond a caustic's border there is more light than here.
        const bool denser = density(wider) > density(found) * (1 + settings_.expand_increase);
        if (denser && wider.count >= settings_.expand_min) break;
        found = wider;
    }
    return found;
}

void Photons::on_surface(kernel::PhotonQuery& q) const {
    PhotonMap::Scratch scratch;
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(q.lanes); ++lane) {
        const Vec3 normal{q.normal_x[lane], q.normal_y[lane], q.normal_z[lane]};
        PhotonMap::Found found;
        if (q.wanted[lane] != 0 && !surface_.empty())
            found = gather(surface_, {{q.x[lane], q.y[lane], q.z[lane]}, normal, settings_.gather_max, radius_}, 2,
                           scratch);
        const float area = kPi * found.radius * found.radius;
        set_answer(q, lane, found, found.count > 0 ? 1 / std::max(area, kLeastSize) : 0, normal);
    }
}

void Photons::in_medium(kernel::PhotonQuery& q) const {
    PhotonMap::Scratch scratch;
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(q.lanes); ++lane) {
        PhotonMap::Found found;
        if (q.wanted[lane] != 0)
            found = gather(media_, {{q.x[lane], q.y[lane], q.z[lane]}, {}, settings_.gather_max, media_radius_}, 3,
                           scratch);
        const float volume = 4 * kPi / 3 * found.radius * found.radius * found.radius;
        set_answer(q, lane, found, found.count > 0 ? 1 / std::max(volume, kLeastSize) : 0, {0, 0, 1});
    }
}

}  // namespace sundog::cpu
