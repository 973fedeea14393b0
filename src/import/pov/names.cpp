// SPDX-License-Identifier: Apache-2.0
#include "import/pov/names.h"

#include <stdexcept>
#include <utility>

#include "import/pov/keywords.h"
#include "import/pov/tokens.h"

namespace sundog::pov {
namespace {

// FNV-1a (Fowler, Noll and Vo): words are short, and nothing shorter mixes as well.
std::uint32_t hash_of(std::string_view word) {
    std::uint32_t hash = 2166136261U;
    for (const char c : word) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash;
}

}  // namespace

Names::Names() : slots_(4096) {
    for (const std::string_view word : keyword_spellings()) {
        take(word, static_cast<NameId>(texts_.size()));
        texts_.emplace_back(word);
    }
}

void Names::take(std::string_view word, NameId id) {
    const std::uint32_t hash = hash_of(word);
    slot_of(hash, word) = {hash, id};
    ++used_;
}

Names::Slot& Names::slot_of(std::uint32_t hash, std::string_view word) {
    for (std::size_t i = hash & (slots_.size() - 1);; i = (i + 1) & (slots_.size() - 1)) {
        Slot& slot = slots_[i];
        if (slot.id == kFree || (slot.hash == hash && texts_[slot.id] == word)) return slot;
    }
}

void Names::grow() {
    std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(slots_.size() * 2));
    for (const Slot& slot : old) {
        if (slot.id == kFree) continue;
        std::size_t i = slot.hash & (slots_.size() - 1);
        while (slots_[i].id != kFree) i = (i + 1) & (slots_.size() - 1);
        slots_[i] = slot;
    }
}

NameId Names::intern(std::string_view word) {
    const std::uint32_t hash = hash_of(word);
    if (const Slot& slot = slot_of(hash, word); slot.id != kFree) return slot.id;
    // `colour` and its kin, which have no slots of their own.
    if (const auto keyword = find_keyword(word)) return static_cast<NameId>(*keyword);
    if (texts_.size() > kLargestPayload) throw std::length_error("more than 16 million different names");
    if (2 * ++used_ > slots_.size()) grow();
    const auto id = static_cast<NameId>(texts_.size());
    slot_of(hash, word) = {hash, id};
    texts_.emplace_back(word);
    return id;
}

}  // namespace sundog::pov
