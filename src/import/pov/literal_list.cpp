// SPDX-License-Identifier: Apache-2.0
#include "import/pov/literal_list.h"

#include <charconv>
#include <cmath>

#include "base/scan.h"

namespace sundog::pov {

double scan_number(const char*& at) {
    const char* p = at;
    std::uint64_t mantissa = 0;
    for (; is_digit(*p); ++p) mantissa = mantissa * 10 + static_cast<unsigned>(*p - '0');
    std::ptrdiff_t digits = p - at;
    std::ptrdiff_t exponent = 0;
    if (*p == '.') {
        const char* const fraction = ++p;
        for (; is_digit(*p); ++p) mantissa = mantissa * 10 + static_cast<unsigned>(*p - '0');
        exponent = fraction - p;
        digits += p - fraction;
    }
    const char* const before_exponent = p;
    if (*p == 'e' || *p == 'E') {
        const char* q = p + 1;
        const bool down = *q == '-';
        if (*q == '-' || *q == '+') ++q;
        if (is_digit(*q)) {
            std::ptrdiff_t written = 0;
            for (; is_digit(*q); ++q)
                if (written < 100000) written = written * 10 + (*q - '0');
            exponent += down ? -written : written;
            p = q;
        }
    }
    // Clinger 1990: integers under 2^53 and powers of ten up to 10^22 are exact, so one operation rounds correctly.
    if (digits <= 19 && mantissa < (std::uint64_t{1} << 53U) && exponent >= -22 && exponent <= 22) {
        at = p;
        const auto whole = static_cast<double>(mantissa);
        return exponent < 0 ? whole / scan_detail::kPowersOfTen[-exponent]
                            : whole * scan_detail::kPowersOfTen[exponent];
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(at, p, value);
    if (error == std::errc::result_out_of_range) value = exponent > 0 || before_exponent - at > 300 ? INFINITY : 0;
    at = p;
    return value;
}

bool skip_blanks(const char*& at, const char* end) {
    while (at < end) {
        if (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r' || *at == '\f' || *at == '\v' || *at == '\0' ||
            *at == '\x1a') {
            ++at;
        } else if (*at == '/' && at + 1 < end && at[1] == '/') {
            while (at < end && *at != '\n') ++at;
        } else if (*at == '/' && at + 1 < end && at[1] == '*') {
            const char* p = at + 2;
            for (int open = 1; open > 0; ++p) {
                if (p + 1 >= end) return false;
                if (p[0] == '/' && p[1] == '*') ++open, ++p;
                else if (p[0] == '*' && p[1] == '/') --open, ++p;
            }
            at = p;
        } else {
            break;
        }
    }
    return true;
}

namespace {

bool starts_number(const char* p) { return is_digit(*p) || (*p == '.' && is_digit(p[1])); }

/// Reads a number with a sign; false where there is none.
bool scan_signed(const char*& p, double& number) {
    const bool negative = *p == '-';
    const char* const digits = negative || *p == '+' ? p + 1 : p;
    if (!starts_number(digits)) return false;
    p = digits;
    number = scan_number(p);
    if (negative) number = -number;
    return true;
}

/// Reads the inside of a vector and its `>`; the number of components, 0 where it isn't all numbers and commas.
std::uint8_t scan_vector(const char*& p, const char* end, std::vector<double>& numbers) {
    for (std::uint8_t count = 1; count <= 5; ++count) {
        double number = 0;
        if (!skip_blanks(p, end) || !scan_signed(p, number) || !skip_blanks(p, end)) return 0;
        numbers.push_back(number);
        const char after = *p++;
        if (after == '>') return count;
        if (after != ',') return 0;
    }
    return 0;
}

}  // namespace

std::optional<ValueList> scan_literal_list(const char*& at, const char* end) {
    ValueList list;
    const char* p = at;
    // What follows a value directly continues its expression, unless it can't: a sign subtracts, a `<` never does.
    bool separate = true;
    while (skip_blanks(p, end) && p < end) {
        if (*p == '}') {
            at = p;
            list.numbers.shrink_to_fit();
            list.counts.shrink_to_fit();
            return list;
        }
        if (*p == ',') {
            separate = true;
            ++p;
        } else if (*p == '<') {
            const std::uint8_t count = scan_vector(++p, end, list.numbers);
            if (count == 0) return std::nullopt;
            list.counts.push_back(count);
            separate = false;
        } else {
            double number = 0;
            if ((!separate && !starts_number(p)) || !scan_signed(p, number)) return std::nullopt;
            list.numbers.push_back(number);
            list.counts.push_back(1);
            separate = false;
        }
    }
    return std::nullopt;
}

}  // namespace sundog::pov
