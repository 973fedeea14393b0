// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_items.h"

#include <cmath>
#include <vector>

namespace sundog::pov {
namespace {

std::string in_name(Keyword keyword) { return "'" + std::string(spelling(keyword)) + "'"; }

}  // namespace

Vec3d as_vector(const Value& value) {
    if (value.count == 1) return {value.v[0], value.v[0], value.v[0]};
    return {value.v[0], value.v[1], value.count > 2 ? value.v[2] : 0};
}

scene::PigmentColor as_color(const Value& value) {
    const auto component = [&](std::size_t i) {
        return static_cast<float>(value.count == 1 ? value.v[0] : i < value.count ? value.v[i] : 0);
    };
    return {component(0), component(1), component(2), component(3), component(4)};
}

Block block_of_row(const Row& row, std::size_t skipped, Keyword keyword, const Block& owner) {
    Block block;
    block.keyword = keyword;
    block.where = row.where;
    block.version = owner.version;
    block.defaults = owner.defaults;
    block.items.assign(row.items.begin() + static_cast<std::ptrdiff_t>(skipped), row.items.end());
    return block;
}

Place ItemReader::where() const {
    if (!at_end()) return items_[next_].where;
    return items_.empty() ? where_ : items_.back().where;
}

bool ItemReader::take(Keyword keyword) {
    if (peek_keyword() != keyword) return false;
    ++next_;
    return true;
}

std::optional<Keyword> ItemReader::peek_keyword() const {
    if (at_end()) return std::nullopt;
    const auto* keyword = std::get_if<Keyword>(&items_[next_].content);
    return keyword ? std::optional(*keyword) : std::nullopt;
}

std::shared_ptr<const Block> ItemReader::take_block(Keyword keyword) {
    if (at_end()) return nullptr;
    const auto* block = std::get_if<std::shared_ptr<const Block>>(&items_[next_].content);
    if (!block || (*block)->keyword != keyword) return nullptr;
    ++next_;
    return *block;
}

std::shared_ptr<const Block> ItemReader::take_block() {
    if (at_end()) return nullptr;
    const auto* block = std::get_if<std::shared_ptr<const Block>>(&items_[next_].content);
    if (!block) return nullptr;
    ++next_;
    return *block;
}

std::shared_ptr<const Row> ItemReader::take_row() {
    if (at_end()) return nullptr;
    const auto* row = std::get_if<std::shared_ptr<const Row>>(&items_[next_].content);
    if (!row) return nullptr;
    ++next_;
    return *row;
}

const std::string* ItemReader::take_text() {
    if (at_end()) return nullptr;
    const auto* text = std::get_if<std::string>(&items_[next_].content);
    if (text) ++next_;
    return text;
}

std::shared_ptr<const FunctionExpression> ItemReader::take_function() {
    if (at_end()) return nullptr;
    const auto* function = std::get_if<std::shared_ptr<const FunctionExpression>>(&items_[next_].content);
    if (!function) return nullptr;
    ++next_;
    return *function;
}

bool ItemReader::value_follows() const { return !at_end() && std::holds_alternative<Value>(items_[next_].content); }

bool ItemReader::number_follows() const {
    if (at_end()) return false;
    const auto* value = std::get_if<Value>(&items_[next_].content);
    return value && value->count == 1;
}

const Value& ItemReader::value(std::string_view what) {
    const auto* value = at_end() ? nullptr : std::get_if<Value>(&items_[next_].content);
    if (!value) unexpected(what);
    for (std::size_t i = 0; i < value->count; ++i)
        if (!std::isfinite(value->v[i]))
            context_->fail(where(), "a number that is not finite", "expected " + std::string(what));
    ++next_;
    return *value;
}

double ItemReader::number(std::string_view what) {
    if (!number_follows()) unexpected(what);
    return value(what).v[0];
}

std::optional<double> ItemReader::maybe_number() {
    if (!number_follows()) return std::nullopt;
    return value("a number").v[0];
}

int ItemReader::integer(std::string_view what, int least, int most) {
    const double number = this->number(what);
    if (!(number >= least && number <= most))
        fail("a number out of range",
             "expected " + std::string(what) + ", " + std::to_string(least) + " to " + std::to_string(most));
    return static_cast<int>(number);
}

Vec3d ItemReader::vector(std::string_view what) { return as_vector(value(what)); }

std::array<double, 2> ItemReader::vector2(std::string_view what) {
    const Value& v = value(what);
    return {v.v[0], v.count == 1 ? v.v[0] : v.v[1]};
}

scene::PigmentColor ItemReader::color(std::string_view what) { return as_color(value(what)); }

std::string ItemReader::text(std::string_view what) {
    const std::string* text = take_text();
    if (!text) unexpected(what);
    return *text;
}

bool ItemReader::flag() {
    const std::optional<double> number = maybe_number();
    return !number || *number != 0;
}

std::string ItemReader::describe_next() const {
    struct Describe {
        std::string operator()(const Value& v) const {
            return v.count == 1 ? "a number" : v.is_color ? "a color" : "a vector";
        }
        std::string operator()(Keyword keyword) const { return in_name(keyword); }
        std::string operator()(const std::string&) const { return "a string"; }
        std::string operator()(const std::shared_ptr<const Block>& block) const {
            return std::string(spelling(block->keyword)) + " { }";
        }
        std::string operator()(const std::shared_ptr<const Row>&) const { return "'['"; }
        std::string operator()(const std::shared_ptr<const FunctionExpression>&) const { return "a function"; }
        std::string operator()(const std::shared_ptr<const ValueList>&) const { return "a number"; }
    };
    return std::visit(Describe{}, items_[next_].content);
}

void ItemReader::unexpected(std::string_view expected) {
    const std::string owner = std::string(spelling(keyword_)) + " { }";
    const std::string hint = "expected " + std::string(expected);
    if (at_end()) context_->fail(where(), owner + " ends too early", hint);
    context_->fail(where(), describe_next() + " in " + owner, hint);
}

void ItemReader::unexpected(std::span<const Keyword> valid, std::string_view expected) {
    std::vector<std::string_view> names;
    names.reserve(valid.size());
    for (const Keyword keyword : valid) names.push_back(spelling(keyword));
    std::optional<Keyword> found = peek_keyword();
    if (!found && !at_end())
        if (const auto* block = std::get_if<std::shared_ptr<const Block>>(&items_[next_].content))
            found = (*block)->keyword;
    std::string hint = expected.empty() ? "" : "expected " + std::string(expected);
    if (found && !names.empty()) {
        const std::string near = suggest(spelling(*found), names);
        if (hint.empty() || near.starts_with("did")) hint = near;
    } else if (hint.empty()) {
        hint = suggest("", names);
    }
    const std::string owner = std::string(spelling(keyword_)) + " { }";
    if (at_end()) context_->fail(where(), owner + " ends too early", hint);
    context_->fail(where(), describe_next() + " has no place in " + owner, hint);
}

}  // namespace sundog::pov
