// The mesh's products of forces/linear_pass.h with the vectors of one instruction set; included once
// for each.
#if defined(WEFT_FORCES_LINEAR_MESH_PASS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_LINEAR_MESH_PASS_INL_H
#undef WEFT_FORCES_LINEAR_MESH_PASS_INL_H
#else
#define WEFT_FORCES_LINEAR_MESH_PASS_INL_H
#endif

#include <hwy/highway.h>

#include "forces/linear_pass-inl.h"
#include "forces/mesh_pass_rows-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// One slice's product.
template <class D, LinearMatrix matrix>
class LinearSlice {
    using T = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using P = Pack<D>;

public:
    HWY_INLINE LinearSlice(const LinearMeshPass<T>& pass, std::size_t slice)
        : pass_(pass), slice_(slice) {
        const D d;
        const T* const row = pass.rows + LinearMeshPass<T>::row_size * slice * hn::Lanes(d);
        std::uint32_t own[64 / sizeof(T)];
        for (std::uint32_t lane = 0; lane < hn::Lanes(d); ++lane) own[lane] = lane;
        at_ = gather_moving(d, row, own);
    }

    // Writes the slice's part of out; adds to the sums.
    HWY_INLINE void multiply(V& in_out, V& out_out) {
        const D d;
        for (std::size_t kind = 0; kind < 3; ++kind) {
            const std::uint32_t* const starts = pass_.spring_starts + 3 * slice_ + kind;
            if (pass_.widths == nullptr) {
                add_springs<false>(pass_.kinds[kind], starts[0], starts[1]);
            } else {
                add_springs<true>(pass_.kinds[kind], starts[0], starts[1]);
            }
        }
        if constexpr (matrix == LinearMatrix::damping) {
            sum_ = plus_scaled(sum_, hn::Set(d, pass_.drag), at_.v);
        }
        const std::size_t s = slice_ * hn::Lanes(d);
        in_out = hn::Add(in_out, dot(at_.v, sum_));
        sum_ = times(hn::Load(d, pass_.root_inverse_masses + s), sum_);
        out_out = hn::Add(out_out, dot(sum_, sum_));
        hn::StoreU(sum_.x, d, pass_.out[0] + s);
        hn::StoreU(sum_.y, d, pass_.out[1] + s);
        hn::StoreU(sum_.z, d, pass_.out[2] + s);
    }

private:
    // Those in vectors [begin, end).
    template <bool weighted>
    HWY_INLINE void add_springs(const LinearKind<T>& kind, std::size_t begin, std::size_t end) {
        const D d;
        const std::size_t lanes = hn::Lanes(d);
        const V inverse_square = hn::Set(d, 1 / (root_scale<T> * root_scale<T>));
        const V one_stiffness = hn::Set(d, kind.stiffness);
        const V one_damping = hn::Set(d, kind.scaled_damping);
        P sum = sum_;
        for (std::size_t n = begin * lanes; n < end * lanes; n += lanes) {
            LinearSpringVectors<D> spring{one_stiffness, one_stiffness, one_stiffness, one_damping};
            if constexpr (weighted) {
                const V width = hn::Load(d, pass_.widths + n);
                spring.stiffness = hn::Mul(width, one_stiffness);
                spring.scaled_damping = hn::Mul(width, one_damping);
            }
            spring.scaled_stiffness = hn::Mul(inverse_square, spring.stiffness);
            spring.scaled_tension = hn::Mul(inverse_square, hn::Load(d, pass_.tensions + n));
            const Moving<D> other = gather_moving(d, pass_.rows, pass_.neighbours + n);
            const P dx = minus(other.x, at_.x), du = minus(other.v, at_.v);
            const LinearParts<D> parts = spring_parts<matrix>(d, spring, dx, du);
            sum = minus(sum, spring_product<matrix>(parts, dx, du));
        }
        sum_ = sum;
    }

    const LinearMeshPass<T>& pass_;
    const std::size_t slice_;
    const V zero_ = hn::Zero(D());
    Moving<D> at_;  // the slots' own x, and M^-1/2 u in place of a velocity
    P sum_{zero_, zero_, zero_};
};

template <class D, LinearMatrix matrix>
HWY_NOINLINE LinearSums linear_slices_of(const LinearMeshPass<hn::TFromD<D>>& pass,
                                         std::size_t begin, std::size_t end) {
    const D d;
    auto in_out = hn::Zero(d), out_out = hn::Zero(d);
    for (std::size_t slice = begin; slice < end; ++slice) {
        LinearSlice<D, matrix>(pass, slice).multiply(in_out, out_out);
    }
    return {static_cast<double>(hn::GetLane(hn::SumOfLanes(d, in_out))),
            static_cast<double>(hn::GetLane(hn::SumOfLanes(d, out_out)))};
}

/// The product on slices [begin, end).
template <typename Real>
HWY_INLINE LinearSums linear_slices(const LinearMeshPass<Real>& pass, std::size_t begin,
                                    std::size_t end) {
    using D = hn::ScalableTag<Real>;
    return pass.matrix == LinearMatrix::stiffness
               ? linear_slices_of<D, LinearMatrix::stiffness>(pass, begin, end)
               : linear_slices_of<D, LinearMatrix::damping>(pass, begin, end);
}

/// The rows of slices [begin, end).
template <typename Real>
HWY_INLINE void write_rows(const LinearRows<Real>& from, std::size_t begin, std::size_t end) {
    const hn::ScalableTag<Real> d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t s = begin * lanes; s < end * lanes; s += lanes) {
        auto scale = hn::Set(d, from.factor);
        if (from.scales != nullptr) scale = hn::Mul(scale, hn::Load(d, from.scales + s));
        const auto u = times(scale, load_pack(d, from.u[0] + s, from.u[1] + s, from.u[2] + s));
        constexpr int size = LinearMeshPass<Real>::row_size;
        store_rows<size>(d, u, from.rows + size * s);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
