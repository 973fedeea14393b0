// SPDX-License-Identifier: Apache-2.0
// Photons as they are kept: what devices shoot, and what files hold of it.
#pragma once

#include <vector>

#include "base/vec.h"

namespace sundog {

/// A share of a light's flux that arrived somewhere. Flux is in units of (a light's colour) times (square length).
struct StoredPhoton {
    Vec3 position;
    Vec3 direction;  ///< Unit, in which it flew.
    Vec3 normal;     ///< Unit, of the surface that it met, on its side; zero in media.
    Vec3 power;      ///< Linear RGB. In media: flux times the length of the way that it stands for.
    friend bool operator==(const StoredPhoton&, const StoredPhoton&) = default;
};

/// All that lights shot at a scene.
struct StoredPhotons {
    std::vector<StoredPhoton> surface, media;
};

/// Where the photons of a scene are to be kept for later.
class PhotonStore {
public:
    PhotonStore() = default;
    PhotonStore(const PhotonStore&) = delete;
    PhotonStore& operator=(const PhotonStore&) = delete;
    virtual ~PhotonStore() = default;
    /// Called once the photons are shot. Errors: those of the store, for what can't be written.
    virtual void keep(const StoredPhotons& photons) const = 0;
};

}  // namespace sundog
