// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_density.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/files.h"

namespace sundog::pov {
namespace {

/// The largest file that is read, in bytes.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 31U;

std::shared_ptr<const scene::DensityGrid> decoded(const std::vector<unsigned char>& bytes) {
    constexpr std::size_t kHeader = 6;
    if (bytes.size() < kHeader) return nullptr;
    auto grid = std::make_shared<scene::DensityGrid>();
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        grid->size[axis] = static_cast<std::uint32_t>(bytes[2 * axis]) << 8U | bytes[2 * axis + 1];
        count *= grid->size[axis];
    }
    // The file's size says how wide its numbers are.
    const std::size_t data = bytes.size() - kHeader;
    const std::size_t width = count == 0 ? 0 : data >= 4 * count ? 4 : data >= 2 * count ? 2 : data >= count ? 1 : 0;
    if (width == 0) return nullptr;
    const double most = width == 4 ? 4294967295.0 : width == 2 ? 65535.0 : 255.0;
    grid->values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        double value = 0;
        for (std::size_t k = 0; k < width; ++k) value = value * 256 + bytes[kHeader + i * width + k];
        grid->values.push_back(static_cast<float>(value / most));
    }
    return grid;
}

}  // namespace

std::shared_ptr<const scene::DensityGrid> read_density_file(ItemReader& items) {
    const Place where = items.where();
    const std::string name = items.text("the name of a density file");
    BuildContext& context = items.context();
    const std::filesystem::path file = context.find_file(name, where);
    if (file.empty()) {
        context.warn(where, "missing density file '" + name + "'; its density is 0",
                     context.why_not_found(name, where));
        return nullptr;
    }
    const auto known = context.densities.find(file.string());
    if (known != context.densities.end()) return known->second;
    std::error_code error;
    std::vector<unsigned char> bytes;
    if (const auto size = std::filesystem::file_size(file, error); !error && size <= kMostBytes) {
        std::ifstream stream(file, std::ios::binary);
        bytes.resize(size);
        stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
        if (!stream) bytes.clear();
    }
    auto grid = decoded(bytes);
    if (!grid) context.warn(where, "'" + name + "' isn't a df3 file that can be read; its density is 0");
    scene::add_file(context.scene, file);
    context.densities.emplace(file.string(), grid);
    return grid;
}

}  // namespace sundog::pov
