// SPDX-License-Identifier: Apache-2.0
// Reads the items of a block one by one; what doesn't fit is an InputError at its place.
#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/vec3d.h"
#include "import/pov/build_context.h"
#include "import/pov/entity.h"
#include "scene/pigment.h"

namespace sundog::pov {

/// A vector of a value: a float stands for three equal components, missing components are 0.
Vec3d as_vector(const Value& value);
/// A colour of a value: a float stands for five equal components, missing components are 0.
scene::PigmentColor as_color(const Value& value);

/// What a map's row says behind its first `skipped` items, as a block `keyword` where `owner` is.
Block block_of_row(const Row& row, std::size_t skipped, Keyword keyword, const Block& owner);

/// A cursor over the items of a block or of a row.
class ItemReader {
public:
    ItemReader(BuildContext& context, const Block& block)
        : context_(&context), items_(block.items), keyword_(block.keyword), where_(block.where) {}
    ItemReader(BuildContext& context, const Row& row, Keyword keyword)
        : context_(&context), items_(row.items), keyword_(keyword), where_(row.where) {}

    [[nodiscard]] bool at_end() const { return next_ == items_.size(); }
    /// The next item, null at the end.
    [[nodiscard]] const Item* peek() const { return at_end() ? nullptr : &items_[next_]; }
    /// Of the next item; at the end, of the last one.
    [[nodiscard]] Place where() const;
    /// Of the item that was taken last; of the block before the first.
    [[nodiscard]] Place taken_where() const { return next_ == 0 ? where_ : items_[next_ - 1].where; }
    void skip() { ++next_; }

    /// Takes the next item if it is this keyword.
    bool take(Keyword keyword);
    /// The next item, if it is a keyword; not taken.
    [[nodiscard]] std::optional<Keyword> peek_keyword() const;
    /// Takes the next item if it is a block with this keyword.
    std::shared_ptr<const Block> take_block(Keyword keyword);
    /// Takes the next item if it is a block.
    std::shared_ptr<const Block> take_block();
    std::shared_ptr<const Row> take_row();
    const std::string* take_text();
    /// Takes the next item if it is a function.
    std::shared_ptr<const FunctionExpression> take_function();

    /// True if the next item is a float, vector or colour.
    [[nodiscard]] bool value_follows() const;
    [[nodiscard]] bool number_follows() const;
    /// Takes the next value, whatever its components. `what` is what was expected, for messages.
    const Value& value(std::string_view what);
    double number(std::string_view what);
    std::optional<double> maybe_number();
    /// A whole number, rounded towards 0. Errors: also outside least..most.
    int integer(std::string_view what, int least, int most);
    Vec3d vector(std::string_view what);
    std::array<double, 2> vector2(std::string_view what);
    scene::PigmentColor color(std::string_view what);
    std::string text(std::string_view what);
    /// on, off, true, 0 …, or nothing, which is on.
    bool flag();

    /// Errors at the next item: it has no place in this block. `valid` are the keywords that have.
    [[noreturn]] void unexpected(std::span<const Keyword> valid, std::string_view expected = {});
    [[noreturn]] void unexpected(std::string_view expected);
    [[noreturn]] void fail(std::string message, std::string hint = {}) const {
        context_->fail(taken_where(), std::move(message), std::move(hint));
    }
    void warn(std::string message, std::string hint = {}) const {
        context_->warn(taken_where(), std::move(message), std::move(hint));
    }
    [[nodiscard]] BuildContext& context() const { return *context_; }
    [[nodiscard]] Keyword keyword() const { return keyword_; }

private:
    /// "the keyword 'open'", "a vector": what the next item is.
    [[nodiscard]] std::string describe_next() const;

    BuildContext* context_;
    std::span<const Item> items_;
    std::size_t next_ = 0;
    Keyword keyword_;
    Place where_;
};

}  // namespace sundog::pov
