// SPDX-License-Identifier: Apache-2.0
// Caustics by photon mapping, as POV-Ray's reference describes it (section 3.4.4.4 "Photons").
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "device/cpu/photon_batch.h"
#include "device/cpu/photon_map.h"
#include "device/cpu/photon_pattern.h"
#include "device/render_scene.h"
#include "kernel/lights/photon_query.h"

namespace sundog::cpu {

/// The photons of a scene. prepare() shoots them; after that, many threads may ask.
///
/// Each light's pattern is cut into pieces of a fixed size; all threads shoot them, and what they store is put together
/// in the pieces' order. So a picture's bits don't depend on the number of threads.
class Photons final : public kernel::PhotonLight {
public:
    /// `frame` has photons, `view` is its scene's; all outlive this.
    Photons(const RenderScene& scene, const Frame& frame, const kernel::SceneView& view, PhotonKernel trace);

    /// Shoots, or takes what was loaded. False if it was stopped: then this must not be used.
    /// Errors: DeviceError where there would be too many; those of the frame's store.
    bool prepare(const StopFlag& stop);
    /// What prepare() took.
    [[nodiscard]] BatchRays rays() const { return rays_; }

    void on_surface(kernel::PhotonQuery& query) const override;
    void in_medium(kernel::PhotonQuery& query) const override;
    [[nodiscard]] bool has_media() const override { return !media_.empty(); }

private:
    /// One light, or one point of an area light, and one target.
    struct Shot {
        std::uint32_t light = 0, target = 0;
        float share = 1;    ///< Of the light's colour.
        float spacing = 1;  ///< Times the frame's.
        PhotonPattern pattern;
        std::uint32_t next_ring = 0;  ///< That is to be shot.
        bool has_met = false;         ///< Some photon has met the target.
    };
    /// Photons that one thread shoots, of one or more rings.
    struct Piece {
        std::size_t shot = 0;
        std::uint32_t first_ring = 0, last_ring = 0;     ///< The last one included.
        std::uint32_t first_number = 0, end_number = 0;  ///< In the first ring, if it is the only one.
    };

    void add_shots(std::uint32_t light, std::uint32_t target);
    void add_shot(std::uint32_t light, std::uint32_t target, float share, float spacing, Vec3 place);
    /// Spaces the patterns by the frame's settings.
    void space_shots();
    /// The pieces of a shot's next rings; all, unless it may stop early.
    void add_pieces(std::size_t shot, std::vector<Piece>& pieces);
    [[nodiscard]] std::vector<BatchPhoton> photons_of(const Piece& piece) const;
    [[nodiscard]] PhotonHarvest shoot(const Piece& piece) const;
    /// Puts together what pieces have brought.
    void take(const std::vector<Piece>& pieces, std::vector<PhotonHarvest>& harvests, StoredPhotons& out);
    void index(const StoredPhotons& photons);
    /// The photons near a point, in a radius that grows where they are few. `power` of the radius is
    /// what they are spread over.
    [[nodiscard]] PhotonMap::Found gather(const PhotonMap& map, PhotonMap::Search search, int power,
                                          PhotonMap::Scratch& scratch) const;

    const RenderScene& scene_;
    const Frame& frame_;
    const PhotonMapping& settings_;
    kernel::SceneView view_;
    PhotonKernel trace_;
    std::vector<Shot> shots_;
    double spacing_ = 0;
    PhotonMap surface_, media_;
    float radius_ = 0, media_radius_ = 0;
    BatchRays rays_;
};

}  // namespace sundog::cpu
