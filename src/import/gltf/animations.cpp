// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/animations.h"

#include <algorithm>
#include <set>
#include <string>

#include "import/gltf/accessor.h"

namespace sundog::import::gltf {
namespace {

using scene::KeyframeTrack;

/// What a channel moves: a node's number in the file, and which of its properties.
struct Target {
    std::size_t node = 0;
    std::string path;
    auto operator<=>(const Target&) const = default;
};

/// Nothing for channels that move nothing of ours.
std::optional<Target> target_of(Asset& asset, const Json& channel) {
    const Json target = channel.required("target");
    const auto node = target.index_or_none("node", asset.list("nodes").size(), "nodes");
    const Json path = target.required("path");
    const std::string_view name = path.string();
    if (name != "translation" && name != "rotation" && name != "scale" && name != "weights") {
        asset.warn_once("path " + std::string(name), path, "animations of " + in_quotes(name) + " are not played");
        return std::nullopt;
    }
    if (!node) return std::nullopt;
    return Target{*node, std::string(name)};
}

KeyframeTrack::Interpolation interpolation_of(const Json& sampler) {
    const Json mode = sampler.member("interpolation");
    const std::string_view name = mode ? mode.string() : "LINEAR";
    if (name == "LINEAR") return KeyframeTrack::Interpolation::linear;
    if (name == "STEP") return KeyframeTrack::Interpolation::step;
    if (name != "CUBICSPLINE")
        mode.fail("unknown interpolation " + in_quotes(name), "expected one of: LINEAR, STEP, CUBICSPLINE");
    return KeyframeTrack::Interpolation::cubic;
}

/// How many weights a node's mesh has.
std::size_t weight_count(Asset& asset, const Json& node) {
    const auto index = node.index_or_none("mesh", asset.list("meshes").size(), "meshes");
    if (!index) return 0;
    const Json primitives = asset.list("meshes")[*index].member("primitives");
    std::size_t count = 0;
    for (std::size_t i = 0; i < primitives.size(); ++i) count = std::max(count, primitives[i].member("targets").size());
    return count;
}

KeyframeTrack read_track(Asset& asset, const Json& sampler, std::size_t width, bool weights) {
    KeyframeTrack track;
    track.interpolation = interpolation_of(sampler);
    track.width = width;
    const Json input = sampler.required("input");
    track.times_s = read_numbers(asset, input, {{"SCALAR"}, false}).values;
    if (track.times_s.empty()) input.fail("an animation without keys");
    const auto bad = std::adjacent_find(track.times_s.begin(), track.times_s.end(), std::greater_equal<>());
    if (bad != track.times_s.end())
        input.fail("the times don't rise from key " + std::to_string(bad - track.times_s.begin()) + " to the next");
    const Json output = sampler.required("output");
    const char* const type = weights ? "SCALAR" : width == 4 ? "VEC4" : "VEC3";
    track.values = read_numbers(asset, output, {{type}, false}).values;
    const std::size_t values_of_key = track.interpolation == KeyframeTrack::Interpolation::cubic ? 3 * width : width;
    if (track.values.size() != track.times_s.size() * values_of_key)
        output.fail("has " + std::to_string(track.values.size()) + " numbers for " +
                    std::to_string(track.times_s.size()) + " keys of " + std::to_string(values_of_key));
    return track;
}

}  // namespace

WeightTracks read_animations(Asset& asset, NodeGraph& graph) {
    WeightTracks weight_tracks;
    std::set<Target> moved;
    const Json animations = asset.list("animations");
    for (std::size_t i = 0; i < animations.size(); ++i) {
        const Json channels = animations[i].required("channels");
        const Json samplers = animations[i].required("samplers");
        std::vector<std::optional<Target>> targets;
        for (std::size_t c = 0; c < channels.size(); ++c) targets.push_back(target_of(asset, channels[c]));
        const bool taken =
            std::any_of(targets.begin(), targets.end(), [&](const auto& t) { return t && moved.contains(*t); });
        if (taken) {
            asset.warn_once("animations", animations[i],
                            "the animation moves what an earlier one does, and is not played");
            continue;
        }
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const Json sampler = samplers[channels[c].required_index("sampler", samplers.size(), "samplers")];
            if (!targets[c]) continue;
            const Target& target = *targets[c];
            if (!moved.insert(target).second)
                channels[c].fail("two channels move the " + target.path + " of nodes[" + std::to_string(target.node) +
                                 ']');
            const Json node_json = asset.list("nodes")[target.node];
            const bool weights = target.path == "weights";
            const std::size_t width = weights ? weight_count(asset, node_json) : target.path == "rotation" ? 4 : 3;
            if (width == 0) continue;
            if (!weights && node_json.member("matrix")) {
                asset.warn_once("matrix", channels[c], "a node that is placed by a matrix can't be animated");
                continue;
            }
            KeyframeTrack track = read_track(asset, sampler, width, weights);
            graph.tree->duration_s = std::max(graph.tree->duration_s, track.times_s.back());
            const scene::Index node = graph.tree_index[target.node];
            scene::AnimatedNode& animated = graph.tree->nodes[node];
            if (weights) weight_tracks.emplace(node, std::move(track));
            else if (target.path == "rotation") animated.rotations = std::move(track);
            else if (target.path == "translation") animated.translations = std::move(track);
            else animated.scales = std::move(track);
        }
    }
    return weight_tracks;
}

}  // namespace sundog::import::gltf
