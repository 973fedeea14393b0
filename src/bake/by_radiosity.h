// SPDX-License-Identifier: Apache-2.0
// All light of all vertices from direct light and what surfaces make of it among themselves.
#pragma once

#include "bake/direct_light.h"

namespace sundog::bake {

/// Sets the parts' light. Surfaces that shine, but that paths can't aim at, send their light with the exchange. True if
/// stopped, by `direct` or since; what is missing is then that of patches, or an ambient term (exchange()).
bool by_radiosity(const scene::Scene& scene, const RenderScene& compiled, const Frame& frame, const DirectLight& direct,
                  const VertexPixels& pixels, const BakeOptions& options, std::vector<Part>& parts,
                  const ProgressSink& progress, const StopFlag& stop);

}  // namespace sundog::bake
