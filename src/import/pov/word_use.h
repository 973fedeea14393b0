// SPDX-License-Identifier: Apache-2.0
// Which keywords begin an expression, and how.
#pragma once

#include <array>
#include <initializer_list>

#include "import/pov/keywords.h"

namespace sundog::pov {

enum class WordUse : std::uint8_t {
    statement,        ///< No part of expressions.
    constant,         ///< pi, x, on, clock, …
    number_function,  ///< Of a fixed number of floats or vectors: sin, pow, vdot, vcross, …
    aggregate,        ///< Of any number of floats: min, max, bitwise_and, …
    of_names,         ///< Of an identifier: defined, dimensions, dimension_size.
    of_strings,       ///< strlen, strcmp, asc, val, file_exists.
    geometry,         ///< Of an object: trace, inside, min_extent, max_extent.
    string,           ///< Gives a string.
    color,            ///< color, rgb and its kin.
    color_word,       ///< red, green, blue, filter, transmit, alpha.
};

namespace word_use_detail {

consteval std::array<WordUse, kKeywordCount> make_table() {
    using enum Keyword;
    std::array<WordUse, kKeywordCount> table{};
    const auto set = [&](WordUse use, std::initializer_list<Keyword> words) {
        for (const Keyword word : words) table[static_cast<std::size_t>(word)] = use;
    };
    set(WordUse::constant, {pi,
                            tau,
                            x,
                            y,
                            z,
                            u,
                            v,
                            t,
                            on,
                            off,
                            yes,
                            no,
                            true_,
                            false_,
                            clock,
                            clock_delta,
                            clock_on,
                            now,
                            version,
                            frame_number,
                            initial_frame,
                            final_frame,
                            initial_clock,
                            final_clock,
                            image_width,
                            image_height});
    set(WordUse::number_function,
        {abs,  acos, acosh, asin, asinh, atan,         atan2,  atanh, ceil,    cos,        cosh,    degrees,
         div,  exp,  floor, int_, ln,    log,          mod,    pow,   radians, rand,       seed,    sin,
         sinh, sqr,  sqrt,  tan,  tanh,  vaxis_rotate, vcross, vdot,  vlength, vnormalize, vrotate, vturbulence});
    set(WordUse::aggregate, {min, max, bitwise_and, bitwise_or, bitwise_xor, select});
    set(WordUse::of_names, {defined, dimensions, dimension_size});
    set(WordUse::of_strings, {strlen, strcmp, asc, val, file_exists});
    set(WordUse::geometry, {trace, inside, min_extent, max_extent});
    set(WordUse::string, {str, vstr, concat, substr, chr, strlwr, strupr, datetime, input_file_name});
    set(WordUse::color, {color, rgb, rgbf, rgbt, rgbft, srgb, srgbf, srgbt, srgbft});
    set(WordUse::color_word, {red, green, blue, filter, transmit, alpha});
    return table;
}

inline constexpr std::array<WordUse, kKeywordCount> kTable = make_table();

}  // namespace word_use_detail

constexpr WordUse word_use(Keyword keyword) { return word_use_detail::kTable[static_cast<std::size_t>(keyword)]; }

}  // namespace sundog::pov
