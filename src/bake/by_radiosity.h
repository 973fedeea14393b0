// SPDX-License-Identifier: Apache-2.0
// All light of all vertices from direct light and what surfaces make of it among themselves.
#pragma once

#include "bake/direct_light.h"

namespace sundog::bake {

/// Sets the parts' light, to which `direct` is added what comes from surfaces that shine but weren't aimed at. True if
/// stopped, by `direct` or since; what is missing is then that of patches, or an ambient term (exchange()).
bool by_radiosity(const scene::Scene& scene, const Frame& frame, const ShiningSurfaces& shining, DirectLight direct,
                  const VertexPixels& pixels, const BakeOptions& options, std::vector<Part>& parts,
                  const ProgressSink& progress, const StopFlag& stop);

}  // namespace sundog::bake
