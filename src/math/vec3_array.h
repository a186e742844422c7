// Arrays of vectors, structure-of-arrays: all x, then all y, then all z, each aligned to a cache
// line so that loops over one component vectorise, with room behind each to read beyond its end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

#include "weft/vec3.h"

namespace weft {

/// Pointers to the three components of [size] vectors that somebody else owns.
template <typename Real>
struct Vec3View {
    Real *x = nullptr, *y = nullptr, *z = nullptr;
    std::size_t size = 0;

    Vec3<std::remove_const_t<Real>> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, Vec3<Real> value) const {
        x[i] = value.x;
        y[i] = value.y;
        z[i] = value.z;
    }
    void add(std::size_t i, Vec3<Real> value) const {
        x[i] += value.x;
        y[i] += value.y;
        z[i] += value.z;
    }
    operator Vec3View<const Real>() const { return {x, y, z, size}; }  // NOLINT: as T* to const T*
};

template <typename Real>
using ConstVec3View = Vec3View<const Real>;

/// [size] vectors, zero at first; the padding behind each component stays zero.
template <typename Real>
class Vec3Array {
public:
    Vec3Array() = default;
    explicit Vec3Array(std::size_t size)
        : size_(size), stride_(stride_of(size)), data_(allocate(3 * stride_)) {
        fill_zero();
    }
    Vec3Array(const Vec3Array& other) : Vec3Array(other.size_) { copy_from(other); }
    Vec3Array(Vec3Array&&) noexcept = default;
    Vec3Array& operator=(Vec3Array&&) noexcept = default;
    Vec3Array& operator=(const Vec3Array& other) {
        if (size_ == other.size_) {
            copy_from(other);
        } else {
            *this = Vec3Array(other);
        }
        return *this;
    }
    ~Vec3Array() = default;

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Vec3View<Real> view() {
        return {data_.get(), data_.get() + stride_, data_.get() + 2 * stride_, size_};
    }
    [[nodiscard]] ConstVec3View<Real> view() const {
        return {data_.get(), data_.get() + stride_, data_.get() + 2 * stride_, size_};
    }
    Vec3<Real> operator[](std::size_t i) const { return view()[i]; }
    void set(std::size_t i, Vec3<Real> value) { view().set(i, value); }
    void fill_zero() { std::fill_n(data_.get(), 3 * stride_, Real{0}); }

    /// The three components as one range, padding included: for updates that treat all alike.
    [[nodiscard]] Real* data() { return data_.get(); }
    [[nodiscard]] const Real* data() const { return data_.get(); }
    [[nodiscard]] std::size_t data_size() const { return 3 * stride_; }

private:
    static constexpr std::size_t alignment = 64;  // a cache line [bytes]
    static constexpr std::size_t page = 4096;     // [bytes]
    static constexpr std::size_t lanes = alignment / sizeof(Real);
    struct Free {
        void operator()(Real* data) const {
            ::operator delete[](data, std::align_val_t{alignment});
        }
    };
    using Data = std::unique_ptr<Real[], Free>;

    // Places of one component: at least one cache line behind the last, into which kernels may
    // read, and five lines more than whole pages. With whole pages the three components of a vector
    // would share one set of the first-level cache; with one line more, what is stored to one seems
    // to be what the next vector loads of the other (a tenth of the step at 1000 x 1000).
    static constexpr std::size_t stride_of(std::size_t size) {
        if (size == 0) return 0;
        constexpr std::size_t in_page = page / sizeof(Real);
        return (size + lanes + in_page - 1) / in_page * in_page + 5 * lanes;
    }

    static Data allocate(std::size_t count) {
        return Data(static_cast<Real*>(
            ::operator new[](count * sizeof(Real), std::align_val_t{alignment})));
    }
    void copy_from(const Vec3Array& other) {
        if (size_ > 0) std::copy_n(other.data_.get(), 3 * stride_, data_.get());
    }

    std::size_t size_ = 0, stride_ = 0;
    Data data_;
};

}  // namespace weft
