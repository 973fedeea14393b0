// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/accessor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace sundog::import::gltf {
namespace {

/// glTF's numbers for component types, which are OpenGL's.
enum class Component : std::uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

struct Type {
    std::string_view name;
    std::size_t width;
    std::size_t rows;  ///< Of a matrix's column.
};
constexpr std::array<Type, 7> kTypes{{{"SCALAR", 1, 1},
                                      {"VEC2", 2, 2},
                                      {"VEC3", 3, 3},
                                      {"VEC4", 4, 4},
                                      {"MAT2", 4, 2},
                                      {"MAT3", 9, 3},
                                      {"MAT4", 16, 4}}};

static_assert(std::endian::native == std::endian::little, "buffers are read as they lie");

std::size_t size_of(Component component) {
    switch (component) {
        case Component::i8:
        case Component::u8:
            return 1;
        case Component::i16:
        case Component::u16:
            return 2;
        case Component::u32:
        case Component::f32:
            return 4;
    }
    return 4;
}

Component component_of(const Json& json) {
    const std::size_t number = json.whole();
    if (number < 5120 || number > 5126 || number == 5124)
        json.fail("unknown component type " + std::to_string(number), "expected one of: 5120 to 5123, 5125, 5126");
    return static_cast<Component>(number);
}

template <class T>
T load(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// Section 3.11 "Animations" has the formulas of normalised integers.
float load_float(const unsigned char* at, Component component, bool normalized) {
    switch (component) {
        case Component::i8: {
            const float v = load<std::int8_t>(at);
            return normalized ? std::max(v / 127, -1.0F) : v;
        }
        case Component::u8: {
            const float v = *at;
            return normalized ? v / 255 : v;
        }
        case Component::i16: {
            const float v = load<std::int16_t>(at);
            return normalized ? std::max(v / 32767, -1.0F) : v;
        }
        case Component::u16: {
            const float v = load<std::uint16_t>(at);
            return normalized ? v / 65535 : v;
        }
        case Component::u32:
            return static_cast<float>(load<std::uint32_t>(at));
        case Component::f32:
            return load<float>(at);
    }
    return 0;
}

std::uint32_t load_whole(const unsigned char* at, Component component) {
    if (component == Component::u8) return *at;
    return component == Component::u16 ? load<std::uint16_t>(at) : load<std::uint32_t>(at);
}

/// An accessor's description, or that of the indices or values of a sparse one.
struct Layout {
    Json json;
    std::size_t count = 0;
    Type type{};
    Component component = Component::f32;
    bool normalized = false;

    /// Matrices' columns start at multiples of four bytes.
    [[nodiscard]] std::size_t column_bytes() const {
        const std::size_t bytes = type.rows * size_of(component);
        return type.name.starts_with("MAT") ? (bytes + 3) / 4 * 4 : bytes;
    }
    [[nodiscard]] std::size_t element_bytes() const { return column_bytes() * (type.width / type.rows); }
    /// Where in an element its number `i` lies.
    [[nodiscard]] std::size_t offset_of(std::size_t i) const {
        return i / type.rows * column_bytes() + i % type.rows * size_of(component);
    }
};

/// Where elements lie.
struct Elements {
    const unsigned char* first = nullptr;
    std::size_t stride = 0;
};

/// The bytes of `layout.count` elements; `json` has the view and the offset in it.
Elements elements_of(Asset& asset, const Json& json, const Layout& layout, bool may_have_stride) {
    const std::size_t index = json.required_index("bufferView", asset.list("bufferViews").size(), "bufferViews");
    const Json view = asset.list("bufferViews")[index];
    const Bytes bytes = asset.view(index);
    const Json stride_json = may_have_stride ? view.member("byteStride") : Json{};
    const std::size_t element = layout.element_bytes();
    const std::size_t stride = stride_json ? stride_json.whole(UINT32_MAX) : element;
    if (stride < element)
        stride_json.fail("a stride of " + std::to_string(stride) + " bytes for elements of " + std::to_string(element) +
                         " (" + layout.json.path() + ')');
    const std::size_t offset = json.whole_or("byteOffset", 0);
    // In elements, so that nothing overflows.
    const bool fits = layout.count == 0 || (offset <= bytes.size() && element <= bytes.size() - offset &&
                                            layout.count - 1 <= (bytes.size() - offset - element) / stride);
    if (!fits)
        json.fail(std::to_string(layout.count) + " elements of " + std::to_string(element) + " bytes, " +
                  std::to_string(stride) + " apart, from byte " + std::to_string(offset) +
                  " on don't fit bufferViews[" + std::to_string(index) + "], which has " +
                  std::to_string(bytes.size()) + " bytes");
    return {bytes.data() + offset, stride};
}

Layout layout_of(Asset& asset, const Json& user) {
    const Json json = asset.list("accessors")[user.index(asset.list("accessors").size(), "accessors")];
    Layout layout{json};
    layout.count = json.required("count").whole(UINT32_MAX - 1);
    layout.component = component_of(json.required("componentType"));
    layout.normalized = json.boolean_or("normalized", false);
    const Json type = json.required("type");
    const auto* const known =
        std::find_if(kTypes.begin(), kTypes.end(), [&](const Type& t) { return t.name == type.string(); });
    if (known == kTypes.end())
        type.fail("unknown type " + in_quotes(type.string()),
                  "expected one of: SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
    layout.type = *known;
    return layout;
}

/// Calls put(element, number in it, where it lies) for all of an accessor, then for what is sparse in it.
template <class Put>
void read_elements(Asset& asset, const Layout& layout, const Put& put) {
    const auto put_element = [&](std::size_t element, const unsigned char* at) {
        for (std::size_t i = 0; i < layout.type.width; ++i) put(element, i, at + layout.offset_of(i));
    };
    if (layout.json.member("bufferView")) {
        const Elements elements = elements_of(asset, layout.json, layout, true);
        for (std::size_t i = 0; i < layout.count; ++i) put_element(i, elements.first + i * elements.stride);
    }
    const Json sparse = layout.json.member("sparse");
    if (!sparse) return;
    const Json indices_json = sparse.required("indices");
    Layout indices{indices_json, sparse.required("count").whole(layout.count), kTypes[0],
                   component_of(indices_json.required("componentType")), false};
    if (indices.component != Component::u8 && indices.component != Component::u16 &&
        indices.component != Component::u32)
        indices_json.required("componentType").fail("indices are unsigned", "expected one of: 5121, 5123, 5125");
    const Elements where = elements_of(asset, indices_json, indices, false);
    Layout values = layout;
    values.count = indices.count;
    const Elements what = elements_of(asset, sparse.required("values"), values, false);
    for (std::size_t i = 0; i < indices.count; ++i) {
        const std::uint32_t element = load_whole(where.first + i * where.stride, indices.component);
        if (element >= layout.count)
            indices_json.fail("element " + std::to_string(element) + " of " + std::to_string(layout.count) +
                              " is replaced");
        put_element(element, what.first + i * what.stride);
    }
}

/// Before memory is taken for them: elements must lie in their view, and those that no bytes stand for cost a file
/// nothing, so there can't be many.
void check_count(Asset& asset, const Layout& layout) {
    constexpr std::size_t kMost = std::size_t{1} << 24U;
    if (layout.json.member("bufferView")) elements_of(asset, layout.json, layout, true);
    else if (layout.count > kMost) layout.json.fail(std::to_string(layout.count) + " elements without a bufferView");
}

std::string listed(const std::vector<std::string_view>& types) {
    std::string text;
    for (const std::string_view type : types) text.append(text.empty() ? "" : " or ").append(type);
    return text;
}

}  // namespace

std::size_t accessor_count(Asset& asset, const Json& user) { return layout_of(asset, user).count; }

Numbers read_numbers(Asset& asset, const Json& user, const AccessorKind& kind) {
    const Layout layout = layout_of(asset, user);
    if (std::find(kind.types.begin(), kind.types.end(), layout.type.name) == kind.types.end())
        user.fail(layout.json.path() + " is of type " + std::string(layout.type.name),
                  "expected " + listed(kind.types));
    if (layout.component == Component::u32 ||
        (layout.component != Component::f32 && !layout.normalized && !kind.may_be_whole))
        user.fail(layout.json.path() + " holds whole numbers", "expected floats, or integers that are normalized");
    check_count(asset, layout);
    asset.take_memory(layout.count * layout.type.width * sizeof(float), layout.json);
    Numbers numbers{layout.count, layout.type.width, std::vector<float>(layout.count * layout.type.width)};
    read_elements(asset, layout, [&](std::size_t element, std::size_t i, const unsigned char* at) {
        numbers.values[element * layout.type.width + i] = load_float(at, layout.component, layout.normalized);
    });
    const auto bad =
        std::find_if(numbers.values.begin(), numbers.values.end(), [](float v) { return !std::isfinite(v); });
    if (bad != numbers.values.end())
        layout.json.fail("element " +
                         std::to_string(static_cast<std::size_t>(bad - numbers.values.begin()) / layout.type.width) +
                         " is not finite");
    return numbers;
}

std::vector<std::uint32_t> read_whole_numbers(Asset& asset, const Json& user, std::string_view type) {
    const Layout layout = layout_of(asset, user);
    if (layout.type.name != type)
        user.fail(layout.json.path() + " is of type " + std::string(layout.type.name), "expected " + std::string(type));
    const bool is_unsigned =
        layout.component == Component::u8 || layout.component == Component::u16 || layout.component == Component::u32;
    if (!is_unsigned || layout.normalized)
        user.fail(layout.json.path() + " doesn't hold unsigned whole numbers",
                  "expected a componentType of 5121, 5123 or 5125");
    check_count(asset, layout);
    asset.take_memory(layout.count * layout.type.width * sizeof(std::uint32_t), layout.json);
    std::vector<std::uint32_t> numbers(layout.count * layout.type.width);
    read_elements(asset, layout, [&](std::size_t element, std::size_t i, const unsigned char* at) {
        numbers[element * layout.type.width + i] = load_whole(at, layout.component);
    });
    return numbers;
}

}  // namespace sundog::import::gltf
