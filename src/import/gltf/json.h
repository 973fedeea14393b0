// SPDX-License-Identifier: Apache-2.0
// Values of a JSON text that know where they stand, for messages.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_file.h"
#include "base/vec.h"

namespace sundog::import::gltf {

class JsonDocument;

/// A value of a document, or nothing. The document must outlive it. Errors are InputErrors at the value, which name
/// its path: "meshes[0].primitives[1].attributes.POSITION".
class Json {
public:
    Json() = default;

    /// True for what is there.
    explicit operator bool() const { return node_ != nullptr; }
    [[nodiscard]] bool is_object() const;
    [[nodiscard]] bool is_array() const;
    [[nodiscard]] bool is_string() const;

    /// A member of an object; nothing where there is none. Errors: this is no object.
    [[nodiscard]] Json member(const char* name) const;
    /// A member that must be there.
    [[nodiscard]] Json required(const char* name) const;
    /// Names of an object's members.
    [[nodiscard]] std::vector<std::string> names() const;
    /// An array's length; 0 for nothing. Errors: this is no array.
    [[nodiscard]] std::size_t size() const;
    /// An array's element, which must be there.
    [[nodiscard]] Json operator[](std::size_t i) const;

    // The value itself, which must be of that type.
    [[nodiscard]] float number() const;
    [[nodiscard]] bool boolean() const;
    [[nodiscard]] std::string_view string() const;
    /// A whole number from 0 to `most`.
    [[nodiscard]] std::size_t whole(std::size_t most = SIZE_MAX) const;
    /// An array of `count` finite numbers.
    [[nodiscard]] std::vector<float> numbers(std::size_t count) const;
    [[nodiscard]] Vec3 vec3() const;

    // The same of a member, or a default where there is none.
    [[nodiscard]] float number_or(const char* name, float otherwise) const;
    [[nodiscard]] bool boolean_or(const char* name, bool otherwise) const;
    [[nodiscard]] std::string string_or(const char* name, std::string_view otherwise) const;
    [[nodiscard]] std::size_t whole_or(const char* name, std::size_t otherwise) const;
    [[nodiscard]] Vec3 vec3_or(const char* name, Vec3 otherwise) const;
    /// A number that is moved into a range.
    [[nodiscard]] float share_or(const char* name, float otherwise, float least = 0, float most = 1) const;
    /// An index into something of `count` elements, which `what` names ("accessors").
    [[nodiscard]] std::optional<std::size_t> index_or_none(const char* name, std::size_t count, const char* what) const;
    [[nodiscard]] std::size_t required_index(const char* name, std::size_t count, const char* what) const;
    [[nodiscard]] std::size_t index(std::size_t count, const char* what) const;
    /// The extension of that name; nothing where there is none.
    [[nodiscard]] Json extension(const char* name) const;

    [[nodiscard]] std::string path() const;
    [[nodiscard]] SourceLocation location() const;
    /// Of all elements of an array, found in one go.
    [[nodiscard]] std::vector<SourceLocation> element_locations() const;
    [[nodiscard]] Diagnostic diagnostic(Severity severity, std::string message, std::string hint = {}) const;
    /// The message begins with the path.
    [[noreturn]] void fail(const std::string& message, std::string hint = {}) const;
    [[nodiscard]] Diagnostic warning(const std::string& message, std::string hint = {}) const;

private:
    friend class JsonDocument;
    Json(const JsonDocument* document, const void* node) : document_(document), node_(node) {}

    const JsonDocument* document_ = nullptr;
    const void* node_ = nullptr;  ///< The JSON library's own type, which is dear to compile.
};

/// A parsed text.
class JsonDocument {
public:
    /// Errors: InputError with line and column for what is no JSON.
    explicit JsonDocument(SourceText source);
    ~JsonDocument();
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    [[nodiscard]] Json root() const;
    [[nodiscard]] const SourceText& source() const { return source_; }

private:
    friend class Json;
    struct Tree;
    SourceText source_;
    std::unique_ptr<Tree> tree_;
};

}  // namespace sundog::import::gltf
