// The mesh's products of forces/linear_pass.h with the vectors of one instruction set; included
// once for each.
#if defined(WEFT_FORCES_LINEAR_MESH_PASS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_LINEAR_MESH_PASS_INL_H
#undef WEFT_FORCES_LINEAR_MESH_PASS_INL_H
#else
#define WEFT_FORCES_LINEAR_MESH_PASS_INL_H
#endif

#include <hwy/highway.h>

#include "forces/linear_pass-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// Blocks of 16 bytes, block b of the result from records + offsets[b * per_block]. The processor's
// gather instructions take longer.
template <class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const hn::TFromD<D>* records, const std::uint32_t* offsets) {
    using T = hn::TFromD<D>;
#if HWY_TARGET == HWY_SSE4
    return hn::Load(d, records + offsets[0]);
#else
    constexpr std::size_t per_block = 16 / sizeof(T);
    const auto pair = [&](std::size_t b) HWY_ATTR {
        const T *const lower = records + offsets[b * per_block], *const upper =
                                                                     records +
                                                                     offsets[(b + 1) * per_block];
        if constexpr (sizeof(T) == 4) {
            return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(lower)),
                                        _mm_load_ps(upper), 1);
        } else {
            return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(lower)),
                                        _mm_load_pd(upper), 1);
        }
    };
    (void)d;
#if HWY_TARGET == HWY_AVX2
    return hn::Vec<D>{pair(0)};
#else
    if constexpr (sizeof(T) == 4) {
        return hn::Vec<D>{_mm512_insertf32x8(_mm512_castps256_ps512(pair(0)), pair(2), 1)};
    } else {
        return hn::Vec<D>{_mm512_insertf64x4(_mm512_castpd256_pd512(pair(0)), pair(2), 1)};
    }
#endif
#endif
}

// Records {x, y, z, 0}, lane l's from records + offsets[l].
template <class D>
HWY_INLINE Pack<D> load_records(D d, const hn::TFromD<D>* records, const std::uint32_t* offsets) {
    using T = hn::TFromD<D>;
    if constexpr (sizeof(T) == 4) {
        const hn::Repartition<double, D> pairs;
        const auto r0 = load_blocks(d, records, offsets), r1 = load_blocks(d, records, offsets + 1),
                   r2 = load_blocks(d, records, offsets + 2),
                   r3 = load_blocks(d, records, offsets + 3);
        const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, r0, r1));
        const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(d, r2, r3));
        const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(d, r0, r1));
        const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(d, r2, r3));
        return {hn::BitCast(d, hn::InterleaveLower(pairs, xy01, xy23)),
                hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, xy23)),
                hn::BitCast(d, hn::InterleaveLower(pairs, z01, z23))};
    } else {
        const auto xy0 = load_blocks(d, records, offsets),
                   xy1 = load_blocks(d, records, offsets + 1),
                   z0 = load_blocks(d, records + 2, offsets),
                   z1 = load_blocks(d, records + 2, offsets + 1);
        return {hn::InterleaveLower(d, xy0, xy1), hn::InterleaveUpper(d, xy0, xy1),
                hn::InterleaveLower(d, z0, z1)};
    }
}

// One slice's product.
template <class D, LinearMatrix matrix>
class LinearSlice {
    using T = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using P = Pack<D>;

public:
    HWY_INLINE LinearSlice(const LinearMeshPass<T>& pass, std::size_t slice)
        : pass_(pass),
          slice_(slice),
          slot_(slice * hn::Lanes(D())),
          masses_(hn::Load(D(), pass.root_inverse_masses + slot_)),
          x_(load(pass.x)),
          u_(times(hn::Mul(hn::Set(D(), pass.scale), masses_), load(pass.u))) {}

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
            sum_ = plus_scaled(sum_, hn::Set(d, pass_.drag), u_);
        }
        in_out = hn::Add(in_out, dot(u_, sum_));
        sum_ = times(masses_, sum_);
        out_out = hn::Add(out_out, dot(sum_, sum_));
        hn::StoreU(sum_.x, d, pass_.out[0] + slot_);
        hn::StoreU(sum_.y, d, pass_.out[1] + slot_);
        hn::StoreU(sum_.z, d, pass_.out[2] + slot_);
    }

private:
    HWY_INLINE P load(const std::array<const T*, 3>& from) const {
        return load_pack(D(), from[0] + slot_, from[1] + slot_, from[2] + slot_);
    }

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
            const std::uint32_t* const offsets = pass_.neighbours + n;
            const P dx = minus(load_records(d, pass_.x_records, offsets), x_);
            const P du = minus(load_records(d, pass_.u_records, offsets), u_);
            const LinearParts<D> parts = spring_parts<matrix>(d, spring, dx, du);
            sum = minus(sum, spring_product<matrix>(parts, dx, du));
        }
        sum_ = sum;
    }

    const LinearMeshPass<T>& pass_;
    const std::size_t slice_, slot_;
    const V masses_;
    const P x_, u_;  // u: scaled as in the rows
    P sum_ = zero_pack(D());
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

/// The records of slices [begin, end).
template <typename Real>
HWY_INLINE void write_records(const LinearRecords<Real>& from, std::size_t begin, std::size_t end) {
    const hn::ScalableTag<Real> d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t s = begin * lanes; s < end * lanes; s += lanes) {
        auto scale = hn::Set(d, from.factor);
        if (from.scales != nullptr) scale = hn::Mul(scale, hn::Load(d, from.scales + s));
        const auto u = times(scale, load_pack(d, from.u[0] + s, from.u[1] + s, from.u[2] + s));
        hn::StoreInterleaved4(u.x, u.y, u.z, hn::Zero(d), d, from.records + 4 * s);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
