// SPDX-License-Identifier: Apache-2.0
// Light that matt surfaces send each other, without noise: radiosity by form factors (Goral, Torrance, Greenberg and
// Battaile 1984), solved on coarse patches and then gathered by each vertex (substructuring: Cohen, Greenberg, Immel
// and Brock, An Efficient Radiosity Approach for Realistic Image Synthesis, IEEE CG&A 1986).
//
// All light is given as radiance; what a point receives, as irradiance over pi: the mean radiance of its view, weighted
// by form factors.
#pragma once

#include <functional>
#include <span>

#include "bake/form_factors.h"
#include "base/progress.h"

namespace sundog::bake {

/// Of each vertex, by its sides.
struct SurfaceLight {
    std::vector<Sides<Vec3>> source;  ///< Radiance that it sends out before any exchange.
    std::vector<Sides<Vec3>> reflectance;
};

/// How light at vertices makes up light at triangles, and that what is told of the groups that they are in: by area,
/// but for what a wall that stands on them parts from their middle, to which rays go. So no light leaks through walls,
/// nor is what is behind one taken for what is seen.
struct Weights {
    std::vector<std::array<float, 3>> corners;  ///< Of each triangle's vertices; they add up to 1.
    std::vector<float> left;                    ///< Of the first child of each of FormFactors::tree()'s nodes, of 1.
};
Weights weights_of(const FormFactors& factors, const Surfaces& surfaces);

/// Radiance of the nodes of factors.tree(), then of factors.divided(), where vertices receive that much.
std::vector<Sides<Vec3>> radiance_of_nodes(const FormFactors& factors, const Surfaces& surfaces, const Weights& weights,
                                           const SurfaceLight& light, std::span<const Sides<Vec3>> received);

/// What patches have told each other.
struct Exchanged {
    std::vector<Sides<Vec3>> nodes;     ///< As radiance_of_nodes(), all bounces but the last counted.
    std::vector<Sides<Vec3>> received;  ///< Of each vertex: what the patches around it receive.
    bool stopped = false;  ///< Early: `received` is then an ambient term, the same for all, and `nodes` the source.
};

/// Called now and then with the share that is done.
using ShareSink = std::function<void(double)>;

/// Exchanges light between the patches (groups of neighbouring triangles that face one way), bounce by bounce, until
/// the next would change less than a ten-thousandth of all light, at most `bounces` times (one or more). Where it is
/// stopped before form factors are known, what is missing is estimated as in progressive refinement (Cohen, Chen,
/// Wallace and Greenberg, SIGGRAPH 1988): as if all surfaces saw each other by their areas. The same bits for any
/// number of threads: those of the calling oneTBB arena.
Exchanged exchange(const FormFactors& factors, const Surfaces& surfaces, const SurfaceLight& light, int bounces,
                   const ShareSink& progress, const StopFlag& stop);

/// One more bounce, to each vertex itself instead of its patch, on the side that `back` tells (0 or 1, for each
/// vertex): sets `received` to what comes from `nodes`. False if stopped; some vertices then keep what they had.
bool gather(const FormFactors& factors, const Surfaces& surfaces, std::span<const Sides<Vec3>> nodes,
            std::span<const std::uint8_t> back, std::span<Vec3> received, const ShareSink& progress,
            const StopFlag& stop);

}  // namespace sundog::bake
