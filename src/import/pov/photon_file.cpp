// SPDX-License-Identifier: Apache-2.0
#include "import/pov/photon_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "base/text_file.h"
#include "import/pov/kept_file.h"

namespace sundog::pov {
namespace {

constexpr std::string_view kFormat = "sundog photons 1\n";
constexpr std::size_t kFloats = 12;
constexpr std::size_t kBytes = kFloats * 4;

std::array<float, kFloats> floats_of(const StoredPhoton& p) {
    return {p.position.x, p.position.y, p.position.z, p.direction.x, p.direction.y, p.direction.z,
            p.normal.x,   p.normal.y,   p.normal.z,   p.power.x,     p.power.y,     p.power.z};
}

void append(const std::vector<StoredPhoton>& photons, std::string& out) {
    for (const StoredPhoton& photon : photons)
        for (const float value : floats_of(photon)) append_float(value, out);
}

StoredPhoton photon_at(const char* bytes) {
    std::array<float, kFloats> v{};
    for (std::size_t i = 0; i < kFloats; ++i) v[i] = float_at(bytes + i * 4);
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, {v[9], v[10], v[11]}};
}

/// Writes to a file once it is asked to, whole or not at all.
class PhotonFile final : public PhotonStore {
public:
    explicit PhotonFile(std::filesystem::path file) : file_(std::move(file)) {}
    void keep(const StoredPhotons& photons) const override { write_kept_file(file_, photon_file_bytes(photons)); }

private:
    std::filesystem::path file_;
};

}  // namespace

std::string photon_file_bytes(const StoredPhotons& photons) {
    std::string bytes(kFormat);
    bytes += std::to_string(photons.surface.size()) + " " + std::to_string(photons.media.size()) + "\n";
    bytes.reserve(bytes.size() + (photons.surface.size() + photons.media.size()) * kBytes);
    append(photons.surface, bytes);
    append(photons.media, bytes);
    return bytes;
}

StoredPhotons photons_of_bytes(std::string_view bytes) {
    if (!bytes.starts_with(kFormat)) throw std::runtime_error("not a file of photons that Sundog has saved");
    bytes.remove_prefix(kFormat.size());
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    std::uint32_t surface = 0, media = 0;
    const char* const end = line.data() + line.size();
    const auto [blank, first_error] = std::from_chars(line.data(), end, surface);
    const bool second = first_error == std::errc{} && blank != end && *blank == ' ';
    if (!second || std::from_chars(blank + 1, end, media).ptr != end || line.size() == bytes.size())
        throw std::runtime_error("it doesn't say how many photons it holds");
    bytes.remove_prefix(line.size() + 1);
    const std::uint64_t count = std::uint64_t{surface} + media;
    if (bytes.size() != count * kBytes)
        throw std::runtime_error("it is not as long as its " + std::to_string(count) + " photons");
    StoredPhotons photons;
    photons.surface.reserve(surface);
    photons.media.reserve(media);
    for (std::uint64_t i = 0; i < count; ++i) {
        const StoredPhoton photon = photon_at(bytes.data() + i * kBytes);
        const std::array<float, kFloats> v = floats_of(photon);
        if (!std::all_of(v.begin(), v.end(), [](float x) { return std::isfinite(x); }))
            throw std::runtime_error("photon " + std::to_string(i + 1) + " is no place, directions and power");
        (i < surface ? photons.surface : photons.media).push_back(photon);
    }
    return photons;
}

std::shared_ptr<const StoredPhotons> load_photons(BuildContext& context, std::string_view name, Place where) {
    const std::string bytes = read_kept_file(context, name, where, "photons");
    try {
        return std::make_shared<const StoredPhotons>(photons_of_bytes(bytes));
    } catch (const std::runtime_error& error) {
        context.fail(where, "can't read the file of photons " + in_quotes(name), error.what());
    }
}

std::shared_ptr<const PhotonStore> photon_store(BuildContext& context, std::string_view name, Place where) {
    return std::make_shared<const PhotonFile>(kept_file(context, name, where));
}

}  // namespace sundog::pov
