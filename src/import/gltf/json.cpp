// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "import/gltf/json_place.h"

namespace sundog::import::gltf {
namespace {

using Node = nlohmann::json;

const Node& node_of(const void* node) { return *static_cast<const Node*>(node); }

/// The steps that lead to a node, which is part of the tree below `top`. False if it isn't.
bool find_steps(const Node& top, const Node* wanted, std::vector<JsonStep>& steps) {
    if (&top == wanted) return true;
    if (top.is_object()) {
        for (auto it = top.begin(); it != top.end(); ++it) {
            steps.emplace_back(it.key());
            if (find_steps(it.value(), wanted, steps)) return true;
            steps.pop_back();
        }
    } else if (top.is_array()) {
        for (std::size_t i = 0; i < top.size(); ++i) {
            steps.emplace_back(i);
            if (find_steps(top[i], wanted, steps)) return true;
            steps.pop_back();
        }
    }
    return false;
}

/// A message about the byte `at` of a text.
Diagnostic diagnose_at(Severity severity, const SourceText& source, std::size_t at, std::string message,
                       std::string hint) {
    const std::string_view text = source.text;
    at = std::min(at, text.size());
    const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const std::size_t first = newline == std::string_view::npos ? 0 : newline + 1;
    const auto line = static_cast<std::uint32_t>(
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(first), '\n'));
    const std::string_view rest = text.substr(first);
    return diagnose(severity, source, rest.substr(0, rest.find('\n')), line, text.data() + at, std::move(message),
                    std::move(hint));
}

/// Most levels of values in values: far more than any file has, and few enough for find_steps' recursion.
constexpr std::size_t kMostLevels = 200;

/// What the parser says, without what a Diagnostic says anyway.
std::string plain_message(const nlohmann::json::exception& error) {
    const std::string said = error.what();
    for (const char* const before : {" - ", "]"}) {
        const std::size_t at = said.find(before);
        if (at == std::string::npos) continue;
        std::string rest = said.substr(at + std::char_traits<char>::length(before));
        rest.erase(0, rest.find_first_not_of(' '));
        // "unexpected ']'; expected '}'" and the text read last.
        return "not JSON: " + rest.substr(0, rest.find("; last read"));
    }
    return "not JSON";
}

Node parse(const SourceText& source) {
    // Not by the parser's own callback, with which its time grows with the square of an array's length.
    if (level_count(source.text) > kMostLevels)
        fail_file(source.name, "the JSON text has more than " + std::to_string(kMostLevels) + " levels");
    try {
        return Node::parse(source.text.begin(), source.text.end());
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t at = error.byte > 0 ? error.byte - 1 : 0;
        throw InputError(diagnose_at(Severity::error, source, at, plain_message(error), {}));
    } catch (const nlohmann::json::exception& error) {
        fail_file(source.name, plain_message(error));  // A number beyond double precision.
    }
}

const char* type_text(const Node& node) {
    if (node.is_string()) return "a string";
    if (node.is_number()) return "a number";
    if (node.is_boolean()) return "true or false";
    if (node.is_array()) return "an array";
    return node.is_object() ? "an object" : "null";
}

}  // namespace

struct JsonDocument::Tree {
    Node top;
};

JsonDocument::JsonDocument(SourceText source)
    : source_(std::move(source)), tree_(std::make_unique<Tree>(Tree{parse(source_)})) {}
JsonDocument::~JsonDocument() = default;

Json JsonDocument::root() const { return {this, &tree_->top}; }

bool Json::is_object() const { return node_ != nullptr && node_of(node_).is_object(); }
bool Json::is_array() const { return node_ != nullptr && node_of(node_).is_array(); }
bool Json::is_string() const { return node_ != nullptr && node_of(node_).is_string(); }

Json Json::member(const char* name) const {
    if (!node_) return {};
    const Node& node = node_of(node_);
    if (!node.is_object()) fail(std::string("expected an object, found ") + type_text(node));
    const auto it = node.find(name);
    return it == node.end() ? Json{} : Json(document_, &*it);
}

Json Json::required(const char* name) const {
    const Json found = member(name);
    if (!found) fail(std::string("lacks '") + name + "'");
    return found;
}

std::vector<std::string> Json::names() const {
    std::vector<std::string> all;
    if (!node_) return all;
    const Node& node = node_of(node_);
    if (!node.is_object()) fail(std::string("expected an object, found ") + type_text(node));
    for (auto it = node.begin(); it != node.end(); ++it) all.push_back(it.key());
    return all;
}

std::size_t Json::size() const {
    if (!node_) return 0;
    const Node& node = node_of(node_);
    if (!node.is_array()) fail(std::string("expected an array, found ") + type_text(node));
    return node.size();
}

Json Json::operator[](std::size_t i) const {
    if (i >= size()) fail("has only " + std::to_string(size()) + " elements");
    return {document_, &node_of(node_)[i]};
}

float Json::number() const {
    const Node& node = node_of(node_);
    if (!node.is_number()) fail(std::string("expected a number, found ") + type_text(node));
    const auto value = node.get<double>();
    if (!(std::abs(value) <= std::numeric_limits<float>::max())) fail("the number is out of range");
    return static_cast<float>(value);
}

bool Json::boolean() const {
    const Node& node = node_of(node_);
    if (!node.is_boolean()) fail(std::string("expected true or false, found ") + type_text(node));
    return node.get<bool>();
}

std::string_view Json::string() const {
    const Node& node = node_of(node_);
    if (!node.is_string()) fail(std::string("expected a string, found ") + type_text(node));
    return node.get_ref<const std::string&>();
}

std::size_t Json::whole(std::size_t most) const {
    constexpr double kExact = 9007199254740992.0;  // 2^53: whole numbers up to there are exact.
    const Node& node = node_of(node_);
    if (!node.is_number()) fail(std::string("expected a whole number, found ") + type_text(node));
    const auto value = node.get<double>();
    if (!(value >= 0 && value <= kExact && value == std::floor(value)))
        fail("expected a whole number of 0 or more, found " + node.dump());
    const auto number = static_cast<std::size_t>(value);
    if (number > most) fail(std::to_string(number) + " is too large", "at most " + std::to_string(most));
    return number;
}

std::vector<float> Json::numbers(std::size_t count) const {
    if (size() != count) fail("expected " + std::to_string(count) + " numbers, found " + std::to_string(size()));
    std::vector<float> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back((*this)[i].number());
    return all;
}

Vec3 Json::vec3() const {
    const std::vector<float> v = numbers(3);
    return {v[0], v[1], v[2]};
}

float Json::number_or(const char* name, float otherwise) const {
    const Json value = member(name);
    return value ? value.number() : otherwise;
}
bool Json::boolean_or(const char* name, bool otherwise) const {
    const Json value = member(name);
    return value ? value.boolean() : otherwise;
}
std::string Json::string_or(const char* name, std::string_view otherwise) const {
    const Json value = member(name);
    return std::string(value ? value.string() : otherwise);
}
std::size_t Json::whole_or(const char* name, std::size_t otherwise) const {
    const Json value = member(name);
    return value ? value.whole() : otherwise;
}
Vec3 Json::vec3_or(const char* name, Vec3 otherwise) const {
    const Json value = member(name);
    return value ? value.vec3() : otherwise;
}
float Json::share_or(const char* name, float otherwise, float least, float most) const {
    return std::clamp(number_or(name, otherwise), least, most);
}

std::size_t Json::index(std::size_t count, const char* what) const {
    const std::size_t number = whole();
    if (number >= count) {
        const std::string have =
            count == 0 ? "the file has none" : "the file has " + std::to_string(count) + ", counted from 0";
        fail("there is no " + std::string(what) + '[' + std::to_string(number) + ']', have);
    }
    return number;
}

std::optional<std::size_t> Json::index_or_none(const char* name, std::size_t count, const char* what) const {
    const Json value = member(name);
    if (!value) return std::nullopt;
    return value.index(count, what);
}

std::size_t Json::required_index(const char* name, std::size_t count, const char* what) const {
    return required(name).index(count, what);
}

Json Json::extension(const char* name) const {
    const Json extensions = member("extensions");
    return extensions ? extensions.member(name) : Json{};
}

std::string Json::path() const {
    std::vector<JsonStep> steps;
    find_steps(document_->tree_->top, static_cast<const Node*>(node_), steps);
    return path_text(steps);
}

SourceLocation Json::location() const { return diagnostic(Severity::error, {}).where; }

std::vector<SourceLocation> Json::element_locations() const {
    std::vector<SourceLocation> locations;
    if (!node_) return locations;
    std::vector<JsonStep> steps;
    find_steps(document_->tree_->top, static_cast<const Node*>(node_), steps);
    const std::string_view text = document_->source_.text;
    std::uint32_t line = 1;
    std::size_t line_start = 0;
    std::size_t seen = 0;
    for (const std::size_t place : element_places(text, place_of(text, steps), size())) {
        for (; seen < place; ++seen)
            if (text[seen] == '\n') ++line, line_start = seen + 1;
        locations.push_back({document_->source_.name, line, static_cast<std::uint32_t>(place - line_start) + 1});
    }
    return locations;
}

Diagnostic Json::diagnostic(Severity severity, std::string message, std::string hint) const {
    std::vector<JsonStep> steps;
    find_steps(document_->tree_->top, static_cast<const Node*>(node_), steps);
    return diagnose_at(severity, document_->source_, place_of(document_->source_.text, steps), std::move(message),
                       std::move(hint));
}

void Json::fail(const std::string& message, std::string hint) const {
    const std::string where = path();
    throw InputError(
        diagnostic(Severity::error, (where.empty() ? "the file" : where) + ": " + message, std::move(hint)));
}

Diagnostic Json::warning(const std::string& message, std::string hint) const {
    const std::string where = path();
    return diagnostic(Severity::warning, (where.empty() ? "the file" : where) + ": " + message, std::move(hint));
}

}  // namespace sundog::import::gltf
