// SPDX-License-Identifier: Apache-2.0
// Participating media, as POV-Ray describes them (its reference, section 3.4.8 "Media").
#pragma once

#include <memory>
#include <vector>

#include "base/diagnostics.h"
#include "base/vec.h"

namespace sundog::scene {

struct Pigment;

/// Particles in the air or in an object. Colours are linear RGB per unit of length, times the product of the densities.
struct Medium {
    SourceLocation where;
    Vec3 absorption, emission, scattering;
    int scattering_type = 1;  ///< 1 isotropic, 2 haze, 3 murky, 4 Rayleigh, 5 Henyey and Greenstein.
    float eccentricity = 0;   ///< Of type 5: above 0 light goes on, below it goes back.
    float extinction = 1;     ///< How much of the scattered light is lost.
    std::vector<std::shared_ptr<const Pigment>> densities;  ///< Multiplied; none: 1 everywhere.
    int method = 3;
    int intervals = 1;
    int samples = 10, samples_most = 10;  ///< At least and at most, for each interval.
    int aa_level = 3;           ///< Method 3: how often the way between two samples is halved where they differ …
    float aa_threshold = 0.1F;  ///< … by more than this.
    float jitter = 0;           ///< How far samples are moved off their places, as a share of the way to the next one.
    float variance = 1.0F / 128, confidence = 0.9F;  ///< Method 1: how well its random samples are to know the mean.
    bool collects_photons = true;
    float ratio = 0.9F;  ///< Share of the intervals that is in what spots light, where any do.
};

}  // namespace sundog::scene
