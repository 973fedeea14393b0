// SPDX-License-Identifier: Apache-2.0
// No structure: every ray is tested against everything, as in Whitted's "An Improved Illumination Model for Shaded
// Display" (Communications of the ACM 1980). What all others are measured by.
#include "device/accel/structure.h"

namespace sundog::accel {
namespace {

class NoStructure final : public Structure {
public:
    explicit NoStructure(const Primitives& primitives) : count_(primitives.size()) {}

    void walk(Search& search, Scratch&) const override {
        for (std::uint32_t item = 0; item < count_ && !search.done(); ++item) search.test(item);
    }
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

private:
    std::uint32_t count_;
};

}  // namespace

std::unique_ptr<Structure> make_no_structure(const Primitives& primitives) {
    return std::make_unique<NoStructure>(primitives);
}

}  // namespace sundog::accel
