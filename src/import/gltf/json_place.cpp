// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/json_place.h"

#include <algorithm>

namespace sundog::import::gltf {
namespace {

/// Steps over the parts of a valid text. Nothing here may loop for ever where it isn't valid after all.
class JsonWalk {
public:
    explicit JsonWalk(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip_blanks() {
        while (at_ < text_.size() && (here() == ' ' || here() == '\t' || here() == '\n' || here() == '\r')) ++at_;
    }
    void take() { at_ = std::min(at_ + 1, text_.size()); }

    /// Takes a string, and returns what is between its quotes, as written.
    std::string_view string() {
        take();
        const std::size_t first = at_;
        while (at_ < text_.size() && here() != '"') {
            if (here() == '\\') take();
            take();
        }
        const std::string_view inside = text_.substr(first, at_ - first);
        take();
        return inside;
    }

    void skip_value() {
        std::size_t depth = 0;
        do {
            skip_blanks();
            const char c = here();
            if (c == '"') {
                string();
            } else if (c == '{' || c == '[') {
                ++depth;
                take();
            } else if (c == '}' || c == ']') {
                if (depth == 0) return;
                --depth;
                take();
            } else if (c == ',' || c == ':') {
                take();
            } else {
                skip_word();
            }
        } while (depth > 0 && at_ < text_.size());
    }

private:
    void skip_word() {
        const std::size_t end = text_.find_first_of(",:]}{[\" \t\r\n", at_);
        at_ = std::max(std::min(end, text_.size()), std::min(at_ + 1, text_.size()));
    }

    std::string_view text_;
    std::size_t at_;
};

/// Goes from an object's brace to the value of a member: of the last one of that name, as the parser takes it.
bool enter_member(JsonWalk& walk, const std::string& name) {
    JsonWalk found = walk;
    bool any = false;
    walk.take();
    for (walk.skip_blanks(); walk.here() == '"'; walk.skip_blanks()) {
        const bool same = walk.string() == name;
        walk.skip_blanks();
        walk.take();
        walk.skip_blanks();
        if (same) found = walk, any = true;
        walk.skip_value();
        walk.skip_blanks();
        if (walk.here() == ',') walk.take();
    }
    walk = found;
    return any;
}

bool enter_element(JsonWalk& walk, std::size_t number) {
    walk.take();
    for (std::size_t i = 0; i < number; ++i) {
        walk.skip_value();
        walk.skip_blanks();
        if (walk.here() != ',') return false;
        walk.take();
    }
    walk.skip_blanks();
    return true;
}

}  // namespace

std::string path_text(const std::vector<JsonStep>& steps) {
    std::string path;
    for (const JsonStep& step : steps) {
        if (const auto* name = std::get_if<std::string>(&step)) path += (path.empty() ? "" : ".") + *name;
        else path += '[' + std::to_string(std::get<std::size_t>(step)) + ']';
    }
    return path;
}

std::size_t place_of(std::string_view text, const std::vector<JsonStep>& steps) {
    JsonWalk walk(text);
    walk.skip_blanks();
    for (const JsonStep& step : steps) {
        const JsonWalk before = walk;
        const auto* name = std::get_if<std::string>(&step);
        if (name ? enter_member(walk, *name) : enter_element(walk, std::get<std::size_t>(step))) continue;
        walk = before;
        break;
    }
    return walk.at();
}

std::size_t level_count(std::string_view text) {
    std::size_t depth = 0;
    std::size_t most = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            else if (c == '"') in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            most = std::max(most, ++depth);
        } else if ((c == '}' || c == ']') && depth > 0) {
            --depth;
        }
    }
    return most;
}

std::vector<std::size_t> element_places(std::string_view text, std::size_t array_at, std::size_t count) {
    JsonWalk walk(text, array_at);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count; ++i) {
        walk.take();  // The bracket, or the comma.
        walk.skip_blanks();
        places.push_back(walk.at());
        walk.skip_value();
        walk.skip_blanks();
    }
    return places;
}

}  // namespace sundog::import::gltf
