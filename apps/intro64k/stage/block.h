// SPDX-License-Identifier: Apache-2.0
// Memory without the C++ library.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <type_traits>

namespace sundog::intro {

/// `count` zeroed elements of a trivial type, freed when it goes. Ends the program where there is no memory, as a film
/// of 20 MB can do nothing else.
template <class T>
class Block {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    explicit Block(std::size_t count) : first_(static_cast<T*>(std::calloc(count, sizeof(T)))) {
        if (first_ == nullptr) std::abort();
    }
    ~Block() { std::free(first_); }  // NOLINT(cppcoreguidelines-owning-memory): this is the owner
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    [[nodiscard]] T* get() const { return first_; }
    T& operator[](std::size_t i) const { return first_[i]; }
    T* operator->() const { return first_; }
    T& operator*() const { return *first_; }

private:
    T* first_;
};

}  // namespace sundog::intro
