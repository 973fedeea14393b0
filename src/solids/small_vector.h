// SPDX-License-Identifier: Apache-2.0
// A vector whose first N elements need no heap: a ray's crossings are few, and there are very many rays.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace sundog::solids {

/// Grows at its end only. T is trivially copyable.
template <class T, std::size_t N>
class SmallVector {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    void push_back(const T& value) {
        if (size_ < N) {
            inline_[size_++] = value;
            return;
        }
        if (size_ == N) heap_.assign(inline_.begin(), inline_.end());
        heap_.push_back(value);
        ++size_;
    }
    void pop_back() {
        --size_;
        if (size_ > N) heap_.pop_back();
        else if (size_ == N) back_from_heap();
    }
    void clear() {
        size_ = 0;
        heap_.clear();
    }
    void truncate(std::size_t size) {
        while (size_ > size) pop_back();
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
    T* data() { return size_ > N ? heap_.data() : inline_.data(); }
    [[nodiscard]] const T* data() const { return size_ > N ? heap_.data() : inline_.data(); }
    void back_from_heap() {
        for (std::size_t i = 0; i < N; ++i) inline_[i] = heap_[i];
        heap_.clear();
    }

    std::size_t size_ = 0;
    std::array<T, N> inline_;
    std::vector<T> heap_;
};

}  // namespace sundog::solids
