// SPDX-License-Identifier: Apache-2.0
// Blocks and what stands in them. What a block may hold is the builder's business: here keywords, values, strings, rows
// and blocks are told apart.
#include <algorithm>

#include "import/pov/interpreter_core.h"
#include "import/pov/word_use.h"

namespace sundog::pov {
namespace {

/// Blocks that read an image file, in which `filter` and `transmit` speak of its palette.
bool is_of_image(Keyword keyword) {
    return keyword == Keyword::image_map || keyword == Keyword::bump_map || keyword == Keyword::material_map ||
           keyword == Keyword::image_pattern || keyword == Keyword::height_field;
}

bool is_packed_list(Keyword keyword) {
    return keyword == Keyword::vertex_vectors || keyword == Keyword::normal_vectors || keyword == Keyword::uv_vectors ||
           keyword == Keyword::face_indices || keyword == Keyword::normal_indices || keyword == Keyword::uv_indices;
}

/// True where a block's coefficients are to come, one vector of more components than others have.
bool expects_coefficients(Keyword keyword, const std::vector<Item>& items) {
    if (!items.empty() && std::holds_alternative<Keyword>(items.back().content))
        return std::get<Keyword>(items.back().content) == Keyword::matrix;
    if (keyword == Keyword::cubic || keyword == Keyword::quartic) return items.empty();
    return keyword == Keyword::poly && items.size() == 1 && std::holds_alternative<Value>(items.front().content);
}

/// Of the numbers behind a photons block's `radius` each may be left out: where its comma number `commas` comes before
/// as many numbers, a 0 that stands for the missing one is appended.
void append_left_out(std::vector<Item>& items, std::size_t commas, Place comma) {
    std::size_t values = 0;
    while (values < items.size() && std::holds_alternative<Value>(items[items.size() - 1 - values].content)) ++values;
    if (values == items.size() || values >= commas) return;
    const auto* word = std::get_if<Keyword>(&items[items.size() - 1 - values].content);
    if (word != nullptr && *word == Keyword::radius) items.push_back({comma, number_value(0)});
}

void deepen(std::uint32_t& depth, std::uint32_t inner) { depth = std::max(depth, inner); }

}  // namespace

std::shared_ptr<const Block> Interpreter::parse_block(Keyword keyword, Place where) {
    auto block = std::make_shared<Block>();
    block->keyword = keyword;
    block->where = where;
    parse_block_into(*block);
    return block;
}

void Interpreter::parse_block_into(Block& block) {
    const Level level(*this);
    const GuardScope no_guard(guard_, {});
    block.version = version_;
    block.defaults = defaults_;
    expect(TokenKind::left_brace, "after ", spelling(block.keyword));
    std::uint32_t inner = 0;
    block.items.reserve(4);
    parse_items(block.items, TokenKind::right_brace, block.keyword, inner);
    block.depth = inner + 1;
    check_depth(block.depth, block.where);
}

void Interpreter::parse_items(std::vector<Item>& items, TokenKind closing, Keyword context, std::uint32_t& depth) {
    std::size_t commas = 0;  // Since the last keyword.
    for (;;) {
        const Lookahead& ahead = peek();
        switch (ahead.kind) {
            case TokenKind::comma:
                if (context == Keyword::photons) append_left_out(items, ++commas, here());
                take();
                break;
            case TokenKind::semicolon:
                take();
                break;
            case TokenKind::keyword:
                commas = 0;
                parse_keyword_item(items, context, depth);
                break;
            case TokenKind::name:
                parse_name_item(items, context, depth);
                break;
            case TokenKind::string: {
                const Spot where = here();
                items.push_back({where, parse_string()});
                break;
            }
            case TokenKind::left_bracket: {
                const Spot where = here();
                const Level level(*this);
                take();
                auto row = std::make_shared<Row>();
                row->where = where;
                std::uint32_t inner = 0;
                parse_items(row->items, TokenKind::right_bracket, context, inner);
                deepen(depth, inner);
                items.push_back({where, std::move(row)});
                break;
            }
            case TokenKind::list: {
                const Spot where = here();
                std::shared_ptr<const ValueList> list = ahead.file->lists[ahead.payload];
                take();
                append_list(items, std::move(list), where);
                break;
            }
            case TokenKind::left_angle:
                if (expects_coefficients(context, items)) {
                    append_long_vector(items);
                    break;
                }
                [[fallthrough]];
            case TokenKind::number:
            case TokenKind::left_paren:
            case TokenKind::plus:
            case TokenKind::minus:
            case TokenKind::exclamation: {
                const Spot where = here();
                append_value(items, where, is_of_image(context) ? parse_expression() : parse_value(), context);
                break;
            }
            case TokenKind::colon:
                // polynomial { 4, xyz(2, 0, 0): 1, … }
                if (context == Keyword::polynomial) {
                    take();
                    break;
                }
                [[fallthrough]];
            default:
                if (ahead.kind == closing) return take();
                fail_expected(closing == TokenKind::right_brace
                                  ? "a keyword, a value or the '}' of this " + std::string(spelling(context))
                                  : "a value, a keyword or ']'");
        }
    }
}

void Interpreter::append_value(std::vector<Item>& items, Place where, const Value& value, Keyword context) {
    tick();
    if (!is_packed_list(context) || value.is_color) {
        items.push_back({where, value});
        return;
    }
    ValueList* list = nullptr;
    if (!items.empty())
        if (auto* last = std::get_if<std::shared_ptr<const ValueList>>(&items.back().content); last != nullptr)
            // Only lists made here are added to; those of a file's tokens belong to the file.
            if (*last == growing_list_) list = growing_list_.get();
    if (list == nullptr) {
        growing_list_ = std::make_shared<ValueList>();
        list = growing_list_.get();
        items.push_back({where, std::shared_ptr<const ValueList>(growing_list_)});
    }
    list->numbers.insert(list->numbers.end(), value.v.begin(), value.v.begin() + value.count);
    list->counts.push_back(value.count);
}

void Interpreter::append_list(std::vector<Item>& items, std::shared_ptr<const ValueList> list, Place where) {
    tick(list->counts.size() / 16);
    items.push_back({where, std::move(list)});
}

void Interpreter::append_long_vector(std::vector<Item>& items) {
    const Level level(*this);
    take();
    while (!accept(TokenKind::right_angle)) {
        const Spot where = here();
        items.push_back({where, number_value(parse_number())});
        tick();
        accept(TokenKind::comma);
    }
}

void Interpreter::parse_keyword_item(std::vector<Item>& items, Keyword context, std::uint32_t& depth) {
    const auto keyword = static_cast<Keyword>(ahead_.payload);
    const Place where = ahead_.file->place(ahead_.offset);
    const WordUse use = word_use(keyword);
    if (keyword == Keyword::pwr) {  // of a julia_fractal: pwr(x, y)
        take();
        items.push_back({where, keyword});
        if (!accept(TokenKind::left_paren)) return;
        for (int i = 0; i < 2; ++i) {
            const Spot part = here();
            items.push_back({part, number_value(parse_number())});
            accept(TokenKind::comma);
        }
        expect(TokenKind::right_paren, "after pwr's exponent");
        return;
    }
    if (use == WordUse::constant) return append_value(items, where, parse_value(), context);
    if (use == WordUse::string) {
        items.push_back({where, parse_string()});
        return;
    }
    if (use == WordUse::color_word && is_of_image(context)) {
        take();
        items.push_back({where, keyword});
        return;
    }
    if (use == WordUse::color && (keyword == Keyword::srgb || keyword == Keyword::color)) {
        // `gamma srgb` has no vector.
        if (!items.empty() && std::holds_alternative<Keyword>(items.back().content) &&
            (std::get<Keyword>(items.back().content) == Keyword::gamma ||
             std::get<Keyword>(items.back().content) == Keyword::assumed_gamma)) {
            take();
            items.push_back({where, keyword});
            return;
        }
    }
    if (use == WordUse::color || use == WordUse::color_word) return append_value(items, where, parse_value(), context);
    if (use != WordUse::statement) {
        // `sqr` or `exp` in a julia_fractal are no calls.
        if (raw().kind() == TokenKind::left_paren) return append_value(items, where, parse_value(), context);
        take();
        items.push_back({where, keyword});
        return;
    }
    if (keyword == Keyword::function) return parse_function_item(items, depth);
    if (keyword == Keyword::finish && context == Keyword::finish)
        fail_expected(
            "an item of this finish or its '}' (only a declared finish stands in another, by its name alone)");
    take();
    if (peek().kind != TokenKind::left_brace) {
        items.push_back({where, keyword});
        return;
    }
    auto block = parse_block(keyword, where);
    deepen(depth, block->depth);
    items.push_back({where, std::move(block)});
}

void Interpreter::parse_name_item(std::vector<Item>& items, Keyword context, std::uint32_t& depth) {
    const NameId name = ahead_.payload;
    const Spot where{ahead_.file, ahead_.offset};
    const Entity* found = identifiers_.find(name);
    if (found == nullptr) {
        if (context == Keyword::polynomial && names_.text(name) == "xyz") {
            // The exponents of a term: xyz(2, 0, 1).
            take();
            expect(TokenKind::left_paren, "after xyz");
            Value exponents;
            exponents.count = 3;
            for (std::size_t i = 0; i < 3; ++i) {
                exponents.v[i] = parse_number();
                accept(TokenKind::comma);
            }
            expect(TokenKind::right_paren, "after the exponents");
            items.push_back({where, exponents});
            return;
        }
        fail_undeclared(where, name);
    }
    if (std::holds_alternative<Value>(*found)) return append_value(items, where, parse_value(), context);
    if (has_deprecated_) note_use(name, where);
    Entity entity = *found;
    take();
    if (const auto* array = std::get_if<std::shared_ptr<Array>>(&entity))
        entity = element(std::shared_ptr<Array>(*array), name, where);
    if (auto* text = std::get_if<std::string>(&entity)) {
        items.push_back({where, std::move(*text)});
    } else if (const auto* group = std::get_if<BlockGroup>(&entity)) {
        if (context == Keyword::finish && group->size() == 1 && group->front()->keyword == Keyword::finish) {
            // As if written out, so that a finish never holds another.
            if (!items.empty())
                fail(where, "a declared finish behind other items of one",
                     "it stands first, and what follows changes it");
            items = group->front()->items;
            deepen(depth, group->front()->depth - 1);
            return;
        }
        for (const std::shared_ptr<const Block>& block : *group) {
            deepen(depth, block->depth);
            items.push_back({where, block});
        }
    } else if (const auto* function = std::get_if<std::shared_ptr<const FunctionExpression>>(&entity);
               function != nullptr && peek().kind != TokenKind::left_paren) {
        items.push_back({where, *function});
    } else {
        pending_ = value_of_entity(entity, name, where);
        append_value(items, where, parse_value(), context);
    }
}

void Interpreter::parse_function_item(std::vector<Item>& items, std::uint32_t& depth) {
    const Spot where = here();
    // `function W, H { … }` is an image of that size.
    const TokenKind after = raw().kind();
    if (after != TokenKind::left_brace && after != TokenKind::left_paren) {
        take();
        items.push_back({where, Keyword::function});
        for (int i = 0; i < 2; ++i) {
            const Place number_place = here();
            items.push_back({number_place, number_value(parse_number())});
            accept(TokenKind::comma);
        }
        // As the formatter prints it.
        if (peek().is(Keyword::function)) take();
    } else {
        take();
    }
    auto function = parse_function(where);
    if (function->block) deepen(depth, function->block->depth);
    items.push_back({where, std::move(function)});
}

void Interpreter::run_scene() {
    for (;;) {
        const Lookahead& ahead = peek();
        if (ahead.kind == TokenKind::end) return;
        if (ahead.kind == TokenKind::semicolon) {
            take();
            continue;
        }
        Block block;
        block.where = here();
        if (ahead.kind == TokenKind::name && identifiers_.find(ahead.payload) != nullptr) {
            // `Tree` alone is taken for `object { Tree }`.
            std::uint32_t depth = 0;
            block.keyword = Keyword::object;
            block.version = version_;
            block.defaults = defaults_;
            warn_once(block.where, "bare object", "an identifier alone; object { … } was expected around it");
            parse_name_item(block.items, Keyword::object, depth);
            block.depth = depth + 1;
            for (const Item& item : block.items)
                if (!std::holds_alternative<std::shared_ptr<const Block>>(item.content))
                    fail(item.where, "expected an object, camera, light_source or the like, found a value");
        } else if (ahead.kind == TokenKind::keyword) {
            block.keyword = static_cast<Keyword>(ahead.payload);
            if (word_use(block.keyword) != WordUse::statement)
                fail_expected("an object, camera, light_source or the like");
            take();
            if (block.keyword == Keyword::default_) {
                // The '#' before directives once could be left out.
                warn_once(block.where, "bare default", "default { }; #default { … } was expected");
                run_default(here());
                continue;
            }
            if (block.keyword == Keyword::max_trace_level || block.keyword == Keyword::max_intersections) {
                // Before version 3 these stood outside of global_settings.
                block.items = {{block.where, block.keyword}, {block.where, parse_value()}};
                block.keyword = Keyword::global_settings;
                block.depth = 1;
                block.version = version_;
                block.defaults = defaults_;
            } else {
                parse_block_into(block);
            }
        } else {
            fail_expected("an object, camera, light_source or the like");
        }
        note_globals(block);
        sink_.add(std::move(block));
    }
}

void Interpreter::note_globals(const Block& block) {
    if (block.keyword != Keyword::global_settings) return;
    for (std::size_t i = 0; i + 1 < block.items.size(); ++i) {
        const auto* keyword = std::get_if<Keyword>(&block.items[i].content);
        if (keyword == nullptr || *keyword != Keyword::assumed_gamma) continue;
        const auto* value = std::get_if<Value>(&block.items[i + 1].content);
        // `assumed_gamma srgb` is nearly a power of 2.2.
        assumed_gamma_ = value != nullptr && value->v[0] > 0 ? value->v[0] : 2.2;
    }
}

}  // namespace sundog::pov
