// SPDX-License-Identifier: Apache-2.0
// Values on the heap, for parts of a type that most of its objects do without.
#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace sundog {

/// A T with a value's meaning (copying copies it) that takes a pointer's place until it is written to: until then it
/// reads as T{}. Reading by several threads at once is fine.
template <class T>
class Boxed {
public:
    Boxed() = default;
    Boxed(std::nullopt_t) {}  // NOLINT(google-explicit-constructor): as std::optional.
    Boxed(T value) : value_(std::make_unique<T>(std::move(value))) {}  // NOLINT(google-explicit-constructor): a T.
    Boxed(const Boxed& other) : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}
    Boxed(Boxed&&) noexcept = default;
    Boxed& operator=(const Boxed& other) {
        value_ = other.value_ ? std::make_unique<T>(*other.value_) : nullptr;
        return *this;
    }
    Boxed& operator=(Boxed&&) noexcept = default;
    ~Boxed() = default;

    /// True once it was given a value or written to.
    [[nodiscard]] bool has_value() const { return value_ != nullptr; }
    explicit operator bool() const { return has_value(); }
    void reset() { value_.reset(); }
    T& emplace() { return *(value_ = std::make_unique<T>()); }

    const T& operator*() const { return value_ ? *value_ : untouched(); }
    const T* operator->() const { return &**this; }
    T& operator*() {
        if (!value_) value_ = std::make_unique<T>();
        return *value_;
    }
    T* operator->() { return &**this; }

private:
    static const T& untouched() {
        static const T value{};
        return value;
    }

    std::unique_ptr<T> value_;
};

}  // namespace sundog
