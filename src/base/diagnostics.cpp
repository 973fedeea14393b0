// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostics.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace sundog {
namespace {

constexpr std::size_t kMostShownColumns = 160;

/// The part of `line` to show, made printable, and where in it the column lies.
struct Excerpt {
    std::string text;
    std::size_t caret = 0;
};

Excerpt excerpt_around(std::string_view line, std::size_t column) {
    const std::size_t caret = std::min(column == 0 ? 0 : column - 1, line.size());
    std::size_t first = 0;
    if (line.size() > kMostShownColumns && caret > kMostShownColumns / 2) first = caret - kMostShownColumns / 2;
    Excerpt excerpt{std::string(line.substr(first, kMostShownColumns)), caret - first};
    for (char& c : excerpt.text) {
        if (c == '\t') c = ' ';
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    if (first > 0) excerpt.text = "..." + excerpt.text, excerpt.caret += 3;
    if (first + kMostShownColumns < line.size()) excerpt.text += "...";
    return excerpt;
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Optimal string alignment: insertion, deletion, substitution and swap of neighbours cost 1 each.
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

std::string format(const Diagnostic& diagnostic) {
    std::string text;
    if (diagnostic.where.file) {
        text += *diagnostic.where.file;
        if (diagnostic.where.line > 0) text += ':' + std::to_string(diagnostic.where.line);
        if (diagnostic.where.line > 0 && diagnostic.where.column > 0)
            text += ':' + std::to_string(diagnostic.where.column);
        text += ": ";
    }
    text += diagnostic.severity == Severity::error ? "error: " : "warning: ";
    text += diagnostic.message;
    if (!diagnostic.source_line.empty() && diagnostic.where.line > 0) {
        const Excerpt excerpt = excerpt_around(diagnostic.source_line, diagnostic.where.column);
        const std::string number = std::to_string(diagnostic.where.line);
        const std::string margin(std::max<std::size_t>(number.size(), 5), ' ');
        text += '\n' + std::string(margin.size() - number.size(), ' ') + number + " | " + excerpt.text;
        if (diagnostic.where.column > 0) text += '\n' + margin + " | " + std::string(excerpt.caret, ' ') + '^';
    }
    if (!diagnostic.hint.empty()) text += "\nhint: " + diagnostic.hint;
    return text;
}

InputError::InputError(Diagnostic diagnostic)
    : std::runtime_error(format(diagnostic)), diagnostic_(std::move(diagnostic)) {}

std::vector<std::string> nearest_names(std::string_view misspelt, std::span<const std::string_view> valid,
                                       std::size_t limit) {
    struct Candidate {
        std::size_t distance;
        std::string_view name;
    };
    std::vector<Candidate> candidates;
    for (const std::string_view name : valid) {
        const std::size_t allowed = std::max<std::size_t>(1, std::max(name.size(), misspelt.size()) / 3);
        // Lengths alone bound the distance from below; hostile names may be megabytes long.
        const std::size_t longer = std::max(name.size(), misspelt.size());
        const std::size_t shorter = std::min(name.size(), misspelt.size());
        if (longer - shorter > allowed) continue;
        const std::size_t distance = edit_distance(misspelt, name);
        if (distance <= allowed) candidates.push_back({distance, name});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    std::vector<std::string> names;
    for (const Candidate& candidate : candidates) {
        if (names.size() == limit) break;
        names.emplace_back(candidate.name);
    }
    return names;
}

std::string suggest(std::string_view misspelt, std::span<const std::string_view> valid) {
    const std::vector<std::string> near = nearest_names(misspelt, valid);
    std::string text;
    if (near.empty()) {
        text = "expected one of: ";
        for (std::size_t i = 0; i < valid.size(); ++i) text += (i > 0 ? ", " : "") + std::string(valid[i]);
        return text;
    }
    text = "did you mean ";
    for (std::size_t i = 0; i < near.size(); ++i) text += (i > 0 ? " or '" : "'") + near[i] + "'";
    return text + '?';
}

}  // namespace sundog
