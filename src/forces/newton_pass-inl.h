// The sweeps of forces/newton_pass.h with the vectors of one instruction set; included once for
// each.
#if defined(WEFT_FORCES_NEWTON_PASS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_NEWTON_PASS_INL_H
#undef WEFT_FORCES_NEWTON_PASS_INL_H
#else
#define WEFT_FORCES_NEWTON_PASS_INL_H
#endif

#include <hwy/highway.h>

#include "forces/grid_rows-inl.h"
#include "forces/newton_pass.h"
#include "math/pack-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// The families as grid_spring_families() orders them.
enum NewtonFamily : std::size_t { along_row, along_column, shear, anti, bend_row, bend_column };

using NewtonTag = hn::ScalableTag<float>;

// The constants of a family in every lane, scaled: k, k / 4, k L / 8, c / (4 tau).
struct NewtonSpringVectors {
    using V = hn::Vec<NewtonTag>;
    V stiffness, scaled_stiffness, scaled_tension, scaled_damping;

    HWY_INLINE NewtonSpringVectors(const NewtonSpring& spring, float inverse_tau) {
        const NewtonTag d;
        constexpr float scale = root_scale<float>, square = scale * scale;
        stiffness = hn::Set(d, spring.stiffness);
        scaled_stiffness = hn::Set(d, spring.stiffness / square);
        scaled_tension = hn::Set(d, spring.stiffness * spring.rest_length / (scale * square));
        scaled_damping = hn::Set(d, spring.damping * inverse_tau / square);
    }
};

// Those of all families along a row; both diagonals are alike.
struct NewtonFamilyVectors {
    NewtonSpringVectors row, column, shear, bend_row, bend_column;

    HWY_INLINE NewtonFamilyVectors(const NewtonRow::Families& families, float inverse_tau)
        : row(families[NewtonFamily::along_row], inverse_tau),
          column(families[NewtonFamily::along_column], inverse_tau),
          shear(families[NewtonFamily::shear], inverse_tau),
          bend_row(families[NewtonFamily::bend_row], inverse_tau),
          bend_column(families[NewtonFamily::bend_column], inverse_tau) {}
};

// A spring's matrix is across I + along dx dx^T.
struct NewtonParts {
    hn::Vec<NewtonTag> across, along;
};

// With r = 1 / |dx| and m = min(k, k L r), the part of k that tension does not bear:
// across = k - m, along = (m + c / tau) r^2.
HWY_INLINE NewtonParts newton_parts(const NewtonSpringVectors& spring, const Pack<NewtonTag>& dx) {
    const NewtonTag d;
    const auto root = scaled_inverse_root(d, square(d, dx));
    const auto m = hn::Min(spring.scaled_stiffness, hn::Mul(spring.scaled_tension, root));
    const auto four = hn::Set(d, root_scale<float> * root_scale<float>);
    return {hn::NegMulAdd(four, m, spring.stiffness),
            hn::Mul(hn::Add(m, spring.scaled_damping), hn::Mul(root, root))};
}

HWY_INLINE Pack<NewtonTag> newton_spring_product(const NewtonParts& parts,
                                                 const Pack<NewtonTag>& dx,
                                                 const Pack<NewtonTag>& du) {
    const auto along = hn::Mul(parts.along, dot(dx, du));
    return plus_scaled(times(along, dx), parts.across, du);
}

// A row's vectors: those whose springs may end at a border, at either end, and those between.
struct NewtonCut {
    std::size_t left, inner, right;  // counts

    HWY_INLINE explicit NewtonCut(const NewtonGrid& grid) {
        const std::size_t lanes = hn::Lanes(NewtonTag());
        left = grid.left_edge || lanes + 2 > grid.columns ? 1 : 0;
        const std::size_t begin = left * lanes;
        inner = grid.columns >= begin + lanes + 2 ? (grid.columns - 2 - begin) / lanes : 0;
        const std::size_t rest = begin + inner * lanes;
        right = rest < grid.columns ? (grid.columns - rest + lanes - 1) / lanes : 0;
    }
};

// A row so far below, or the last one, where springs have no stiffness.
HWY_INLINE std::size_t newton_below(const NewtonGrid& grid, std::size_t j, std::size_t by) {
    return j + by < grid.rows ? j + by : grid.rows - 1;
}

template <typename Real>
HWY_INLINE RowOf<Real> newton_row(const NewtonGrid& grid, const Vec3View<Real>& field,
                                  std::size_t j) {
    return {field.x + j * grid.stride, field.y - field.x};
}

// D^-1 r for the vector that begins at `slot`.
HWY_INLINE Pack<NewtonTag> newton_solve_block(const NewtonGrid& grid, const Pack<NewtonTag>& r,
                                              std::size_t slot) {
    const NewtonTag d;
    const auto factor = [&](std::size_t entry)
                            HWY_ATTR { return hn::LoadU(d, grid.factors[entry] + slot); };
    const auto l10 = factor(3), l20 = factor(4), l21 = factor(5);
    const auto y1 = hn::NegMulAdd(l10, r.x, r.y);
    const auto y2 = hn::NegMulAdd(l21, y1, hn::NegMulAdd(l20, r.x, r.z));
    const auto z2 = hn::Mul(factor(2), y2);
    const auto z1 = hn::NegMulAdd(l21, z2, hn::Mul(factor(1), y1));
    const auto z0 = hn::NegMulAdd(l20, z2, hn::NegMulAdd(l10, z1, hn::Mul(factor(0), r.x)));
    return {z0, z1, z2};
}

// What a sweep makes of A u.
enum class NewtonUpdate { product, residual, smooth };

// Its operands; b and omega where the update has them.
struct NewtonOperands {
    ConstVec3View<float> u, b;
    Vec3View<float> out;
    float omega = 0;
};

// One row's sweep, vector by vector.
template <NewtonUpdate update, bool isotropic>
class NewtonRowSweep {
    using D = NewtonTag;
    using V = hn::Vec<D>;
    using P = Pack<D>;

public:
    HWY_INLINE NewtonRowSweep(const NewtonGrid& grid, const NewtonOperands& operands, float* lines,
                              std::size_t j, bool writes)
        : grid_(grid),
          writes_(writes),
          first_(j * grid.stride),
          x0_(newton_row(grid, grid.x, j)),
          x1_(newton_row(grid, grid.x, newton_below(grid, j, 1))),
          x2_(newton_row(grid, grid.x, newton_below(grid, j, 2))),
          u0_(newton_row(grid, operands.u, j)),
          u1_(newton_row(grid, operands.u, newton_below(grid, j, 1))),
          u2_(newton_row(grid, operands.u, newton_below(grid, j, 2))),
          b_(newton_row(grid, operands.b, j)),
          out_(newton_row(grid, operands.out, j)),
          sum0_(line(lines, j)),
          sum1_(line(lines, j + 1)),
          sum2_(line(lines, j + 2)),
          row_(grid.row_constants[grid.row_kind(j)]),
          omega_(hn::Set(D(), operands.omega)) {}

    HWY_INLINE double sweep() {
        const NewtonCut cut(grid_);
        const std::size_t lanes = hn::Lanes(D());
        if (cut.left > 0) vectors<true>(0, cut.left);
        vectors<false>(cut.left * lanes, cut.inner);
        if (cut.right > 0) vectors<true>((cut.left + cut.inner) * lanes, cut.right);
        return static_cast<double>(hn::GetLane(hn::SumOfLanes(D(), sum_)));
    }

private:
    [[nodiscard]] RowOf<float> line(float* lines, std::size_t j) const {
        const std::size_t stride = NewtonBand::line_stride(grid_.stride);
        return {lines + 3 * (j % 3) * stride, static_cast<std::ptrdiff_t>(stride)};
    }

    template <bool edge>
    HWY_INLINE P product(const NewtonSpringVectors& springs, std::size_t family, std::size_t i,
                         const P& dx, const P& du) const {
        NewtonParts parts = newton_parts(springs, dx);
        if constexpr (edge) {
            const V factor = hn::LoadU(D(), grid_.column_factors[family] + i);
            parts = {hn::Mul(factor, parts.across), hn::Mul(factor, parts.along)};
        }
        return newton_spring_product(parts, dx, du);
    }

    template <bool edge>
    HWY_INLINE void vectors(std::size_t i, std::size_t count) {
        const D d;
        const NewtonFamilyVectors k(edge ? row_.edge : row_.inner, grid_.inverse_tau);
        P carry1 = carry1_, carry2 = carry2_, carry_below = carry_below_;
        for (const std::size_t end = i + count * hn::Lanes(d); i < end; i += hn::Lanes(d)) {
            const P x = load(d, x0_, i), u = load(d, u0_, i);
            const P x_right = load_ahead<1>(d, x, x0_, i), u_right = load_ahead<1>(d, u, u0_, i);
            const P x_below = load(d, x1_, i), u_below = load(d, u1_, i);
            P right = product<edge>(k.row, along_row, i, minus(x_right, x), minus(u_right, u));
            P down = product<edge>(k.column, along_column, i, minus(x_below, x), minus(u_below, u));
            const P diagonal =
                product<edge>(k.shear, shear, i, minus(load_ahead<1>(d, x_below, x1_, i), x),
                              minus(load_ahead<1>(d, u_below, u1_, i), u));
            const P far_right =
                product<edge>(k.bend_row, bend_row, i, minus(load_ahead<2>(d, x, x0_, i), x),
                              minus(load_ahead<2>(d, u, u0_, i), u));
            const P far_down = product<edge>(k.bend_column, bend_column, i,
                                             minus(load(d, x2_, i), x), minus(load(d, u2_, i), u));
            const P own = plus(plus(plus(right, down), diagonal), plus(far_right, far_down));
            // From (i+1, j) to (i, j+1).
            const P opposite =
                product<edge>(k.shear, anti, i, minus(x_below, x_right), minus(u_below, u_right));
            right = minus(right, opposite);
            down = plus(down, opposite);
            // What owners to the left and above put here; what this vector puts below.
            P sum = minus(load(d, sum0_, i), own);
            sum = plus(sum, plus(shift_in<1>(d, right, carry1), shift_in<2>(d, far_right, carry2)));
            const P next =
                plus(load(d, sum1_, i), plus(down, shift_in<1>(d, diagonal, carry_below)));
            store(d, next, sum1_, i);
            store(d, far_down, sum2_, i);
            carry1 = right;
            carry2 = far_right;
            carry_below = diagonal;
            if (writes_) finish(sum, u, i);
        }
        carry1_ = carry1;
        carry2_ = carry2;
        carry_below_ = carry_below;
    }

    [[nodiscard]] HWY_INLINE V block(std::size_t entry, std::size_t i) const {
        return hn::LoadU(D(), grid_.blocks[entry] + first_ + i);
    }
    // @param springs their part of A u.
    HWY_INLINE void finish(const P& springs, const P& u, std::size_t i) {
        const D d;
        const V xx = block(0, i);
        P product = plus_scaled(springs, xx, u);
        if constexpr (!isotropic) {
            const V xy = block(1, i), xz = block(2, i), yy = block(3, i), yz = block(4, i),
                    zz = block(5, i);
            product.x = hn::MulAdd(xx, u.x, hn::MulAdd(xy, u.y, hn::MulAdd(xz, u.z, springs.x)));
            product.y = hn::MulAdd(xy, u.x, hn::MulAdd(yy, u.y, hn::MulAdd(yz, u.z, springs.y)));
            product.z = hn::MulAdd(xz, u.x, hn::MulAdd(yz, u.y, hn::MulAdd(zz, u.z, springs.z)));
        }
        if constexpr (update == NewtonUpdate::product) {
            product = where_free(xx, product);
            sum_ = hn::Add(sum_, dot(u, product));
            store(d, product, out_, i);
        } else {
            const P b = load(d, b_, i);
            const P residual = minus(b, product);
            if constexpr (update == NewtonUpdate::residual) {
                store(d, where_free(xx, residual), out_, i);
            } else {
                const P z = plus_scaled(u, omega_, newton_solve_block(grid_, residual, first_ + i));
                sum_ = hn::Add(sum_, dot(b, z));
                store(d, z, out_, i);
            }
        }
    }

    [[nodiscard]] static HWY_INLINE P where_free(V xx, const P& a) {
        const auto free = hn::Gt(xx, hn::Zero(D()));
        return {hn::IfThenElseZero(free, a.x), hn::IfThenElseZero(free, a.y),
                hn::IfThenElseZero(free, a.z)};
    }

    const NewtonGrid& grid_;
    const bool writes_;
    const std::size_t first_;
    const RowOf<const float> x0_, x1_, x2_, u0_, u1_, u2_, b_;
    const RowOf<float> out_, sum0_, sum1_, sum2_;
    const NewtonRow& row_;
    const V omega_;
    V sum_ = hn::Zero(D());
    // What the vector before puts one and two columns to the right, and one right of it below.
    P carry1_ = zero_pack(D()), carry2_ = carry1_, carry_below_ = carry1_;
};

template <NewtonUpdate update, bool isotropic>
HWY_NOINLINE void newton_rows(const NewtonGrid& grid, const NewtonBand& band,
                              const NewtonOperands& operands, double* sums) {
    const std::size_t first = band.row_begin > 2 ? band.row_begin - 2 : 0;
    const std::size_t stride = NewtonBand::line_stride(grid.stride);
    for (std::size_t n = 0; n < 9 * stride; ++n) band.lines[n] = 0;
    for (std::size_t j = first; j < band.row_end; ++j) {
        const bool own = j >= band.row_begin;
        NewtonRowSweep<update, isotropic> row(grid, operands, band.lines, j, own);
        const double sum = row.sweep();
        if (own && update != NewtonUpdate::residual) sums[j] = sum;
    }
}

template <NewtonUpdate update>
HWY_INLINE void newton_sweep(const NewtonGrid& grid, const NewtonBand& band,
                             const NewtonOperands& operands, double* sums) {
    if (grid.isotropic) {
        newton_rows<update, true>(grid, band, operands, sums);
    } else {
        newton_rows<update, false>(grid, band, operands, sums);
    }
}

// out = omega D^-1 b
HWY_INLINE void newton_start(const NewtonGrid& grid, const NewtonBand& band, float omega,
                             const ConstVec3View<float>& b, const Vec3View<float>& out) {
    const NewtonTag d;
    const auto factor = hn::Set(d, omega);
    for (std::size_t j = band.row_begin; j < band.row_end; ++j) {
        const RowOf<const float> from = newton_row(grid, b, j);
        const RowOf<float> to = newton_row(grid, out, j);
        for (std::size_t i = 0; i < grid.columns; i += hn::Lanes(d)) {
            const auto z = newton_solve_block(grid, load(d, from, i), j * grid.stride + i);
            store(d, times(factor, z), to, i);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
