// Arrays that begin on a cache line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

namespace weft {

/// [size] numbers, zero at first, aligned to cache lines.
template <typename T>
class LineAligned {
public:
    LineAligned() = default;
    explicit LineAligned(std::size_t size)
        : size_(size), data_(static_cast<T*>(::operator new[](size * sizeof(T), alignment))) {
        std::fill_n(data_.get(), size, T{0});
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] T* data() { return data_.get(); }
    [[nodiscard]] const T* data() const { return data_.get(); }
    T& operator[](std::size_t i) { return data_[i]; }

private:
    static constexpr std::align_val_t alignment{64};
    struct Free {
        void operator()(T* data) const { ::operator delete[](data, alignment); }
    };

    std::size_t size_ = 0;
    std::unique_ptr<T[], Free> data_;
};

}  // namespace weft
