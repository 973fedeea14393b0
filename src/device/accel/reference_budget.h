// SPDX-License-Identifier: Apache-2.0
// What keeps trees that divide space from taking memory without bound: an item that lies on both sides of a division is
// listed on both, and identical or overlapping items could go on doing so forever.
#pragma once

#include <cstdint>

namespace sundog::accel {

/// How many nodes and places of items a subtree may take. Shares depend on numbers of items alone, so they are the same
/// for every run.
class ReferenceBudget {
public:
    static ReferenceBudget for_items(std::uint32_t count) { return ReferenceBudget(16 + 10 * std::uint64_t{count}); }

    /// Whether `children` nodes with `references` places in all are affordable.
    [[nodiscard]] bool affords(std::uint64_t children, std::uint64_t references) const {
        return children + references <= places_;
    }
    /// The share of a child with `own` places when all children have `all` together; affords(children, all) must hold.
    [[nodiscard]] ReferenceBudget share(std::uint64_t children, std::uint64_t own, std::uint64_t all) const {
        const double spare = static_cast<double>(places_ - children - all);
        const double part = static_cast<double>(own) / static_cast<double>(all > 0 ? all : 1);
        return ReferenceBudget(own + static_cast<std::uint64_t>(spare * part));
    }

private:
    explicit ReferenceBudget(std::uint64_t places) : places_(places) {}
    std::uint64_t places_;
};

}  // namespace sundog::accel
