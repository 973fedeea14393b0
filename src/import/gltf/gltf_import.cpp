// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/gltf_import.h"

#include "import/gltf/animations.h"
#include "import/gltf/materials.h"
#include "import/gltf/objects.h"
#include "import/gltf/views.h"

namespace sundog::import::gltf {

scene::Scene import_gltf(const std::filesystem::path& file, const WarningSink& warn, std::string_view variant) {
    scene::Scene scene;
    scene.name = file.stem().string();
    scene.ambient = {0, 0, 0};
    Asset asset(file, scene, warn);
    MeshReader meshes(asset, read_materials(asset), find_variant(asset, variant));
    scene.variants = variant_names(asset);
    NodeGraph graph = read_nodes(asset);
    const WeightTracks weights = read_animations(asset, graph);
    finish_nodes(graph);
    read_camera_of(asset, graph);
    read_lights(asset, graph);
    read_objects(asset, graph, weights, meshes);
    if (scene.materials.empty()) scene.materials.emplace_back().name = "default";
    if (scene.objects.empty())
        asset.warn(diagnose_file(Severity::warning, asset.name(), "the scene shows no triangles"));
    return scene;
}

}  // namespace sundog::import::gltf
