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

/// A run of plain values (no colours), packed: the lists of a mesh2 hold millions.
struct ValueList {
    std::vector<double> numbers;       ///< The components of all values, one after the other.
    std::vector<std::uint8_t> counts;  ///< How many of them each value has, 1 to 5; as many as there are values.
};

/// One thing inside a block, in the order of the file. Commas and semicolons are gone.
///
/// - Vectors of more than 5 components (matrix, poly, cubic, quartic) come as one Value a component.
/// - In vertex_vectors, normal_vectors, uv_vectors, face_indices, normal_indices and uv_indices, plain values come
///   only as ValueLists (as few as possible), never as Value.
/// - Function names without parentheses (`sqr`, `exp` in a julia_fractal), `srgb` after `gamma`, `filter` and
///   `transmit` in image_map, bump_map and their kin come as Keyword; elsewhere the colour words make a colour Value.
/// - `on`, `yes`, `true` are the Value 1, `off`, `no`, `false` are 0.
/// - `function W, H { … }` (an image made by a function) comes as Keyword::function, two Values, the function.
struct Item {
    Place where;
    std::variant<Value,                         // 1  <1, 2, 3>  rgb <1, 0, 0>
                 Keyword,                       // open   no_shadow   translate (its operand is the next item)
                 std::string,                   // "file.png"
                 std::shared_ptr<const Block>,  // pigment { … }, or what an identifier stood for
                 std::shared_ptr<const Row>,    // [ … ]
                 std::shared_ptr<const FunctionExpression>, std::shared_ptr<const ValueList>>
        content;
};

/// `keyword { items }`. Where an identifier was used (`texture { Steel scale 2 }`, `object { Tree }`), its value stands
/// as an item of its own: a block of the same keyword inside the block, to be taken as the start and changed by what
/// follows. A declared identifier of several blocks (layered textures) gives as many items.
/// A declared finish gives its own items: povray knows no finish within a finish.
struct Block {
    Keyword keyword{};
    std::uint16_t version = 370;  ///< 100 times the #version in force where the block begins.
    Place where;
    std::uint32_t depth = 1;  ///< 1 + the deepest block within; the interpreter's limit makes recursion over it safe.
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
