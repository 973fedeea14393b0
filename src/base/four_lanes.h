// SPDX-License-Identifier: Apache-2.0
// Four numbers that go through one computation side by side: what waits for its own results does so for all of them at
// once.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sundog {

/// True or false for each of four numbers.
struct FourTruths {
    using Pair = std::int64_t __attribute__((vector_size(16)));
    Pair low, high;

    [[nodiscard]] bool operator[](std::size_t i) const { return (i < 2 ? low[i] : high[i - 2]) != 0; }
    friend FourTruths operator&(const FourTruths& a, const FourTruths& b) { return {a.low & b.low, a.high & b.high}; }
    friend FourTruths operator|(const FourTruths& a, const FourTruths& b) { return {a.low | b.low, a.high | b.high}; }
    friend FourTruths operator~(const FourTruths& a) { return {~a.low, ~a.high}; }
};

struct FourLanes {
    using Pair = double __attribute__((vector_size(16)));
    Pair low, high;

    FourLanes(double all) : low{all, all}, high{all, all} {}  // NOLINT(google-explicit-constructor): a constant
    FourLanes(Pair l, Pair h) : low(l), high(h) {}
    FourLanes(double a, double b, double c, double d) : low{a, b}, high{c, d} {}

    [[nodiscard]] double operator[](std::size_t i) const { return i < 2 ? low[i] : high[i - 2]; }
    friend FourLanes operator+(const FourLanes& a, const FourLanes& b) { return {a.low + b.low, a.high + b.high}; }
    friend FourLanes operator-(const FourLanes& a, const FourLanes& b) { return {a.low - b.low, a.high - b.high}; }
    friend FourLanes operator*(const FourLanes& a, const FourLanes& b) { return {a.low * b.low, a.high * b.high}; }
    friend FourLanes operator/(const FourLanes& a, const FourLanes& b) { return {a.low / b.low, a.high / b.high}; }
    friend FourTruths operator<(const FourLanes& a, const FourLanes& b) { return {a.low < b.low, a.high < b.high}; }
    friend FourTruths operator<=(const FourLanes& a, const FourLanes& b) { return {a.low <= b.low, a.high <= b.high}; }
};

inline bool any(const FourTruths& t) { return (t.low[0] | t.low[1] | t.high[0] | t.high[1]) != 0; }
inline FourLanes choose(const FourTruths& t, const FourLanes& a, const FourLanes& b) {
    return {t.low ? a.low : b.low, t.high ? a.high : b.high};
}
inline FourLanes larger(const FourLanes& a, const FourLanes& b) {
    return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}
inline FourLanes lesser(const FourLanes& a, const FourLanes& b) {
    return {b.low < a.low ? b.low : a.low, b.high < a.high ? b.high : a.high};
}

// The same for one number.
inline bool any(bool t) { return t; }
inline double choose(bool t, double a, double b) { return t ? a : b; }
inline double larger(double a, double b) { return a > b ? a : b; }

}  // namespace sundog
