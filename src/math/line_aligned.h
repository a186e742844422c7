// Arrays that begin on a cache line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

#include "math/large_pages.h"

namespace weft {

/// [size] numbers, zero at first, aligned to cache lines; large ones to large pages, and on these
/// where the system has some.
template <typename T>
class LineAligned {
public:
    LineAligned() = default;
    explicit LineAligned(std::size_t size) : size_(size), data_(allocate(size * sizeof(T))) {
        std::fill_n(data_.get(), size, T{0});
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] T* data() { return data_.get(); }
    [[nodiscard]] const T* data() const { return data_.get(); }
    T& operator[](std::size_t i) { return data_[i]; }

private:
    struct Free {
        std::align_val_t alignment{};
        void operator()(T* data) const { ::operator delete[](data, alignment); }
    };
    using Data = std::unique_ptr<T[], Free>;

    static Data allocate(std::size_t bytes) {
        const bool large = bytes >= 2 * large_page;
        const std::align_val_t alignment{large ? large_page : std::size_t{64}};
        Data data(static_cast<T*>(::operator new[](bytes, alignment)), Free{alignment});
        if (large) use_large_pages(data.get(), bytes);
        return data;
    }

    std::size_t size_ = 0;
    Data data_;
};

}  // namespace weft
