// SPDX-License-Identifier: Apache-2.0
// A box around each object. A ray is tested against all boxes; those that it enters are opened from near to far, until
// the nearest hit lies before the next box (Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986, without their
// hierarchy). What is in a box is tested one by one, so one big mesh gains little.
#include <algorithm>

#include "device/accel/structure.h"

namespace sundog::accel {
namespace {

class ObjectBoxes final : public Structure {
public:
    explicit ObjectBoxes(const Primitives& primitives) : objects_(primitives.objects()) {
        boxes_.reserve(objects_.size());
        for (const Run& object : objects_) {
            Bounds3& box = boxes_.emplace_back();
            for (std::uint32_t i = 0; i < object.count; ++i) box.include(primitives.bounds(object.first + i));
        }
    }

    void walk(Search& search, Scratch& scratch) const override {
        auto& entered = scratch.entered;
        entered.clear();
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            search.visit();
            const Interval inside = clip(boxes_[i], search.line(), search.range());
            if (!inside.empty()) entered.emplace_back(inside.enter, i);
        }
        std::sort(entered.begin(), entered.end());
        for (const auto& [enter, object] : entered) {
            if (enter > search.reach()) return;
            const Run& run = objects_[object];
            for (std::uint32_t i = 0; i < run.count && !search.done(); ++i) search.test(run.first + i);
        }
    }
    [[nodiscard]] std::size_t memory_bytes() const override {
        return objects_.capacity() * sizeof(Run) + boxes_.capacity() * sizeof(Bounds3);
    }

private:
    std::vector<Run> objects_;
    std::vector<Bounds3> boxes_;
};

}  // namespace

std::unique_ptr<Structure> make_object_boxes(const Primitives& primitives) {
    return std::make_unique<ObjectBoxes>(primitives);
}

}  // namespace sundog::accel
