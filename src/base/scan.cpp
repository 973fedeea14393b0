// SPDX-License-Identifier: Apache-2.0
#include "base/scan.h"

#include <bit>
#include <cfloat>
#include <charconv>

namespace sundog::scan_detail {

bool rounds_once(double d) {
    constexpr std::uint64_t kBelowFloat = (std::uint64_t{1} << 29U) - 1;
    constexpr std::uint64_t kMiddle = std::uint64_t{1} << 28U;
    // The neighbours of the middle are safe too: a correctly rounded double lies on the decimal's own side of it.
    if ((std::bit_cast<std::uint64_t>(d) & kBelowFloat) == kMiddle) return false;
    return d >= static_cast<double>(FLT_MIN) && d <= static_cast<double>(FLT_MAX);
}

Scan scan_float_slowly(const char* first, const char* last, float& magnitude) {
    const std::from_chars_result result = std::from_chars(first, last, magnitude);
    if (result.ec == std::errc{}) return magnitude <= FLT_MAX ? Scan::ok : Scan::too_large;
    if (result.ec != std::errc::result_out_of_range) return Scan::malformed;
    // from_chars doesn't tell too large from too small: find the decimal exponent of the first digit that counts.
    std::int64_t exponent = 0;
    bool fraction = false;
    bool counts = false;
    const char* p = first;
    for (; p != last && (is_digit(*p) || *p == '.'); ++p) {
        if (*p == '.') {
            fraction = true;
            continue;
        }
        counts = counts || *p != '0';
        if (counts && !fraction) ++exponent;
        if (!counts && fraction) --exponent;
    }
    if (p != last) {
        std::int64_t written = 0;
        const char* q = p + 1;
        if (*q == '+') ++q;
        if (std::from_chars(q, last, written).ec != std::errc{}) written = *q == '-' ? -INT32_MAX : INT32_MAX;
        exponent += written;
    }
    if (exponent > 0) return Scan::too_large;
    magnitude = 0;
    return Scan::ok;
}

}  // namespace sundog::scan_detail
