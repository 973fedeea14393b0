// SPDX-License-Identifier: Apache-2.0
#include "import/pov/format_blocks.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sundog::pov {
namespace {

using FunctionList = std::vector<std::shared_ptr<const FunctionExpression>>;

/// The shortest decimal that reads back as the same double.
void print(std::string& text, double number) {
    if (std::isnan(number)) number = 0;
    // There is no word for infinity; a number too large for a double reads as it.
    if (std::isinf(number)) {
        text += number < 0 ? "-1e999" : "1e999";
        return;
    }
    std::array<char, 32> buffer{};
    text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr);
}

void print_numbers(std::string& text, const double* numbers, std::size_t count) {
    if (count > 1) text += '<';
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) text += ", ";
        print(text, numbers[i]);
    }
    if (count > 1) text += '>';
}

void print(std::string& text, const Value& value) {
    if (value.is_color) text += "rgbft ";
    print_numbers(text, value.v.data(), value.count);
}

void print_string(std::string& text, const std::string& string) {
    text += '"';
    for (const char c : string) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') (text += '\\') += c;
        else if (c == '\n') text += "\\n";
        else if (c == '\0') text += "\\0";
        else if (byte < 0x20) {
            constexpr std::string_view kHex = "0123456789abcdef";
            ((text += "\\u00") += kHex[byte >> 4U]) += kHex[byte & 15U];
        } else text += c;
    }
    text += '"';
}

class Printer {
public:
    Printer(std::string& text, FunctionList& functions) : text_(text), functions_(functions) {}

    void block(const Block& block, std::size_t indent) {
        text_ += spelling(block.keyword);
        text_ += " {";
        if (const bool in_one_line = block.depth == 1 && block.items.size() < 8) {
            text_ += ' ';
            items(block.items, indent, " ");
            text_ += in_one_line && !block.items.empty() ? " }" : "}";
            return;
        }
        const std::string line = '\n' + std::string(2 * indent + 2, ' ');
        text_ += line;
        items(block.items, indent + 1, line);
        text_ += '\n' + std::string(2 * indent, ' ') + '}';
    }

    /// Prints the functions that a block uses, which must come before it.
    void functions_of(const Block& block) { functions_of(block.items); }

private:
    void functions_of(const std::vector<Item>& items) {
        for (const Item& item : items) {
            if (const auto* inner = std::get_if<std::shared_ptr<const Block>>(&item.content))
                functions_of((*inner)->items);
            if (const auto* row = std::get_if<std::shared_ptr<const Row>>(&item.content)) functions_of((*row)->items);
            if (const auto* function = std::get_if<std::shared_ptr<const FunctionExpression>>(&item.content))
                for (const auto& callee : (*function)->callees) declare(callee);
        }
    }
    void declare(const std::shared_ptr<const FunctionExpression>& function) {
        if (std::find(functions_.begin(), functions_.end(), function) != functions_.end()) return;
        for (const auto& callee : function->callees) declare(callee);
        if (function->block) functions_of(*function->block);
        text_ += "#declare Function_" + std::to_string(functions_.size()) + " = ";
        print_function(*function, 0);
        text_ += ";\n";
        functions_.push_back(function);
    }

    void items(const std::vector<Item>& items, std::size_t indent, const std::string& separator) {
        const Item* before = nullptr;
        for (const Item& item : items) {
            const bool is_value = std::holds_alternative<Value>(item.content);
            if (before != nullptr) {
                // A value behind a value or a bare word needs a comma, or it would go on with it.
                const bool after_value = std::holds_alternative<Value>(before->content) ||
                                         std::holds_alternative<std::shared_ptr<const ValueList>>(before->content);
                const bool after_word = std::holds_alternative<Keyword>(before->content);
                if (after_value && (is_value || std::holds_alternative<std::shared_ptr<const ValueList>>(item.content)))
                    text_ += ", ";
                else text_ += after_word && is_value ? " " : separator;
            }
            one(item, indent);
            before = &item;
        }
    }

    void one(const Item& item, std::size_t indent) {
        struct Visitor {
            Printer& printer;
            std::size_t indent;
            void operator()(const Value& value) const { print(printer.text_, value); }
            void operator()(Keyword keyword) const { printer.text_ += spelling(keyword); }
            void operator()(const std::string& string) const { print_string(printer.text_, string); }
            void operator()(const std::shared_ptr<const Block>& block) const { printer.block(*block, indent); }
            void operator()(const std::shared_ptr<const Row>& row) const {
                printer.text_ += '[';
                printer.items(row->items, indent, " ");
                printer.text_ += ']';
            }
            void operator()(const std::shared_ptr<const FunctionExpression>& function) const {
                printer.print_function(*function, indent);
            }
            void operator()(const std::shared_ptr<const ValueList>& list) const {
                const double* next = list->numbers.data();
                for (std::size_t i = 0; i < list->counts.size(); ++i) {
                    if (i > 0) printer.text_ += i % 8 == 0 ? ",\n" + std::string(2 * indent, ' ') : ", ";
                    print_numbers(printer.text_, next, list->counts[i]);
                    next += list->counts[i];
                }
            }
        };
        std::visit(Visitor{*this, indent}, item.content);
    }

    void print_function(const FunctionExpression& function, std::size_t indent) {
        text_ += "function";
        if (function.kind == FunctionKind::expression) {
            text_ += "(";
            for (std::size_t i = 0; i < function.parameters.size(); ++i)
                (text_ += i > 0 ? ", " : "") += function.parameters[i];
            text_ += ")";
        }
        text_ += " { ";
        switch (function.kind) {
            case FunctionKind::expression:
                print_nodes(function);
                break;
            case FunctionKind::internal:
                text_ += "internal(" + std::to_string(function.internal_number) + ")";
                break;
            case FunctionKind::spline:
                print_spline(*function.spline);
                break;
            default:
                block(*function.block, indent);
                break;
        }
        text_ += " }";
    }

    void print_spline(const Spline& spline) {
        constexpr std::array kNames{"linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"};
        (text_ += "spline { ") += kNames[static_cast<std::size_t>(spline.kind)];
        for (const Spline::Point& point : spline.points) {
            text_ += ' ';
            print(text_, point.parameter);
            text_ += ", ";
            print_numbers(text_, point.at.data(), spline.components);
        }
        text_ += " }";
    }

    /// Prints the nodes as one expression in parentheses. Each node's text is put together from its arguments', in
    /// their order, so that long sums need no deep recursion.
    void print_nodes(const FunctionExpression& function) {
        std::vector<std::string> texts(function.nodes.size());
        for (std::size_t i = 0; i < function.nodes.size(); ++i) {
            const FunctionNode& node = function.nodes[i];
            const auto argument = [&](std::uint32_t k) {
                return std::move(texts[function.arguments[node.first_argument + k]]);
            };
            std::string& text = texts[i];
            switch (node.op) {
                case FunctionOp::constant:
                    print(text, node.number);
                    break;
                case FunctionOp::variable:
                    text = variable(function, node.index);
                    break;
                case FunctionOp::negate:
                    text = "(-" + argument(0) + ")";
                    break;
                case FunctionOp::logical_not:
                    text = "(!" + argument(0) + ")";
                    break;
                case FunctionOp::sum:
                case FunctionOp::product:
                    text = (node.op == FunctionOp::sum ? "sum(" : "prod(") + variable(function, node.index);
                    for (std::uint32_t k = 0; k < 3; ++k) text += ", " + argument(k);
                    text += ')';
                    break;
                case FunctionOp::builtin:
                case FunctionOp::user: {
                    text = node.op == FunctionOp::builtin ? std::string(spelling(node.keyword))
                                                          : name_of(function.callees[node.index]);
                    text += '(';
                    for (std::uint32_t k = 0; k < node.argument_count; ++k) text += (k > 0 ? ", " : "") + argument(k);
                    text += ')';
                    if (node.op == FunctionOp::user)
                        text += component_suffix(*function.callees[node.index], node.component);
                    break;
                }
                default:
                    text = '(' + argument(0) + std::string(operator_of(node.op)) + argument(1) + ')';
                    break;
            }
        }
        text_ += texts.back();
    }
    std::string name_of(const std::shared_ptr<const FunctionExpression>& function) const {
        const auto known = std::find(functions_.begin(), functions_.end(), function);
        return "Function_" + std::to_string(known - functions_.begin());
    }
    static std::string variable(const FunctionExpression& function, std::uint32_t index) {
        return index < function.parameters.size() ? function.parameters[index] : "Counter_" + std::to_string(index);
    }
    static std::string component_suffix(const FunctionExpression& function, std::uint8_t component) {
        const bool is_vector = function.kind == FunctionKind::pigment || function.kind == FunctionKind::transform ||
                               function.kind == FunctionKind::spline;
        constexpr std::array kNames{".x", ".y", ".z", ".t", ".transmit", ".gray"};
        return is_vector ? kNames[component] : "";
    }
    static std::string_view operator_of(FunctionOp op) {
        switch (op) {
            case FunctionOp::add:
                return " + ";
            case FunctionOp::subtract:
                return " - ";
            case FunctionOp::multiply:
                return " * ";
            case FunctionOp::divide:
                return " / ";
            case FunctionOp::less:
                return " < ";
            case FunctionOp::less_equal:
                return " <= ";
            case FunctionOp::equal:
                return " = ";
            case FunctionOp::not_equal:
                return " != ";
            case FunctionOp::greater_equal:
                return " >= ";
            case FunctionOp::greater:
                return " > ";
            case FunctionOp::logical_and:
                return " & ";
            default:
                return " | ";
        }
    }

    std::string& text_;
    FunctionList& functions_;
};

}  // namespace

void FormattingSink::add(Block&& block) {
    if (block.version != version_) {
        version_ = block.version;
        text_ += "#version ";
        print(text_, version_ / 100.0);
        text_ += ";\n";
    }
    Printer printer(text_, functions_);
    if (block.defaults && block.defaults != defaults_) {
        // Those printed before are the first of these.
        Block added = *block.defaults;
        if (defaults_)
            added.items.erase(added.items.begin(),
                              added.items.begin() + static_cast<std::ptrdiff_t>(defaults_->items.size()));
        defaults_ = block.defaults;
        printer.functions_of(added);
        text_ += '#';
        printer.block(added, 0);
        text_ += '\n';
    }
    printer.functions_of(block);
    printer.block(block, 0);
    text_ += '\n';
}

}  // namespace sundog::pov
