// SPDX-License-Identifier: Apache-2.0
// Words of a scene as small numbers.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace sundog::pov {

/// Number of a word. Below kKeywordCount it is the Keyword of that number, above it an identifier's name.
using NameId = std::uint32_t;

/// Gives every word that occurs a number of its own.
class Names {
public:
    Names();
    /// The number of `word`, which gets a new one where it is new. Errors: std::length_error after 16 million.
    NameId intern(std::string_view word);
    [[nodiscard]] std::string_view text(NameId id) const { return texts_[id]; }
    [[nodiscard]] std::size_t size() const { return texts_.size(); }

private:
    struct Slot {
        std::uint32_t hash = 0;
        NameId id = kFree;
    };
    static constexpr NameId kFree = ~NameId{0};
    Slot& slot_of(std::uint32_t hash, std::string_view word);
    void grow();
    void take(std::string_view word, NameId id);
    std::vector<Slot> slots_;
    std::size_t used_ = 0;
    std::deque<std::string> texts_;  ///< A deque, so that views of texts stay valid.
};

}  // namespace sundog::pov
