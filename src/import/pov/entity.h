// SPDX-License-Identifier: Apache-2.0
// What the interpreter makes of a POV-Ray file and the builder reads: located blocks whose directives, macros and
// expressions are already worked out.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "import/pov/keywords.h"

namespace sundog::pov {

/// A place in one of the files that were read. Small, because there is one in every item.
struct Place {
    std::uint32_t file = 0;  ///< Into the interpreter's list of files.
    std::uint32_t line = 0;  ///< From 1; 0 for the file as a whole.
    std::uint32_t column = 0;
};

/// A float, vector or colour as POV-Ray's expressions give it: 1 to 5 components. A colour has 5: red, green, blue,
/// filter, transmit, in the scene's working space as written (`srgb` forms are already linear).
struct Value {
    std::array<double, 5> v{};
    std::uint8_t count = 1;
    bool is_color = false;  ///< Written with a colour keyword (rgb, color, red, …) or an identifier of one.
};

struct Block;
struct FunctionExpression;  // functions.h: a user function, not evaluated

/// A row in square brackets of a map: `[0.3 color rgb 1]`.
struct Row;

/// One thing inside a block, in the order of the file. Commas and semicolons are gone. What POV-Ray writes in angle
/// brackets with more than five components (matrix, the coefficients of poly, cubic and quartic) stands as that many
/// floats, one item each.
struct Item {
    Place where;
    std::variant<Value,                         // 1  <1, 2, 3>  rgb <1, 0, 0>
                 Keyword,                       // open   no_shadow   translate (its operand is the next item)
                 std::string,                   // "file.png"
                 std::shared_ptr<const Block>,  // pigment { … }, or what an identifier stood for
                 std::shared_ptr<const Row>,    // [ … ]
                 std::shared_ptr<const FunctionExpression>>
        content;
};

/// `keyword { items }`. Where an identifier was used (`texture { Steel scale 2 }`, `object { Tree }`), its value stands
/// as an item of its own: a block of the same keyword inside the block, to be taken as the start and changed by what
/// follows. A declared identifier of several blocks (layered textures) gives as many items.
struct Block {
    Keyword keyword{};
    std::uint16_t version = 370;  ///< 100 times the #version in force where the block begins.
    Place where;
    std::vector<Item> items;
    /// What #default had set where the block begins: a block `default_` with the items of all #default directives so
    /// far, in their order. Null before the first.
    std::shared_ptr<const Block> defaults;
};

struct Row {
    Place where;
    std::vector<Item> items;
};

}  // namespace sundog::pov
