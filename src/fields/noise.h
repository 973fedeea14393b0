// SPDX-License-Identifier: Apache-2.0
// The kernel's noise (kernel/patterns/noise.h) in double precision, with its gradient and bounds.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec3d.h"

namespace sundog::fields {

/// What the eight corners of a cell of the lattice add, corner x + 2y + 4z: shares of slopes and values are in them.
struct NoiseCell {
    std::array<std::array<double, 8>, 3> slope;
    std::array<double, 8> value;
};

/// Keeps the cells that were asked for last. One for each thread or ray.
class NoiseCells {
public:
    NoiseCells() { keys_.fill(kNone); }
    /// The cell whose lower corner is at lattice numbers x, y, z (0 to 2^24).
    const NoiseCell& at(std::uint32_t x, std::uint32_t y, std::uint32_t z);

private:
    static constexpr std::size_t kCount = 32;
    static constexpr std::uint64_t kNone = ~std::uint64_t{0};
    std::array<std::uint64_t, kCount> keys_;
    std::array<std::uint32_t, kCount> z_;
    std::array<NoiseCell, kCount> cells_;
};

struct NoiseSample {
    double value = 0;  ///< As it is before it is cut off at 0 and 1.
    Vec3d gradient;
};

/// Noise of generator 1 to 3 at a point, 0 to 1; within the kernel's rounding of noise_value().
double noise_at(NoiseCells& cells, Vec3d p, std::uint32_t generator);
/// The same before it is cut off at 0 and 1, with its gradient.
NoiseSample noise_with_gradient(NoiseCells& cells, Vec3d p, std::uint32_t generator);

/// Noise over a box: the sample at its centre, and how far the noise is from what value and gradient there say, at
/// most. Sound: by bounds of the second derivatives in the cells that the box touches.
struct NoiseOverBox {
    NoiseSample centre;
    double error = 0;
};
NoiseOverBox noise_over_box(NoiseCells& cells, Vec3d centre, Vec3d half_size, std::uint32_t generator);

/// The most that any first derivative of the noise can be.
double noise_slope_limit(std::uint32_t generator);

/// The kernel's turbulence_vector(), of 1 to 10 octaves.
Vec3d turbulence(Vec3d p, double lambda, double omega, double octaves);

}  // namespace sundog::fields
