// SPDX-License-Identifier: Apache-2.0
// Numbers and blanks in line-based text, at the speed of the memory. Everything here reads from a pointer into text
// that ends with a newline (read_text_file sees to it), so no function needs to know where the text ends.
#pragma once

#include <cstdint>

namespace sundog {

/// Space, tab and the carriage return before a newline; never the newline itself.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool ends_token(char c) { return is_blank(c) || c == '\n'; }

/// What became of a number.
enum class Scan : std::uint8_t {
    ok,
    malformed,  ///< No number starts here, or its value isn't finite ("nan", "inf").
    too_large,  ///< A number, but beyond the type's range.
};

namespace scan_detail {
/// 10^0 to 10^22, all exact in double.
inline constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                          1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
/// The general case; `first` is after the sign, `last` after the number.
Scan scan_float_slowly(const char* first, const char* last, float& magnitude);
/// True where rounding the double `d` to float gives what rounding the decimal that it stands for would: not on the
/// middle between two floats (where the double's own rounding may have hidden the side), and in the normal range.
bool rounds_once(double d);
}  // namespace scan_detail

/// Reads a decimal number with optional sign, fraction and exponent and moves `at` behind it (only if Scan::ok).
/// The result is the float nearest to the decimal, ties to even; too small a number is 0 or subnormal. What follows
/// the number is the caller's to judge.
inline Scan scan_float(const char*& at, float& value) {
    const char* p = at;
    const bool negative = *p == '-';
    if (*p == '-' || *p == '+') ++p;
    const char* const first = p;
    std::uint64_t mantissa = 0;
    for (; is_digit(*p); ++p) mantissa = mantissa * 10 + static_cast<unsigned>(*p - '0');
    auto digits = p - first;
    std::int32_t exponent = 0;
    if (*p == '.') {
        const char* const fraction = ++p;
        for (; is_digit(*p); ++p) mantissa = mantissa * 10 + static_cast<unsigned>(*p - '0');
        const auto length = p - fraction;
        digits += length;
        exponent = length > 10000 ? -10000 : -static_cast<std::int32_t>(length);
    }
    if (digits == 0) return Scan::malformed;
    if (*p == 'e' || *p == 'E') {
        const char* q = p + 1;
        const bool down = *q == '-';
        if (*q == '-' || *q == '+') ++q;
        if (!is_digit(*q)) return Scan::malformed;
        std::int32_t written = 0;
        for (; is_digit(*q); ++q)
            if (written < 100000) written = written * 10 + (*q - '0');
        exponent += down ? -written : written;
        p = q;
    }
    float magnitude = 0;
    // Clinger 1990, "How to read floating point numbers accurately": integers under 2^53 and powers of ten up to
    // 10^22 are exact, so one operation rounds correctly. More than 19 digits may have overflowed the mantissa.
    const bool exact = digits <= 19 && mantissa < (std::uint64_t{1} << 53U) && exponent >= -22 && exponent <= 22;
    const auto whole = static_cast<double>(mantissa);
    const double d = !exact         ? 0
                     : exponent < 0 ? whole / scan_detail::kPowersOfTen[-exponent]
                                    : whole * scan_detail::kPowersOfTen[exponent];
    if (exact && (mantissa == 0 || scan_detail::rounds_once(d))) {
        magnitude = static_cast<float>(d);
    } else if (const Scan result = scan_detail::scan_float_slowly(first, p, magnitude); result != Scan::ok) {
        return result;
    }
    value = negative ? -magnitude : magnitude;
    at = p;
    return Scan::ok;
}

/// Reads a decimal integer with optional sign and moves `at` behind it (only if Scan::ok).
inline Scan scan_int(const char*& at, std::int32_t& value) {
    const char* p = at;
    const bool negative = *p == '-';
    if (*p == '-' || *p == '+') ++p;
    if (!is_digit(*p)) return Scan::malformed;
    std::int64_t magnitude = 0;
    for (; is_digit(*p); ++p)
        if (magnitude <= INT32_MAX) magnitude = magnitude * 10 + (*p - '0');
    if (magnitude > INT32_MAX) return Scan::too_large;
    value = static_cast<std::int32_t>(negative ? -magnitude : magnitude);
    at = p;
    return Scan::ok;
}

}  // namespace sundog
