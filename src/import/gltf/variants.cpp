// SPDX-License-Identifier: Apache-2.0
// KHR_materials_variants: other materials for the same meshes, by name.
#include <algorithm>

#include "import/gltf/materials.h"

namespace sundog::import::gltf {

std::vector<std::string> variant_names(Asset& asset) {
    std::vector<std::string> names;
    const Json extension = asset.root().extension("KHR_materials_variants");
    const Json list = extension ? extension.required("variants") : Json{};
    for (std::size_t i = 0; i < list.size(); ++i) names.emplace_back(list[i].required("name").string());
    return names;
}

std::optional<std::size_t> find_variant(Asset& asset, std::string_view name) {
    if (name.empty()) return std::nullopt;
    const std::vector<std::string> names = variant_names(asset);
    if (names.empty()) fail_file(asset.name(), "there is no variant " + in_quotes(name) + ": the file has none");
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    const std::vector<std::string_view> valid(names.begin(), names.end());
    std::string hint = suggest(name, valid);
    std::string all;
    for (const std::string_view one : valid) all += (all.empty() ? "" : ", ") + in_quotes(one);
    hint += (hint.empty() ? "the file has " : " the file has ") + all;
    fail_file(asset.name(), "there is no variant " + in_quotes(name), std::move(hint));
}

std::optional<std::size_t> material_of_variant(const Json& primitive, std::size_t variant, std::size_t count) {
    const Json extension = primitive.extension("KHR_materials_variants");
    const Json mappings = extension ? extension.required("mappings") : Json{};
    for (std::size_t i = 0; i < mappings.size(); ++i) {
        const Json variants = mappings[i].required("variants");
        for (std::size_t k = 0; k < variants.size(); ++k)
            if (variants[k].whole() == variant) return mappings[i].required_index("material", count, "materials");
    }
    return std::nullopt;
}

}  // namespace sundog::import::gltf
