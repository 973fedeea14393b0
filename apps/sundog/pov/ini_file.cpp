// SPDX-License-Identifier: Apache-2.0
#include "ini_file.h"

#include "option_table.h"

namespace sundog::app {
namespace {

/// Where the quote that opens at `at` closes; npos for one that never does, which is then a mere apostrophe.
std::size_t end_of_quote(std::string_view text, std::size_t at) { return text.find(text[at], at + 1); }

bool opens_quote(char c) { return c == '"' || c == '\''; }

std::string_view without_comment(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == ';') return line.substr(0, i);
        if (!opens_quote(line[i])) continue;
        const std::size_t close = end_of_quote(line, i);
        if (close != std::string_view::npos) i = close;
    }
    return line;
}

IniLine parse_line(std::string_view text) {
    IniLine line;
    if (text.front() == '+' || text.front() == '-') {
        line.kind = IniLine::Kind::switches;
        line.words = words_of(text);
        return line;
    }
    const std::size_t equals = text.find('=');
    line.name = std::string(trimmed(text.substr(0, equals)));
    if (equals == std::string_view::npos) line.kind = IniLine::Kind::file;
    else line.value = std::string(trimmed(text.substr(equals + 1)));
    return line;
}

}  // namespace

std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    std::string word;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
            if (!word.empty()) words.push_back(std::move(word));
            word.clear();
            continue;
        }
        const std::size_t close = opens_quote(line[i]) ? end_of_quote(line, i) : std::string_view::npos;
        if (close == std::string_view::npos) {
            word += line[i];
        } else {
            word += line.substr(i, close - i + 1);
            i = close;
        }
    }
    if (!word.empty()) words.push_back(std::move(word));
    return words;
}

bool visit_ini_file(const std::filesystem::path& file, std::string_view label, const IniVisitor& visit) {
    const SourceText source = read_text_file(file);
    const std::string wanted = lower_case(trimmed(label));
    LineReader reader(source);
    bool counts = true, found = wanted.empty();
    for (std::string_view raw; reader.next(raw);) {
        const std::string_view text = trimmed(without_comment(raw));
        if (text.empty() || text.front() == '#') continue;
        LineCursor cursor = reader.cursor(raw);
        if (text.front() == '[') {
            const std::size_t close = text.find(']');
            if (close == std::string_view::npos)
                cursor.fail(cursor.here(), "the section's label has no end", "expected [label]");
            counts = !wanted.empty() && lower_case(trimmed(text.substr(1, close - 1))) == wanted;
            found = found || counts;
        } else if (counts) {
            visit(parse_line(text), cursor);
        }
    }
    return found;
}

}  // namespace sundog::app
