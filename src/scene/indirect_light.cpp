// SPDX-License-Identifier: Apache-2.0
#include "scene/indirect_light.h"

namespace sundog::scene {

Photons photons_for(int count) {
    Photons photons;
    photons.count = count;
    photons.find_targets = true;
    // Places within all of their share of a pattern: else its rings show where glass spreads them.
    photons.jitter = 1;
    // Half as far as is guessed: light spreads less into what is dark beside it, behind thin walls too.
    photons.radius_factor = 0.5F;
    return photons;
}

Radiosity radiosity_for(int rays) {
    Radiosity radiosity;
    radiosity.count = rays;
    radiosity.recursion_limit = 4;
    radiosity.error_bound = 0.5F;
    radiosity.pretrace_end = 0.02F;
    return radiosity;
}

}  // namespace sundog::scene
