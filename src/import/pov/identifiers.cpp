// SPDX-License-Identifier: Apache-2.0
#include "import/pov/identifiers.h"

#include <algorithm>

namespace sundog::pov {

std::string describe(const Entity& entity) {
    struct Visitor {
        std::string operator()(std::monostate) const { return "nothing yet"; }
        std::string operator()(const Value& value) const {
            return value.is_color ? "a colour" : value.count == 1 ? "a float" : "a vector";
        }
        std::string operator()(const std::string&) const { return "a string"; }
        std::string operator()(const BlockGroup& group) const {
            return group.empty() ? "nothing" : "a " + std::string(spelling(group.front()->keyword));
        }
        std::string operator()(const std::shared_ptr<const FunctionExpression>&) const { return "a function"; }
        std::string operator()(const std::shared_ptr<const Spline>&) const { return "a spline"; }
        std::string operator()(const std::shared_ptr<Array>&) const { return "an array"; }
        std::string operator()(const std::shared_ptr<const Macro>&) const { return "a macro"; }
        std::string operator()(const std::shared_ptr<OpenFile>&) const { return "an open file"; }
    };
    return std::visit(Visitor{}, entity);
}

Array& own_array(std::shared_ptr<Array>& array) {
    if (array.use_count() > 1) array = std::make_shared<Array>(*array);
    return *array;
}

std::vector<Identifiers::Binding>& Identifiers::bindings(NameId name) {
    if (name >= symbols_.size()) symbols_.resize(std::max<std::size_t>(name + 1, symbols_.size() * 2));
    return symbols_[name];
}

std::uint32_t Identifiers::new_cell() {
    if (free_.empty()) {
        cells_.emplace_back().references = 1;
        return static_cast<std::uint32_t>(cells_.size() - 1);
    }
    const std::uint32_t cell = free_.back();
    free_.pop_back();
    cells_[cell].references = 1;
    return cell;
}

void Identifiers::release(std::uint32_t cell) {
    Cell& c = cells_[cell];
    if (--c.references > 0) return;
    const bool was_element = c.is_element;
    const std::uint32_t array_cell = c.array_cell;
    c.value = std::monostate{};
    c.is_element = false;
    c.deprecated.clear();
    free_.push_back(cell);
    if (was_element) release(array_cell);
}

Entity* Identifiers::value_of(std::uint32_t cell) {
    Cell& c = cells_[cell];
    if (!c.is_element) return &c.value;
    Entity* owner = value_of(c.array_cell);
    auto* array = owner == nullptr ? nullptr : std::get_if<std::shared_ptr<Array>>(owner);
    // The array may have been replaced by a smaller one or by something else since.
    if (array == nullptr || c.element >= (*array)->elements.size()) return nullptr;
    return &own_array(*array).elements[c.element];
}

void Identifiers::leave_level() {
    for (const NameId name : levels_.back()) {
        std::vector<Binding>& stack = symbols_[name];
        const auto level = static_cast<std::uint32_t>(levels_.size() - 1);
        if (!stack.empty() && stack.back().level == level) {
            release(stack.back().cell);
            stack.pop_back();
        }
    }
    levels_.pop_back();
}

Entity& Identifiers::declare(NameId name) {
    std::vector<Binding>& stack = bindings(name);
    if (stack.empty()) {
        stack.push_back({0, new_cell()});
        levels_.front().push_back(name);
    }
    return cell_to_assign(stack.back().cell);
}

Entity& Identifiers::cell_to_assign(std::uint32_t cell) {
    if (Entity* value = value_of(cell); value != nullptr) {
        cells_[cell].deprecated.clear();
        return *value;
    }
    cells_[cell].is_element = false;
    release(cells_[cell].array_cell);
    return cells_[cell].value;
}

Entity& Identifiers::declare_local(NameId name, std::uint32_t level) {
    std::vector<Binding>& stack = bindings(name);
    auto place = stack.end();
    while (place != stack.begin() && std::prev(place)->level > level) --place;
    if (place == stack.begin() || std::prev(place)->level != level) {
        place = stack.insert(place, {level, new_cell()});
        levels_[level].push_back(name);
    } else {
        --place;
    }
    return cell_to_assign(place->cell);
}

std::uint32_t Identifiers::reference(NameId target) {
    std::vector<Binding>& stack = bindings(target);
    if (stack.empty()) {
        stack.push_back({0, new_cell()});
        levels_.front().push_back(target);
    }
    ++cells_[stack.back().cell].references;
    return stack.back().cell;
}

std::uint32_t Identifiers::reference_element(NameId array, std::uint32_t element) {
    const std::uint32_t array_cell = reference(array);
    const std::uint32_t cell = new_cell();
    cells_[cell].is_element = true;
    cells_[cell].array_cell = array_cell;
    cells_[cell].element = element;
    return cell;
}

std::uint32_t Identifiers::hold(Entity&& value) {
    const std::uint32_t cell = new_cell();
    cells_[cell].value = std::move(value);
    return cell;
}

void Identifiers::bind(NameId name, std::uint32_t cell) {
    bindings(name).push_back({level(), cell});
    levels_.back().push_back(name);
}

bool Identifiers::undefine(NameId name) {
    if (name >= symbols_.size() || symbols_[name].empty()) return false;
    // The level's list keeps the name; leave_level() looks at what is still bound there.
    release(symbols_[name].back().cell);
    symbols_[name].pop_back();
    return true;
}

std::vector<NameId> Identifiers::declared() const {
    std::vector<NameId> names;
    for (NameId name = 0; name < symbols_.size(); ++name)
        if (!symbols_[name].empty()) names.push_back(name);
    return names;
}

}  // namespace sundog::pov
