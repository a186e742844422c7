// The grid's sweep of forces/linear_pass.h with the vectors of one instruction set; included once
// for each.
#if defined(WEFT_FORCES_LINEAR_PASS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_LINEAR_PASS_INL_H
#undef WEFT_FORCES_LINEAR_PASS_INL_H
#else
#define WEFT_FORCES_LINEAR_PASS_INL_H
#endif

#include <hwy/highway.h>

#include "forces/linear_pass.h"
#include "math/pack-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// The families as grid_spring_families() orders them.
enum LinearFamily : std::size_t { along_row, along_column, shear, anti, bend_row, bend_column };

// Pointers to the components of one array along one row.
template <typename Real>
struct LinearLine {
    Real *x, *y, *z;
};

template <class D, typename Real>
HWY_INLINE Pack<D> load(D d, const LinearLine<Real>& line, std::size_t i) {
    return load_pack(d, line.x + i, line.y + i, line.z + i);
}

template <class D, typename Real>
HWY_INLINE void store(D d, const Pack<D>& value, const LinearLine<Real>& line, std::size_t i) {
    hn::StoreU(value.x, d, line.x + i);
    hn::StoreU(value.y, d, line.y + i);
    hn::StoreU(value.z, d, line.z + i);
}

// A vector of springs: what they have in common, or each its own.
template <class D>
struct LinearSpringVectors {
    hn::Vec<D> stiffness, scaled_stiffness, scaled_tension, scaled_damping;
};

template <class D, typename Real>
HWY_INLINE LinearSpringVectors<D> set_all(D d, const LinearSpring<Real>& spring) {
    return {hn::Set(d, spring.stiffness), hn::Set(d, spring.scaled_stiffness),
            hn::Set(d, spring.scaled_tension), hn::Set(d, spring.scaled_damping)};
}

// A spring's matrix times du is across du + along dx.
template <class D>
struct LinearParts {
    hn::Vec<D> across, along;
};

// Stiffness: with r = 1 / |dx| and m = min(k, k L r), the part of k that tension does not bear,
// across = k - m and along = m r^2 (dx.du). Damping: along = c r^2 (dx.du).
template <LinearMatrix matrix, class D>
HWY_INLINE LinearParts<D> spring_parts(D d, const LinearSpringVectors<D>& spring, const Pack<D>& dx,
                                       const Pack<D>& du) {
    using T = hn::TFromD<D>;
    const auto root = scaled_inverse_root(d, square(d, dx));
    const auto projected = hn::Mul(hn::Mul(root, root), dot(dx, du));
    if constexpr (matrix == LinearMatrix::stiffness) {
        const auto m = hn::Min(spring.scaled_stiffness, hn::Mul(spring.scaled_tension, root));
        const auto k = hn::Set(d, root_scale<T> * root_scale<T>);
        return {hn::NegMulAdd(k, m, spring.stiffness), hn::Mul(m, projected)};
    } else {
        return {hn::Zero(d), hn::Mul(spring.scaled_damping, projected)};
    }
}

// The spring's matrix times du: what its first end gets, with its sign changed.
template <LinearMatrix matrix, class D>
HWY_INLINE Pack<D> spring_product(const LinearParts<D>& parts, const Pack<D>& dx,
                                  const Pack<D>& du) {
    const Pack<D> along = times(parts.along, dx);
    if constexpr (matrix == LinearMatrix::damping) return along;
    return plus_scaled(along, parts.across, du);
}

// One row's sweep, vector by vector.
template <class D, LinearMatrix matrix>
class LinearRowSweep {
    using T = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using P = Pack<D>;
    using Springs = LinearSpringVectors<D>;

public:
    HWY_INLINE LinearRowSweep(const LinearGridPass<T>& pass, T* lines, std::size_t j)
        : pass_(pass),
          x0_(position(j)),
          x1_(position(below(j, 1))),
          x2_(position(below(j, 2))),
          u0_(line(lines, j)),
          u1_(line(lines, below(j, 1))),
          u2_(line(lines, below(j, 2))),
          sum0_(line(lines, j, 3)),
          sum1_(line(lines, j + 1, 3)),
          sum2_(line(lines, j + 2, 3)),
          masses_(pass.root_inverse_masses + j * pass.stride),
          out_{pass.out[0] + j * pass.stride, pass.out[1] + j * pass.stride,
               pass.out[2] + j * pass.stride},
          row_(pass.row_constants[pass.row_kind(j)]) {}

    // @param writes whether the row is the band's own.
    HWY_INLINE LinearSums sweep(bool writes) {
        const std::size_t lanes = hn::Lanes(D());
        std::size_t i = 0;
        if (pass_.left_edge || lanes + 2 > pass_.columns) {
            vectors<true>(0, 1, writes);
            i = lanes;
        }
        std::size_t count = 0;  // of vectors whose springs end two columns before the border
        if (pass_.columns >= i + lanes + 2) count = (pass_.columns - 2 - i) / lanes;
        vectors<false>(i, count, writes);
        i += count * lanes;
        vectors<true>(i, i < pass_.columns ? (pass_.columns - i + lanes - 1) / lanes : 0, writes);
        const D d;
        return {static_cast<double>(hn::GetLane(hn::SumOfLanes(d, in_out_))),
                static_cast<double>(hn::GetLane(hn::SumOfLanes(d, out_out_)))};
    }

    /// Puts row j of s M^-1/2 u into the ring.
    static HWY_INLINE void scale_row(const LinearGridPass<T>& pass, T* lines, std::size_t j) {
        const D d;
        const std::size_t first = j * pass.stride;
        const T* const masses = pass.root_inverse_masses + first;
        const T* const u[3] = {pass.u[0] + first, pass.u[1] + first, pass.u[2] + first};
        const std::size_t stride = LinearBand<T>::line_stride(pass.stride);
        T* const ring = lines + 3 * (j % 3) * stride;
        const V scale = hn::Set(d, pass.scale);
        for (std::size_t i = 0; i < pass.columns; i += hn::Lanes(d)) {
            const V factor = hn::Mul(scale, hn::LoadU(d, masses + i));
            for (std::size_t c = 0; c < 3; ++c) {
                hn::StoreU(hn::Mul(factor, hn::LoadU(d, u[c] + i)), d, ring + c * stride + i);
            }
        }
    }

private:
    // A row so far below, or the last one, where springs have no stiffness.
    [[nodiscard]] std::size_t below(std::size_t j, std::size_t by) const {
        return j + by < pass_.rows ? j + by : pass_.rows - 1;
    }
    [[nodiscard]] LinearLine<const T> position(std::size_t j) const {
        const std::size_t first = j * pass_.stride;
        return {pass_.x[0] + first, pass_.x[1] + first, pass_.x[2] + first};
    }
    [[nodiscard]] LinearLine<T> line(T* lines, std::size_t j, std::size_t after = 0) const {
        const std::size_t stride = LinearBand<T>::line_stride(pass_.stride);
        T* const first = lines + 3 * (j % 3 + after) * stride;
        return {first, first + stride, first + 2 * stride};
    }

    template <bool edge>
    HWY_INLINE P product(D d, const Springs& springs, std::size_t family, std::size_t i,
                         const P& dx, const P& du) const {
        LinearParts<D> parts = spring_parts<matrix>(d, springs, dx, du);
        if constexpr (edge) {
            const V factor = hn::LoadU(d, pass_.column_factors[family] + i);
            parts = {hn::Mul(factor, parts.across), hn::Mul(factor, parts.along)};
        }
        return spring_product<matrix>(parts, dx, du);
    }

    template <bool edge>
    HWY_INLINE void vectors(std::size_t i, std::size_t count, bool writes) {
        if (count == 0) return;
        const D d;
        const auto& families = edge ? row_.edge : row_.inner;
        const Springs k_row = set_all(d, families[along_row]);
        const Springs k_column = set_all(d, families[along_column]);
        const Springs k_shear = set_all(d, families[shear]);
        const Springs k_bend_row = set_all(d, families[bend_row]);
        const Springs k_bend_column = set_all(d, families[bend_column]);
        for (const std::size_t end = i + count * hn::Lanes(d); i < end; i += hn::Lanes(d)) {
            const P x = load(d, x0_, i), u = load(d, u0_, i);
            const P x_right = load(d, x0_, i + 1), u_right = load(d, u0_, i + 1);
            const P x_below = load(d, x1_, i), u_below = load(d, u1_, i);
            P right = product<edge>(d, k_row, along_row, i, minus(x_right, x), minus(u_right, u));
            P down =
                product<edge>(d, k_column, along_column, i, minus(x_below, x), minus(u_below, u));
            const P diagonal = product<edge>(d, k_shear, shear, i, minus(load(d, x1_, i + 1), x),
                                             minus(load(d, u1_, i + 1), u));
            const P far_right =
                product<edge>(d, k_bend_row, bend_row, i, minus(load(d, x0_, i + 2), x),
                              minus(load(d, u0_, i + 2), u));
            const P far_down = product<edge>(d, k_bend_column, bend_column, i,
                                             minus(load(d, x2_, i), x), minus(load(d, u2_, i), u));
            const P own = plus(plus(plus(right, down), diagonal), plus(far_right, far_down));
            // From (i+1, j) to (i, j+1).
            const P opposite = product<edge>(d, k_shear, anti, i, minus(x_below, x_right),
                                             minus(u_below, u_right));
            right = minus(right, opposite);
            down = plus(down, opposite);

            const P sum = plus(minus(load(d, sum0_, i), own), to_the_right(right, far_right));
            put_below(d, i, down, diagonal, far_down);
            if (writes) finish(d, sum, u, i);
        }
    }

    // What owners to the left, of this vector and the one before, put on their right.
    HWY_INLINE P to_the_right(const P& right, const P& far_right) {
        const D d;
        const P sum = plus(shift_in<1>(d, right, carry1_), shift_in<2>(d, far_right, carry2_));
        carry1_ = right;
        carry2_ = far_right;
        return sum;
    }

    HWY_INLINE void put_below(D d, std::size_t i, const P& down, const P& diagonal,
                              const P& far_down) {
        const P sum = plus(down, shift_in<1>(d, diagonal, carry_below_));
        store(d, plus(load(d, sum1_, i), sum), sum1_, i);
        store(d, far_down, sum2_, i);
        carry_below_ = diagonal;
    }

    HWY_INLINE void finish(D d, const P& sum, const P& u, std::size_t i) {
        P product = sum;
        if constexpr (matrix == LinearMatrix::damping) {
            product = plus_scaled(sum, hn::Set(d, pass_.drag), u);
        }
        in_out_ = hn::Add(in_out_, dot(u, product));
        product = times(hn::LoadU(d, masses_ + i), product);
        out_out_ = hn::Add(out_out_, dot(product, product));
        store(d, product, out_, i);
    }

    const LinearGridPass<T>& pass_;
    const LinearLine<const T> x0_, x1_, x2_;
    const LinearLine<T> u0_, u1_, u2_, sum0_, sum1_, sum2_;
    const T* const masses_;
    const LinearLine<T> out_;
    const LinearRow<T>& row_;
    V in_out_ = hn::Zero(D()), out_out_ = in_out_;
    // What the vector before puts one and two columns to the right, and one right of it below.
    P carry1_ = zero_pack(D()), carry2_ = carry1_, carry_below_ = carry1_;
};

template <class D, LinearMatrix matrix>
HWY_NOINLINE void linear_rows_of(const LinearGridPass<hn::TFromD<D>>& pass,
                                 const LinearBand<hn::TFromD<D>>& band) {
    using T = hn::TFromD<D>;
    using Sweep = LinearRowSweep<D, matrix>;
    const std::size_t first = band.row_begin > 2 ? band.row_begin - 2 : 0;
    const std::size_t ring = LinearBand<T>::ring_lines, sums = LinearBand<T>::sum_lines;
    const std::size_t stride = LinearBand<T>::line_stride(pass.stride);
    for (std::size_t n = ring * stride; n < (ring + sums) * stride; ++n) band.lines[n] = 0;
    for (std::size_t j = first; j < first + 2 && j < pass.rows; ++j) {
        Sweep::scale_row(pass, band.lines, j);
    }
    for (std::size_t j = first; j < band.row_end; ++j) {
        if (j + 2 < pass.rows) Sweep::scale_row(pass, band.lines, j + 2);
        const bool own = j >= band.row_begin;
        const LinearSums sum = Sweep(pass, band.lines, j).sweep(own);
        if (own) pass.sums[j] = sum;
    }
}

/// Runs the pass over a band with full vectors.
template <typename Real>
HWY_INLINE void linear_sweep(const LinearGridPass<Real>& pass, const LinearBand<Real>& band) {
    using D = hn::ScalableTag<Real>;
    if (pass.matrix == LinearMatrix::stiffness) {
        linear_rows_of<D, LinearMatrix::stiffness>(pass, band);
    } else {
        linear_rows_of<D, LinearMatrix::damping>(pass, band);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
