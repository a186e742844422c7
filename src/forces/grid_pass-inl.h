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
#include "forces/grid_strip_rows-inl.h"
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
template <class D, class Rows, bool damped, bool air, GridUpdate update, bool in_place>
class RowSweep {
    using T = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using P = Pack<D>;
    using Row = typename Rows::Row;

public:
    // @param lines of this row and the two below, by their line buffers.
    HWY_INLINE RowSweep(const GridPass<T>& pass, const Rows& rows, T* lines, std::size_t j,
                        bool moves)
        : pass_(pass),
          moves_(moves),
          x0_(rows.row(Rows::position, j)),
          x1_(row_below(rows, 1, j)),
          x2_(row_below(rows, 2, j)),
          v0_(rows.row_like(x0_, Rows::velocity, j)),
          v1_(rows.row_like(x1_, Rows::velocity, below(j, 1))),
          v2_(rows.row_like(x2_, Rows::velocity, below(j, 2))),
          a_(rows.row(Rows::acceleration, j)),
          masses_(rows.masses(j)),
          line0_(line(lines, j)),
          line1_(line(lines, j + 1)),
          line2_(line(lines, j + 2)),
          row_(pass.row_constants[pass.row_kind(j)]),
          air_(row_.has_triangles ? pass.air_constants : AirConstants<T>{}),
          runs_(rows.runs()) {}

    HWY_INLINE void sweep() {
        const D d;
        if constexpr (Rows::in_strips) {
            // What the ends of strips put to the right arrives at the beginnings.
            vectors<true, false>((pass_.strips.length - 2) * hn::Lanes(d), 2);
            carry_right_.to_next_strip(d);
            carry_far_.to_next_strip(d);
            carry_below_.to_next_strip(d);
        }
        vectors<true>(0, runs_.left);
        vectors<false>(runs_.left * hn::Lanes(d), runs_.inner);
        vectors<true>((runs_.left + runs_.inner) * hn::Lanes(d), runs_.right);
    }

private:
    // A row so far below, or the last one, where springs have no stiffness.
    [[nodiscard]] std::size_t below(std::size_t j, std::size_t by) const {
        return j + by < pass_.rows ? j + by : pass_.rows - 1;
    }
    [[nodiscard]] Row row_below(const Rows& rows, std::size_t by, std::size_t j) const {
        return in_place ? rows.row_like(x0_, Rows::position, below(j, by))
                        : rows.row(Rows::position, below(j, by));
    }
    [[nodiscard]] RowOf<T> line(T* lines, std::size_t j) const {
        return {lines + 3 * (j % 3) * pass_.stride, static_cast<std::ptrdiff_t>(pass_.stride)};
    }

    // @tparam acts false: only finds what the vectors carry.
    template <bool edge, bool acts = true>
    HWY_INLINE void vectors(std::size_t i, std::size_t count) {
        if (count == 0) return;
        const D d;
        const auto& families = edge ? row_.edge : row_.inner;
        const FamilyVectors<D> k_row(d, families[along_row]);
        const FamilyVectors<D> k_column(d, families[along_column]);
        const FamilyVectors<D> k_shear(d, families[shear]);
        const FamilyVectors<D> k_bend_row(d, families[bend_row]);
        const FamilyVectors<D> k_bend_column(d, families[bend_column]);
        auto carry_right = carry_right_;
        auto carry_far = carry_far_;
        auto carry_below = carry_below_;
        for (const std::size_t end = i + count * hn::Lanes(d); i < end; i += hn::Lanes(d)) {
            const auto factor = [&](Family family, V strength) HWY_ATTR {
                if constexpr (edge) {
                    return hn::Mul(strength, hn::LoadU(d, pass_.column_factors[family] + i));
                } else {
                    (void)family;
                    return strength;
                }
            };
            if constexpr (update != GridUpdate::verlet) prefetch(x2_, i);
            const P x = load(d, x0_, i), v = load(d, v0_, i);
            const P x_right = load_ahead<1>(d, x, x0_, i), v_right = load_ahead<1>(d, v, v0_, i);
            const P x_below = load(d, x1_, i), v_below = load(d, v1_, i);

            // Differences lead from the other end to this vector's, so that one instruction loads
            // and subtracts: a spring's strength times its own is the force on the other end.
            const P dx_row = minus(x, x_right);
            P right = times(
                factor(along_row, strength<damped>(d, k_row, dx_row, minus(v, v_right))), dx_row);
            P given = right;

            const P dx_column = minus(x, x_below);
            P down = times(
                factor(along_column, strength<damped>(d, k_column, dx_column, minus(v, v_below))),
                dx_column);
            given = plus(given, down);

            const P v_diagonal = load_next(d, v_below, v1_, i);
            const P dx_shear = minus(x, load_next(d, x_below, x1_, i));
            P diagonal =
                times(factor(shear, strength<damped>(d, k_shear, dx_shear, minus(v, v_diagonal))),
                      dx_shear);
            given = plus(given, diagonal);

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
                given = minus(given, both);
                right = plus(right, upper);
                down = plus(down, lower);
                diagonal = plus(diagonal, both);
            }

            // From (i+1, j) to (i, j+1).
            const P dx_anti = minus(x_right, x_below);
            const V s_anti =
                factor(anti, strength<damped>(d, k_shear, dx_anti, minus(v_right, v_below)));
            down = plus_scaled(down, s_anti, dx_anti);
            right = minus_scaled(right, s_anti, dx_anti);

            const P dx_bend_row = minus(x, load_ahead<2>(d, x, x0_, i));
            const P far_right =
                times(factor(bend_row, strength<damped>(d, k_bend_row, dx_bend_row,
                                                        minus(v, load_ahead<2>(d, v, v0_, i)))),
                      dx_bend_row);
            given = plus(given, far_right);

            const P dx_bend_column = minus(x, load(d, x2_, i));
            const P far_down =
                times(factor(bend_column, strength<damped>(d, k_bend_column, dx_bend_column,
                                                           minus(v, load(d, v2_, i)))),
                      dx_bend_column);
            given = plus(given, far_down);

            // What owners to the left and above put here; what this vector puts below.
            const P from_left = carry_right.pass(d, right), from_far = carry_far.pass(d, far_right);
            const P put_below = plus(down, carry_below.pass(d, diagonal));
            if constexpr (acts) {
                given = minus(given, load(d, line0_, i));
                given = minus(given, from_left);
                given = minus(given, from_far);
                store(d, plus(load(d, line1_, i), put_below), line1_, i);
                store(d, far_down, line2_, i);
                if (moves_) apply(d, given, x, v, i);
            }
        }
        carry_right_ = carry_right;
        carry_far_ = carry_far;
        carry_below_ = carry_below;
    }

    // @param given the force turned round, all but gravity and drag.
    HWY_INLINE void apply(D d, const P& given, const P& x, const P& v, std::size_t i) {
        const V w = load_first(d, masses_, i);
        if constexpr (update == GridUpdate::kick_drift) {
            // v + kick (g + w (force - drag v)), sorted by what is multiplied.
            const V kick = hn::Mul(w, hn::Set(d, pass_.kick));
            const V kept = hn::NegMulAdd(kick, hn::Set(d, pass_.drag), hn::Set(d, T{1}));
            const P falling = plus_scaled(gravity(d, w, pass_.kick), kept, v);
            const P moving = minus_scaled(falling, kick, given);
            store(d, moving, v0_, i);
            store(d, plus_scaled(x, hn::Set(d, pass_.drift), moving), x0_, i);
        } else {
            const P lost = plus_scaled(given, hn::Set(d, pass_.drag), v);
            const P a = minus_scaled(gravity(d, w, T{1}), w, lost);
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
    const Row x0_, x1_, x2_, v0_, v1_, v2_, a_, masses_;
    const RowOf<T> line0_, line1_, line2_;
    const GridRowConstants<T>& row_;
    const AirConstants<T> air_;  // zero where the row has no triangles below
    const VectorRuns runs_;
    // What vectors put one and two columns to the right, and below the first of these.
    typename Rows::template CarryOf<1, D> carry_right_{D()}, carry_below_{D()};
    typename Rows::template CarryOf<2, D> carry_far_{D()};
};

// Velocity Verlet's drift of a row, to where forces are then computed, and its moving pins.
template <class D, class Rows>
class VerletDrift {
    using T = hn::TFromD<D>;
    using Row = typename Rows::Row;

public:
    VerletDrift(const GridPass<T>& pass, const Rows& rows, std::size_t first_row)
        : pass_(pass), rows_(rows) {
        while (next_pin_ < pass.pin_count && pass.pins[next_pin_].slot < first_row * pass.stride) {
            ++next_pin_;
        }
    }

    // Rows in rising order.
    HWY_INLINE void row(std::size_t j) {
        const D d;
        const Row x = rows_.row(Rows::position, j);
        const Row v = rows_.row(Rows::velocity, j);
        const Row a = rows_.row(Rows::acceleration, j);
        const auto h = hn::Set(d, pass_.kick), half_h2 = hn::Set(d, pass_.kick * pass_.kick / 2);
        const std::size_t end = rows_.vectors() * hn::Lanes(d);
        for (std::size_t i = 0; i < end; i += hn::Lanes(d)) {
            prefetch(x, i);
            const Pack<D> velocity = load(d, v, i), acceleration = load(d, a, i);
            const Pack<D> moved = plus_scaled(load(d, x, i), h, velocity);
            store(d, plus_scaled(moved, half_h2, acceleration), x, i);
            store(d, plus_scaled(velocity, h, acceleration), v, i);
        }
        for (; next_pin_ < pass_.pin_count; ++next_pin_) {
            const PinTarget<T>& pin = pass_.pins[next_pin_];
            if (pin.slot >= (j + 1) * pass_.stride) break;
            const std::size_t column = pin.slot - j * pass_.stride;
            rows_.put(pin.x, x, column);
            rows_.put(pin.v, v, column);
        }
        rows_.close(j);
    }

private:
    const GridPass<T>& pass_;
    const Rows rows_;
    std::size_t next_pin_ = 0;
};

template <class D, class Rows, bool damped, bool air, GridUpdate update>
HWY_NOINLINE void sweep_rows(const GridPass<hn::TFromD<D>>& pass,
                             const GridBand<hn::TFromD<D>>& band) {
    using T = hn::TFromD<D>;
    const Rows rows(pass, band);
    const std::size_t first = band.row_begin > 2 ? band.row_begin - 2 : 0;
    std::fill_n(band.lines, GridBand<T>::line_count * pass.stride, T{0});
    VerletDrift<D, Rows> drift(pass, rows, first);
    if constexpr (update == GridUpdate::verlet) {
        drift.row(first);
        if (first + 1 < pass.rows) drift.row(first + 1);
    }
    for (std::size_t j = first; j < band.row_end; ++j) {
        if constexpr (update == GridUpdate::verlet) {
            if (j + 2 < pass.rows) drift.row(j + 2);
        }
        const bool moves = j >= band.row_begin;
        if (Rows::in_strips || band.halo == nullptr || (moves && j + 2 < band.row_end)) {
            RowSweep<D, Rows, damped, air, update, true>(pass, rows, band.lines, j, moves).sweep();
        } else {
            RowSweep<D, Rows, damped, air, update, false>(pass, rows, band.lines, j, moves).sweep();
        }
        if (moves) rows.close(j);
    }
}

// One row of a grid in strips. (A function by itself: so the compiler has all registers for it.)
template <class D, class Rows, bool damped, bool air>
HWY_NOINLINE void kick_drift_row(const GridPass<hn::TFromD<D>>& pass, const Rows& rows,
                                 hn::TFromD<D>* lines, std::size_t j) {
    RowSweep<D, Rows, damped, air, GridUpdate::kick_drift, true>(pass, rows, lines, j, true)
        .sweep();
    rows.close(j);
}

// Two passes in one sweep (GridPass::second).
template <class D, class Rows, bool damped, bool air>
HWY_INLINE void sweep_twice(const GridPass<hn::TFromD<D>>& pass,
                            const GridBand<hn::TFromD<D>>& band) {
    using T = hn::TFromD<D>;
    const Rows rows(pass, band);
    const std::size_t lines = GridBand<T>::line_count * pass.stride;
    std::fill_n(band.lines, 2 * lines, T{0});
    for (std::size_t j = 0; j < pass.rows + 2; ++j) {
        if (j < pass.rows) kick_drift_row<D, Rows, damped, air>(pass, rows, band.lines, j);
        if (j < 2) continue;
        kick_drift_row<D, Rows, damped, air>(*pass.second, rows, band.lines + lines, j - 2);
    }
}

template <class D, class Rows, bool damped, bool air, GridUpdate update, typename Pass,
          typename Band>
HWY_INLINE void sweep_once_or_twice(const Pass& pass, const Band& band) {
    if constexpr (Rows::in_strips && update == GridUpdate::kick_drift) {
        if (pass.second != nullptr) return sweep_twice<D, Rows, damped, air>(pass, band);
    }
    sweep_rows<D, Rows, damped, air, update>(pass, band);
}

template <class D, class Rows, GridUpdate update, typename Pass, typename Band>
HWY_INLINE void sweep_with(const Pass& pass, const Band& band) {
    if (pass.air) {
        sweep_once_or_twice<D, Rows, true, true, update>(pass, band);
    } else if (pass.damped) {
        sweep_once_or_twice<D, Rows, true, false, update>(pass, band);
    } else {
        sweep_once_or_twice<D, Rows, false, false, update>(pass, band);
    }
}

/// Runs the pass over a band with full vectors.
template <typename Real>
HWY_INLINE void sweep(const GridPass<Real>& pass, const GridBand<Real>& band) {
    using D = hn::ScalableTag<Real>;
    using Rows = BandRows<Real>;
    constexpr GridUpdate kick_drift = GridUpdate::kick_drift, verlet = GridUpdate::verlet;
    if (pass.strips.blocks != nullptr && pass.update == kick_drift) {
        return sweep_with<D, StripRows<Real, kick_drift>, kick_drift>(pass, band);
    }
    if (pass.strips.blocks != nullptr) {
        return sweep_with<D, StripRows<Real, verlet>, verlet>(pass, band);
    }
    switch (pass.update) {
        case GridUpdate::acceleration:
            return sweep_with<D, Rows, GridUpdate::acceleration>(pass, band);
        case kick_drift:
            return sweep_with<D, Rows, kick_drift>(pass, band);
        case verlet:
            return sweep_with<D, Rows, verlet>(pass, band);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
