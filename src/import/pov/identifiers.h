// SPDX-License-Identifier: Apache-2.0
// What identifiers stand for, and the levels at which they are declared (manual, 3.3.2.2).
#pragma once

#include <deque>
#include <fstream>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "import/pov/entity.h"
#include "import/pov/functions.h"
#include "import/pov/names.h"
#include "import/pov/spline.h"
#include "import/pov/tokens.h"

namespace sundog::pov {

struct Array;
struct OpenFile;

/// A macro's parameters and the tokens of its body.
struct Macro {
    NameId name = 0;
    const TokenFile* file = nullptr;
    std::uint32_t begin = 0, end = 0;
    std::vector<NameId> parameters;
};

/// One block, or several of a layered texture.
using BlockGroup = std::vector<std::shared_ptr<const Block>>;

/// The value of an identifier or of an array's element. monostate: declared, but without a value yet.
using Entity = std::variant<std::monostate, Value, std::string, BlockGroup, std::shared_ptr<const FunctionExpression>,
                            std::shared_ptr<const Spline>, std::shared_ptr<Array>, std::shared_ptr<const Macro>,
                            std::shared_ptr<OpenFile>>;

/// What kind of thing it is, for messages: "a float", "a texture", …
std::string describe(const Entity& entity);

/// Elements in the order of the last index. Assigned by value: shared until written to.
struct Array {
    std::vector<std::uint32_t> sizes;
    std::vector<Entity> elements;
    std::uint32_t depth = 1;  ///< 1 + that of the deepest array among its elements.
};

/// A file that #fopen opened.
struct OpenFile {
    enum class Mode : std::uint8_t { read, write };
    Mode mode = Mode::read;
    std::string text;      ///< All of a file to read.
    std::size_t next = 0;  ///< Where reading goes on.
    std::ofstream out;
    std::string path;
};

/// All identifiers by name. Names are shadowed by level: the main file is level 0, every include file and macro that is
/// being run has one of its own.
class Identifiers {
public:
    /// A place for a value. Parameters passed by reference share it, or are an element of the array in another cell.
    struct Cell {
        Entity value;
        std::uint32_t references = 0;
        std::uint32_t array_cell = 0;  ///< Where is_element.
        std::uint32_t element = 0;
        bool is_element = false;
        bool warn_once = false;  ///< Of a deprecated identifier.
        std::string deprecated;  ///< Warning where it is used; empty: none.
    };

    Identifiers() : levels_(1) {}

    void enter_level() { levels_.emplace_back(); }
    void leave_level();
    [[nodiscard]] std::uint32_t level() const { return static_cast<std::uint32_t>(levels_.size() - 1); }

    /// The value that a name has now, or null where it has none.
    Entity* find(NameId name) {
        if (name >= symbols_.size() || symbols_[name].empty()) return nullptr;
        Entity* value = value_of(symbols_[name].back().cell);
        return value == nullptr || value->index() == 0 ? nullptr : value;
    }
    /// The cell of a name's innermost declaration, or null.
    Cell* cell(NameId name) {
        if (name >= symbols_.size() || symbols_[name].empty()) return nullptr;
        return &cells_[symbols_[name].back().cell];
    }
    /// As #declare does: the innermost declaration gets the value, or a new global one.
    Entity& declare(NameId name);
    /// As #local does: the declaration of `level`, which may lie below the present one while a macro still runs.
    Entity& declare_local(NameId name, std::uint32_t level);
    /// For parameters of macros, which are all worked out before the first is bound: the cell of what `target` is,
    /// declared or (a new global one) not yet; of an element of the array `array`; of a value.
    std::uint32_t reference(NameId target);
    std::uint32_t reference_element(NameId array, std::uint32_t element);
    std::uint32_t hold(Entity&& value);
    /// Makes `name` at this level a name of a cell that one of the three gave.
    void bind(NameId name, std::uint32_t cell);
    /// Removes the innermost declaration; false where there is none.
    bool undefine(NameId name);
    /// The names that have values, for suggestions.
    [[nodiscard]] std::vector<NameId> declared() const;

private:
    struct Binding {
        std::uint32_t level, cell;
    };
    std::vector<Binding>& bindings(NameId name);
    std::uint32_t new_cell();
    void release(std::uint32_t cell);
    Entity* value_of(std::uint32_t cell);
    Entity& cell_to_assign(std::uint32_t cell);

    std::vector<std::vector<Binding>> symbols_;
    std::vector<std::vector<NameId>> levels_;
    std::deque<Cell> cells_;
    std::vector<std::uint32_t> free_;
};

/// The array in `entity`, made this entity's own if it was shared, so that it can be written to.
Array& own_array(std::shared_ptr<Array>& array);

}  // namespace sundog::pov
