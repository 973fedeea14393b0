// SPDX-License-Identifier: Apache-2.0
#include "mutate.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace sundog::fuzz {
namespace {

/// SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::size_t below(std::size_t bound) {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return static_cast<std::size_t>((z ^ (z >> 31U)) % std::max<std::size_t>(bound, 1));
    }

private:
    std::uint64_t state_;
};

constexpr std::array<std::string_view, 24> kPieces{
    "1e308", "-1e308",   "1e-320", "0",           "-1",        "4294967296",  "9223372036854775808",
    "nan",   "{",        "}",      "<",           ">",         "(",           ")",
    "[",     "]",        "#end",   "#macro M(A)", "#while(1)", "#declare X=", "\"",
    "/*",    "\xff\xfe", "union{"};

}  // namespace

std::string mutated(std::string text, std::span<const std::string> others, std::uint64_t seed) {
    constexpr std::size_t kMostChanges = 6, kLongestPart = 60;
    Random random(seed);
    const std::size_t changes = 1 + random.below(kMostChanges);
    for (std::size_t i = 0; i < changes; ++i) {
        const std::size_t at = random.below(text.size() + 1);
        const std::size_t length = std::min(random.below(kLongestPart), text.size() - at);
        switch (random.below(6)) {
            case 0:
                if (at < text.size()) text[at] = static_cast<char>(random.below(256));
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(random.below(text.size() + 1), length));
                break;
            case 3:
                text.insert(at, kPieces[random.below(kPieces.size())]);
                break;
            case 4:
                text.replace(at, length, kPieces[random.below(kPieces.size())]);
                break;
            default:
                if (!others.empty()) {
                    const std::string& other = others[random.below(others.size())];
                    text.insert(at, other.substr(random.below(other.size() + 1), length));
                }
        }
    }
    return text;
}

}  // namespace sundog::fuzz
