// SPDX-License-Identifier: Apache-2.0
// EXT_meshopt_compression.
#include <meshoptimizer.h>

#include "import/gltf/asset.h"

namespace sundog::import::gltf {
namespace {

/// The decoders' filters work on whole groups of four numbers or one; what the extension allows they can do in place.
void apply_filter(const Json& compression, std::vector<unsigned char>& bytes, std::size_t count, std::size_t stride) {
    const Json filter = compression.member("filter");
    const std::string_view name = filter ? filter.string() : "NONE";
    if (name == "NONE") return;
    if (name == "OCTAHEDRAL") {
        if (stride != 4 && stride != 8) filter.fail("a byteStride of " + std::to_string(stride), "4 or 8 is possible");
        meshopt_decodeFilterOct(bytes.data(), count, stride);
    } else if (name == "QUATERNION") {
        if (stride != 8) filter.fail("a byteStride of " + std::to_string(stride), "8 is possible");
        meshopt_decodeFilterQuat(bytes.data(), count, stride);
    } else if (name == "EXPONENTIAL") {
        meshopt_decodeFilterExp(bytes.data(), count, stride);
    } else {
        filter.fail("unknown filter " + in_quotes(name), "expected one of: NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL");
    }
}

}  // namespace

std::vector<unsigned char> decompress_meshopt(const Json& compression, Bytes compressed, Asset& asset) {
    constexpr std::size_t kMostStride = 256;
    // The densest coding takes two bits for sixteen bytes; headers are beside the point.
    constexpr std::size_t kMostBytesPerByte = 128;
    const std::size_t count = compression.required("count").whole(UINT32_MAX);
    const std::size_t stride = compression.required("byteStride").whole(kMostStride);
    const Json mode = compression.required("mode");
    if (stride == 0 || count * stride / kMostBytesPerByte > compressed.size())
        compression.fail(std::to_string(compressed.size()) + " bytes are too few for " + std::to_string(count) +
                         " elements of " + std::to_string(stride) + " bytes");
    asset.take_memory(count * stride, compression);
    std::vector<unsigned char> bytes(count * stride);
    int failed = 1;
    if (mode.string() == "ATTRIBUTES") {
        if (stride % 4 != 0)
            compression.fail("a byteStride of " + std::to_string(stride), "multiples of 4 are possible");
        failed = meshopt_decodeVertexBuffer(bytes.data(), count, stride, compressed.data(), compressed.size());
    } else if (mode.string() == "TRIANGLES" || mode.string() == "INDICES") {
        if (stride != 2 && stride != 4)
            compression.fail("a byteStride of " + std::to_string(stride), "2 or 4 is possible");
        const bool triangles = mode.string() == "TRIANGLES";
        if (triangles && count % 3 != 0) compression.fail("the number of indices is no multiple of 3");
        failed = triangles
                     ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, compressed.data(), compressed.size())
                     : meshopt_decodeIndexSequence(bytes.data(), count, stride, compressed.data(), compressed.size());
    } else {
        mode.fail("unknown mode " + in_quotes(mode.string()), "expected one of: ATTRIBUTES, TRIANGLES, INDICES");
    }
    if (failed != 0) compression.fail("the compressed data is damaged");
    if (mode.string() == "ATTRIBUTES") apply_filter(compression, bytes, count, stride);
    return bytes;
}

}  // namespace sundog::import::gltf
