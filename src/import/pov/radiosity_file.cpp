// SPDX-License-Identifier: Apache-2.0
#include "import/pov/radiosity_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "import/pov/kept_file.h"

namespace sundog::pov {
namespace {

constexpr std::string_view kFormat = "sundog radiosity 1\n";
constexpr std::size_t kFloats = 28;
constexpr std::size_t kBytes = 4 + kFloats * 4;
constexpr std::uint32_t kMostBounces = 20;

/// All of a sample's vectors, in their order in the file.
template <class Sample, class Visit>
void for_each_vector(Sample& sample, const Visit& visit) {
    visit(sample.position), visit(sample.normal), visit(sample.light);
    for (auto& by : sample.by_move) visit(by);
    for (auto& by : sample.by_turn) visit(by);
}

StoredIrradiance sample_at(const char* bytes) {
    StoredIrradiance stored;
    stored.bounce = word_at(bytes);
    bytes += 4;
    bool finite = true;
    const auto next = [&] {
        const float value = float_at(bytes);
        bytes += 4;
        finite = finite && std::isfinite(value);
        return value;
    };
    stored.sample.reach = next();
    for_each_vector(stored.sample, [&](Vec3& v) { v.x = next(), v.y = next(), v.z = next(); });
    const float size = length(stored.sample.normal);
    if (!finite || !(stored.sample.reach > 0) || !(size > 0.9F && size < 1.1F) || stored.bounce >= kMostBounces)
        throw std::runtime_error("it holds something else than samples of light");
    return stored;
}

class RadiosityFile final : public RadiosityStore {
public:
    explicit RadiosityFile(std::filesystem::path file) : file_(std::move(file)) {}
    void keep(const StoredRadiosity& samples) const override { write_kept_file(file_, radiosity_file_bytes(samples)); }

private:
    std::filesystem::path file_;
};

}  // namespace

std::string radiosity_file_bytes(const StoredRadiosity& samples) {
    std::string bytes(kFormat);
    bytes += std::to_string(samples.size()) + "\n";
    bytes.reserve(bytes.size() + samples.size() * kBytes);
    for (const StoredIrradiance& stored : samples) {
        append_word(stored.bounce, bytes);
        append_float(stored.sample.reach, bytes);
        for_each_vector(stored.sample, [&](const Vec3& v) {
            for (const float value : {v.x, v.y, v.z}) append_float(value, bytes);
        });
    }
    return bytes;
}

StoredRadiosity radiosity_of_bytes(std::string_view bytes) {
    if (!bytes.starts_with(kFormat)) throw std::runtime_error("not a file of radiosity that Sundog has saved");
    bytes.remove_prefix(kFormat.size());
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    std::uint32_t count = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
    if (error != std::errc{} || end != line.data() + line.size() || line.size() == bytes.size())
        throw std::runtime_error("it doesn't say how many samples it holds");
    bytes.remove_prefix(line.size() + 1);
    if (bytes.size() != std::uint64_t{count} * kBytes)
        throw std::runtime_error("it is not as long as its " + std::to_string(count) + " samples");
    StoredRadiosity samples;
    samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) samples.push_back(sample_at(bytes.data() + i * kBytes));
    return samples;
}

std::shared_ptr<const StoredRadiosity> load_radiosity(BuildContext& context, std::string_view name, Place where) {
    const std::string bytes = read_kept_file(context, name, where, "radiosity");
    try {
        return std::make_shared<const StoredRadiosity>(radiosity_of_bytes(bytes));
    } catch (const std::runtime_error& error) {
        context.fail(where, "can't read the file of radiosity " + in_quotes(name), error.what());
    }
}

std::shared_ptr<const RadiosityStore> radiosity_store(BuildContext& context, std::string_view name, Place where) {
    return std::make_shared<const RadiosityFile>(kept_file(context, name, where));
}

}  // namespace sundog::pov
