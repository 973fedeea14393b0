// SPDX-License-Identifier: Apache-2.0
// A vector whose first N elements need no heap: a ray's crossings are few, and there are very many rays.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace sundog::solids {

/// Grows and shrinks at its end only. T is trivially copyable.
template <class T, std::size_t N>
class SmallVector {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    SmallVector() = default;
    SmallVector(const SmallVector&) = delete;
    SmallVector& operator=(const SmallVector&) = delete;
    ~SmallVector() = default;

    void push_back(const T& value) {
        if (size_ < N) {
            ::new (static_cast<void*>(storage_ + size_ * sizeof(T))) T(value);
            ++size_;
            return;
        }
        if (size_ == N) heap_.assign(inline_data(), inline_data() + N);
        heap_.push_back(value);
        ++size_;
    }
    void pop_back() {
        --size_;
        if (size_ > N) heap_.pop_back();
        else if (size_ == N) heap_.clear();  // what lies inline has stayed as it was
    }
    void clear() {
        size_ = 0;
        heap_.clear();
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] T* begin() { return data(); }
    [[nodiscard]] T* end() { return data() + size_; }
    [[nodiscard]] const T* begin() const { return data(); }
    [[nodiscard]] const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T& back() { return data()[size_ - 1]; }
    [[nodiscard]] const T& back() const { return data()[size_ - 1]; }

private:
    T* inline_data() { return std::launder(reinterpret_cast<T*>(storage_)); }
    [[nodiscard]] const T* inline_data() const { return std::launder(reinterpret_cast<const T*>(storage_)); }
    T* data() { return size_ > N ? heap_.data() : inline_data(); }
    [[nodiscard]] const T* data() const { return size_ > N ? heap_.data() : inline_data(); }

    std::size_t size_ = 0;
    alignas(T) std::byte storage_[N * sizeof(T)];  // not filled before it is used: that would cost more than most uses
    std::vector<T> heap_;
};

}  // namespace sundog::solids
