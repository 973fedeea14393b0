// SPDX-License-Identifier: Apache-2.0
#include "base/scan.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace sundog {
namespace {

struct Scanned {
    Scan scan;
    float value;
    std::size_t length;
};

Scanned scan(const std::string& text) {
    const std::string with_end = text + "\n\n";
    const char* p = with_end.c_str();
    Scanned result{Scan::ok, 0, 0};
    result.scan = scan_float(p, result.value);
    result.length = static_cast<std::size_t>(p - with_end.c_str());
    return result;
}

// Catches a parser that is a unit in the last place off: strtof rounds correctly and is the reference.
TEST(ScanFloat, RoundsAsTheStandardLibraryDoes) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 200000; ++i) {
        const auto bits = static_cast<std::uint32_t>(random());
        const auto exact = std::bit_cast<float>(bits);
        if (!std::isfinite(exact)) continue;
        char text[64];
        const int digits = static_cast<int>(random() % 22);
        std::snprintf(text, sizeof text, random() % 2 == 0 ? "%.*e" : "%.*g", digits, static_cast<double>(exact));
        const float expected = std::strtof(text, nullptr);
        const Scanned got = scan(text);
        if (std::isinf(expected)) {
            ASSERT_EQ(got.scan, Scan::too_large) << text;
            continue;
        }
        ASSERT_EQ(got.scan, Scan::ok) << text;
        ASSERT_EQ(std::bit_cast<std::uint32_t>(got.value), std::bit_cast<std::uint32_t>(expected)) << text;
        ASSERT_EQ(got.length, std::string(text).size()) << text;
    }
}

// Catches double rounding: these decimals lie next to the middle between two floats, nearer than a double tells.
TEST(ScanFloat, RoundsOnceNextToTheMiddleOfTwoFloats) {
    for (const char* text : {"1.00000005960464477539062500000000001", "1.000000059604644775390625", "16777217",
                             "16777219", "1.000000178813934326171875", "1.00000017881393432617187499999999999",
                             "9007199254740993", "0.000000000000000000000000000000000000011754943508"}) {
        EXPECT_EQ(scan(text).value, std::strtof(text, nullptr)) << text;
    }
}

// Catches limits that are mixed up: too large is an error, too small is zero.
TEST(ScanFloat, TellsTooLargeFromTooSmall) {
    EXPECT_EQ(scan("1e999").scan, Scan::too_large);
    EXPECT_EQ(scan("-1e39").scan, Scan::too_large);
    EXPECT_EQ(scan("1e99999999999999999999").scan, Scan::too_large);
    EXPECT_EQ(scan(std::string(400, '9')).scan, Scan::too_large);
    for (const std::string& tiny : {std::string("1e-999"), std::string("1e-99999999999999999999"),
                                    "0." + std::string(400, '0') + "1", std::string("0e999")}) {
        EXPECT_EQ(scan(tiny).scan, Scan::ok) << tiny;
        EXPECT_EQ(scan(tiny).value, 0.0F) << tiny;
    }
    EXPECT_GT(scan("1e-44").value, 0.0F);
}

// Catches what strtof would take but files must not hold.
TEST(ScanFloat, RefusesWhatIsNoDecimalNumber) {
    for (const char* text : {"", "-", "+", ".", "-.", "nan", "inf", "-inf", "e5", "1e", "1e+", "x1"})
        EXPECT_EQ(scan(text).scan, Scan::malformed) << text;
    EXPECT_EQ(scan("0x10").length, 1U);
    EXPECT_EQ(scan("+.5").value, 0.5F);
    EXPECT_EQ(scan("5.").value, 5.0F);
}

// Catches integers that wrap around.
TEST(ScanInt, StopsAtTheRange) {
    const auto scan_text = [](const char* text, std::int32_t& value) {
        const char* p = text;
        return scan_int(p, value);
    };
    std::int32_t value = 0;
    EXPECT_EQ(scan_text("2147483647\n", value), Scan::ok);
    EXPECT_EQ(value, INT32_MAX);
    EXPECT_EQ(scan_text("-2147483647\n", value), Scan::ok);
    EXPECT_EQ(value, -INT32_MAX);
    EXPECT_EQ(scan_text("2147483648\n", value), Scan::too_large);
    EXPECT_EQ(scan_text("99999999999999999999999999\n", value), Scan::too_large);
    EXPECT_EQ(scan_text("-\n", value), Scan::malformed);
}

}  // namespace
}  // namespace sundog
