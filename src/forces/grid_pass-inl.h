// The sweep of forces/grid_pass.h with the vectors of one instruction set; included once for each.
#if defined(WEFT_FORCES_GRID_PASS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_GRID_PASS_INL_H
#undef WEFT_FORCES_GRID_PASS_INL_H
#else
#define WEFT_FORCES_GRID_PASS_INL_H
#endif

#include <hwy/highway.h>

#include "forces/grid_pass.h"
#include "forces/grid_rows-inl.h"
#include "forces/plate_force-inl.h"
#include "math/pack-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// The families as grid_spring_families() orders them.
enum Family : std::size_t { along_row, along_column, shear, anti, bend_row, bend_column };

// Constants of a family in every lane.
template <class D>
struct FamilyVectors {
    hn::Vec<D> stiffness, tension, damping;

    template <typename Real>
    FamilyVectors(D d, const GridFamilyConstants<Real>& c)
        : stiffness(hn::Set(d, c.stiffness)),
          tension(hn::Set(d, c.tension)),
          damping(hn::Set(d, c.damping)) {}
};

// k - k L / |d| + c (dv.d) / |d|^2: times d, a spring's force.
template <bool damped, class D>
HWY_INLINE hn::Vec<D> strength(D d, const FamilyVectors<D>& family, const Pack<D>& dx,
                               const Pack<D>& dv) {
    const auto root = scaled_inverse_root(d, square(d, dx));
    // As k + q (c (dv.d) q - k L) with q = 1 / |d|.
    if constexpr (damped) {
        const auto pull = hn::MulSub(hn::Mul(family.damping, dot(dx, dv)), root, family.tension);
        return hn::MulAdd(pull, root, family.stiffness);
    } else {
        return hn::NegMulAdd(family.tension, root, family.stiffness);
    }
}

// One row's sweep, vector by vector.
// @tparam in_place all three rows stand in the state's own arrays, their components equally far
// apart: fewer addresses to keep, a tenth less time.
template <class D, bool damped, bool air, GridUpdate update, bool in_place>
class RowSweep {
    using T = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using P = Pack<D>;
    using Rows = BandRows<T>;

public:
    // @param lines of this row and the two below, by their line buffers.
    HWY_INLINE RowSweep(const GridPass<T>& pass, const Rows& rows, T* lines, std::size_t j,
                        bool moves)
        : pass_(pass),
          moves_(moves),
          x0_(rows.row(Rows::position, j)),
          x1_(row_below(rows, 1, j)),
          x2_(row_below(rows, 2, j)),
          v0_{rows.row(Rows::velocity, j).x, x0_.step},
          v1_{rows.row(Rows::velocity, below(j, 1)).x, x1_.step},
          v2_{rows.row(Rows::velocity, below(j, 2)).x, x2_.step},
          a_(rows.row(Rows::acceleration, j)),
          masses_(pass.inverse_masses + j * pass.stride),
          line0_(line(lines, j)),
          line1_(line(lines, j + 1)),
          line2_(line(lines, j + 2)),
          row_(pass.row_constants[pass.row_kind(j)]),
          air_(row_.has_triangles ? pass.air_constants : AirConstants<T>{}) {}

    HWY_INLINE void sweep() {
        const std::size_t lanes = hn::Lanes(D());
        std::size_t i = 0;
        if (pass_.left_edge || lanes + 2 > pass_.columns) {
            vectors<true>(0, 1);
            i = lanes;
        }
        // Inner vectors: their springs end two columns before the border.
        std::size_t count = 0;
        if (pass_.columns >= i + lanes + 2) count = (pass_.columns - 2 - i) / lanes;
        vectors<false>(i, count);
        i += count * lanes;
        vectors<true>(i, i < pass_.columns ? (pass_.columns - i + lanes - 1) / lanes : 0);
    }

private:
    // A row so far below, or the last one, where springs have no stiffness.
    [[nodiscard]] std::size_t below(std::size_t j, std::size_t by) const {
        return j + by < pass_.rows ? j + by : pass_.rows - 1;
    }
    [[nodiscard]] RowOf<T> row_below(const Rows& rows, std::size_t by, std::size_t j) const {
        const RowOf<T> row = rows.row(Rows::position, below(j, by));
        return {row.x, in_place ? x0_.step : row.step};
    }
    [[nodiscard]] RowOf<T> line(T* lines, std::size_t j) const {
        return {lines + 3 * (j % 3) * pass_.stride, static_cast<std::ptrdiff_t>(pass_.stride)};
    }

    template <bool edge>
    HWY_INLINE void vectors(std::size_t i, std::size_t count) {
        if (count == 0) return;
        const D d;
        const auto& families = edge ? row_.edge : row_.inner;
        const FamilyVectors<D> k_row(d, families[along_row]);
        const FamilyVectors<D> k_column(d, families[along_column]);
        const FamilyVectors<D> k_shear(d, families[shear]);
        const FamilyVectors<D> k_bend_row(d, families[bend_row]);
        const FamilyVectors<D> k_bend_column(d, families[bend_column]);
        P carry1 = carry1_, carry2 = carry2_, carry_below = carry_below_;
        for (const std::size_t end = i + count * hn::Lanes(d); i < end; i += hn::Lanes(d)) {
            const auto factor = [&](Family family, V strength) HWY_ATTR {
                if constexpr (edge) {
                    return hn::Mul(strength, hn::LoadU(d, pass_.column_factors[family] + i));
                } else {
                    (void)family;
                    return strength;
                }
            };
            const P x = load(d, x0_, i), v = load(d, v0_, i);
            const P x_right = load_ahead<1>(d, x, x0_, i), v_right = load_ahead<1>(d, v, v0_, i);
            const P x_below = load(d, x1_, i), v_below = load(d, v1_, i);

            const P dx_row = minus(x_right, x);
            P right = times(
                factor(along_row, strength<damped>(d, k_row, dx_row, minus(v_right, v))), dx_row);
            P own = right;

            const P dx_column = minus(x_below, x);
            P down = times(
                factor(along_column, strength<damped>(d, k_column, dx_column, minus(v_below, v))),
                dx_column);
            own = plus(own, down);

            const P v_diagonal = load(d, v1_, i + 1);
            const P dx_shear = minus(load(d, x1_, i + 1), x);
            P diagonal =
                times(factor(shear, strength<damped>(d, k_shear, dx_shear, minus(v_diagonal, v))),
                      dx_shear);
            own = plus(own, diagonal);

            if constexpr (air) {
                P lower = plate_third(d, air_, pass_.wind, cross(dx_column, dx_shear),
                                      plus(v, plus(v_below, v_diagonal)));
                P upper = plate_third(d, air_, pass_.wind, cross(dx_shear, dx_row),
                                      plus(v, plus(v_diagonal, v_right)));
                if constexpr (edge) {
                    const V present = hn::LoadU(d, pass_.triangle_factors + i);
                    lower = times(present, lower);
                    upper = times(present, upper);
                }
                const P both = plus(lower, upper);
                own = plus(own, both);
                right = minus(right, upper);
                down = minus(down, lower);
                diagonal = minus(diagonal, both);
            }

            // From (i+1, j) to (i, j+1): what owner and other end get is the other way round.
            const P dx_anti = minus(x_below, x_right);
            const V s_anti =
                factor(anti, strength<damped>(d, k_shear, dx_anti, minus(v_below, v_right)));
            down = plus_scaled(down, s_anti, dx_anti);
            right = minus_scaled(right, s_anti, dx_anti);

            const P dx_bend_row = minus(load_ahead<2>(d, x, x0_, i), x);
            const P far_right =
                times(factor(bend_row, strength<damped>(d, k_bend_row, dx_bend_row,
                                                        minus(load_ahead<2>(d, v, v0_, i), v))),
                      dx_bend_row);
            own = plus(own, far_right);

            const P dx_bend_column = minus(load(d, x2_, i), x);
            const P far_down =
                times(factor(bend_column, strength<damped>(d, k_bend_column, dx_bend_column,
                                                           minus(load(d, v2_, i), v))),
                      dx_bend_column);
            own = plus(own, far_down);

            // What owners to the left and above put here; what this vector puts below.
            P force = minus(own, load(d, line0_, i));
            force = minus(force, shift_in<1>(d, right, carry1));
            force = minus(force, shift_in<2>(d, far_right, carry2));
            const P next =
                plus(load(d, line1_, i), plus(down, shift_in<1>(d, diagonal, carry_below)));
            store(d, next, line1_, i);
            store(d, far_down, line2_, i);
            carry1 = right;
            carry2 = far_right;
            carry_below = diagonal;
            if (moves_) apply(d, force, x, v, i);
        }
        carry1_ = carry1;
        carry2_ = carry2;
        carry_below_ = carry_below;
    }

    // @param force all but gravity and drag.
    HWY_INLINE void apply(D d, const P& force, const P& x, const P& v, std::size_t i) {
        const V w = hn::LoadU(d, masses_ + i);
        if constexpr (update == GridUpdate::kick_drift) {
            // v + kick (g + w (force - drag v)), sorted by what is multiplied.
            const V kick = hn::Mul(w, hn::Set(d, pass_.kick));
            const V kept = hn::NegMulAdd(kick, hn::Set(d, pass_.drag), hn::Set(d, T{1}));
            const P falling = plus_scaled(gravity(d, w, pass_.kick), kept, v);
            const P moving = plus_scaled(falling, kick, force);
            store(d, moving, v0_, i);
            store(d, plus_scaled(x, hn::Set(d, pass_.drift), moving), x0_, i);
        } else {
            const P f = minus_scaled(force, hn::Set(d, pass_.drag), v);
            const P a = plus_scaled(gravity(d, w, T{1}), w, f);
            if constexpr (update == GridUpdate::verlet) {
                const P change = minus(a, load(d, a_, i));
                store(d, plus_scaled(v, hn::Set(d, pass_.kick / 2), change), v0_, i);
            }
            store(d, a, a_, i);
        }
    }

    // times * g where particles are free, and nothing where they are pinned or padding.
    HWY_INLINE P gravity(D d, V w, T times) const {
        const auto free = hn::Gt(w, hn::Zero(d));
        return {hn::IfThenElseZero(free, hn::Set(d, times * pass_.gravity.x)),
                hn::IfThenElseZero(free, hn::Set(d, times * pass_.gravity.y)),
                hn::IfThenElseZero(free, hn::Set(d, times * pass_.gravity.z))};
    }

    const GridPass<T>& pass_;
    const bool moves_;
    const RowOf<T> x0_, x1_, x2_, v0_, v1_, v2_, a_;
    const T* const masses_;
    const RowOf<T> line0_, line1_, line2_;
    const GridRowConstants<T>& row_;
    const AirConstants<T> air_;  // zero where the row has no triangles below
    // What the vector before puts one and two columns to the right, and one right of it below.
    const V zero_ = hn::Zero(D());
    P carry1_{zero_, zero_, zero_}, carry2_{zero_, zero_, zero_}, carry_below_{zero_, zero_, zero_};
};

// Velocity Verlet's drift of a row, to where forces are then computed, and its moving pins.
template <class D>
class VerletDrift {
    using T = hn::TFromD<D>;

public:
    VerletDrift(const GridPass<T>& pass, const BandRows<T>& rows, std::size_t first_row)
        : pass_(pass), rows_(rows) {
        while (next_pin_ < pass.pin_count && pass.pins[next_pin_].slot < first_row * pass.stride) {
            ++next_pin_;
        }
    }

    // Rows in rising order.
    HWY_INLINE void row(std::size_t j) {
        const D d;
        const RowOf<T> x = rows_.row(BandRows<T>::position, j);
        const RowOf<T> v = rows_.row(BandRows<T>::velocity, j);
        const RowOf<T> a = rows_.row(BandRows<T>::acceleration, j);
        const auto h = hn::Set(d, pass_.kick), half_h2 = hn::Set(d, pass_.kick * pass_.kick / 2);
        for (std::size_t i = 0; i < pass_.columns; i += hn::Lanes(d)) {
            const Pack<D> velocity = load(d, v, i), acceleration = load(d, a, i);
            const Pack<D> moved = plus_scaled(load(d, x, i), h, velocity);
            store(d, plus_scaled(moved, half_h2, acceleration), x, i);
            store(d, plus_scaled(velocity, h, acceleration), v, i);
        }
        for (; next_pin_ < pass_.pin_count; ++next_pin_) {
            const PinTarget<T>& pin = pass_.pins[next_pin_];
            if (pin.slot >= (j + 1) * pass_.stride) break;
            const std::size_t i = pin.slot - j * pass_.stride;
            put(pin.x, x.x + i, x.step);
            put(pin.v, v.x + i, v.step);
        }
    }

private:
    static void put(const Vec3<T>& value, T* x, std::ptrdiff_t step) {
        x[0] = value.x;
        x[step] = value.y;
        x[2 * step] = value.z;
    }

    const GridPass<T>& pass_;
    const BandRows<T>& rows_;
    std::size_t next_pin_ = 0;
};

template <class D, bool damped, bool air, GridUpdate update>
HWY_NOINLINE void sweep_rows(const GridPass<hn::TFromD<D>>& pass,
                             const GridBand<hn::TFromD<D>>& band) {
    using T = hn::TFromD<D>;
    const BandRows<T> rows(pass, band);
    const std::size_t first = band.row_begin > 2 ? band.row_begin - 2 : 0;
    std::fill_n(band.lines, GridBand<T>::line_count * pass.stride, T{0});
    VerletDrift<D> drift(pass, rows, first);
    if constexpr (update == GridUpdate::verlet) {
        drift.row(first);
        if (first + 1 < pass.rows) drift.row(first + 1);
    }
    for (std::size_t j = first; j < band.row_end; ++j) {
        if constexpr (update == GridUpdate::verlet) {
            if (j + 2 < pass.rows) drift.row(j + 2);
        }
        const bool moves = j >= band.row_begin;
        if (band.halo == nullptr || (moves && j + 2 < band.row_end)) {
            RowSweep<D, damped, air, update, true>(pass, rows, band.lines, j, moves).sweep();
        } else {
            RowSweep<D, damped, air, update, false>(pass, rows, band.lines, j, moves).sweep();
        }
    }
}

template <class D, GridUpdate update, typename Pass, typename Band>
HWY_INLINE void sweep_with(const Pass& pass, const Band& band) {
    if (pass.air) {
        sweep_rows<D, true, true, update>(pass, band);
    } else if (pass.damped) {
        sweep_rows<D, true, false, update>(pass, band);
    } else {
        sweep_rows<D, false, false, update>(pass, band);
    }
}

/// Runs the pass over a band with full vectors.
template <typename Real>
HWY_INLINE void sweep(const GridPass<Real>& pass, const GridBand<Real>& band) {
    using D = hn::ScalableTag<Real>;
    switch (pass.update) {
        case GridUpdate::acceleration:
            return sweep_with<D, GridUpdate::acceleration>(pass, band);
        case GridUpdate::kick_drift:
            return sweep_with<D, GridUpdate::kick_drift>(pass, band);
        case GridUpdate::verlet:
            return sweep_with<D, GridUpdate::verlet>(pass, band);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
