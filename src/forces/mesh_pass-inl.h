// The parts of a pass of forces/mesh_pass.h with the vectors of one instruction set; included once
// for each.
#if defined(WEFT_FORCES_MESH_PASS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_MESH_PASS_INL_H
#undef WEFT_FORCES_MESH_PASS_INL_H
#else
#define WEFT_FORCES_MESH_PASS_INL_H
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "forces/mesh_pass.h"
#include "forces/mesh_pass_rows-inl.h"
#include "forces/plate_force-inl.h"
#include "math/pack-inl.h"
#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// How far ahead tables and states are asked for, in numbers: more streams are read at once than the
// processor itself foresees, which took half as long again of a mesh larger than the caches.
inline constexpr std::size_t table_ahead = 2048, state_ahead = 256;

template <typename T>
HWY_INLINE void copy_rows(const MeshPass<T>& pass, std::size_t begin, std::size_t end) {
    constexpr int size = MeshPass<T>::row_size;
    const hn::ScalableTag<T> d;
    for (std::size_t s = begin * hn::Lanes(d); s < end * hn::Lanes(d); s += hn::Lanes(d)) {
        for (std::size_t c = 0; c < 3; ++c) {
            hwy::Prefetch(pass.x[c] + s + state_ahead);
            hwy::Prefetch(pass.v[c] + s + state_ahead);
        }
        T* const row = pass.rows + size * (s & pass.row_mask);
        store_rows<size>(d, load_pack(d, pass.x[0] + s, pass.x[1] + s, pass.x[2] + s), row);
        store_rows<size>(d, load_pack(d, pass.v[0] + s, pass.v[1] + s, pass.v[2] + s), row + 4);
    }
}

template <typename T>
HWY_INLINE void find_thirds(const MeshPass<T>& pass, std::size_t begin, std::size_t end) {
    constexpr int size = MeshPass<T>::third_size;
    const hn::ScalableTag<T> d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t n = begin; n < end; ++n) {
        const std::uint32_t* const corners = pass.corners + 3 * n * lanes;
        for (std::size_t k = 0; k < 3; ++k) hwy::Prefetch(corners + k * lanes + table_ahead);
        const auto a = gather_moving(d, pass.rows, corners);
        const auto b = gather_moving(d, pass.rows, corners + lanes);
        const auto c = gather_moving(d, pass.rows, corners + 2 * lanes);
        const auto normal = cross(minus(b.x, a.x), minus(c.x, a.x));
        const auto third =
            plate_third(d, pass.air_constants, pass.wind, normal, plus(a.v, plus(b.v, c.v)));
        store_rows<size>(d, third, pass.thirds + size * (n * lanes & pass.third_mask));
    }
}

// One slice's sums.
template <class D>
class SliceSums {
    using T = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using P = Pack<D>;

public:
    HWY_INLINE SliceSums(const MeshPass<T>& pass, std::size_t slice)
        : pass_(pass),
          slice_(slice),
          slot_(slice * hn::Lanes(D())),
          x_(load(pass.x)),
          v_(load(pass.v)) {}

    HWY_INLINE void sum_and_move() {
        const D d;
        P force = zero_pack(d);
        const std::uint32_t* const starts = pass_.spring_starts + slice_ * spring_kind_count;
        for (std::size_t kind = 0; kind < spring_kind_count; ++kind) {
            const MeshSpringConstants<T>& constants = pass_.springs[kind];
            const std::size_t begin = starts[kind], end = starts[kind + 1];
            if (pass_.widths == nullptr) {
                if (constants.damping != 0) {
                    add_springs<true, false>(constants, begin, end, force);
                } else {
                    add_springs<false, false>(constants, begin, end, force);
                }
            } else if (constants.damping != 0) {
                add_springs<true, true>(constants, begin, end, force);
            } else {
                add_springs<false, true>(constants, begin, end, force);
            }
        }
        if (pass_.air) add_thirds(force);
        apply(force);
    }

private:
    HWY_INLINE P load(const std::array<T*, 3>& from) const {
        return load_pack(D(), from[0] + slot_, from[1] + slot_, from[2] + slot_);
    }
    HWY_INLINE void store(const P& value, const std::array<T*, 3>& to) const {
        const D d;
        hn::StoreU(value.x, d, to[0] + slot_);
        hn::StoreU(value.y, d, to[1] + slot_);
        hn::StoreU(value.z, d, to[2] + slot_);
    }

    // Adds (k - k L / |d| + c (dv.d) / |d|^2) d of the springs in vectors [begin, end).
    template <bool damped, bool weighted>
    HWY_INLINE void add_springs(const MeshSpringConstants<T>& constants, std::size_t begin,
                                std::size_t end, P& force) const {
        const D d;
        const std::size_t lanes = hn::Lanes(d);
        const V stiffness = hn::Set(d, constants.stiffness);
        const V damping = hn::Set(d, constants.damping);
        P sum = force;
        for (std::size_t n = begin * lanes; n < end * lanes; n += lanes) {
            P dx;
            hwy::Prefetch(pass_.neighbours + n + table_ahead);
            hwy::Prefetch(pass_.tensions + n + table_ahead);
            V k = stiffness, c = damping;
            if constexpr (weighted) {
                hwy::Prefetch(pass_.widths + n + table_ahead);
                const V width = hn::Load(d, pass_.widths + n);
                k = hn::Mul(width, k);
                if constexpr (damped) c = hn::Mul(width, c);
            }
            const V tension = hn::Load(d, pass_.tensions + n);
            V strength;
            if constexpr (damped) {
                const Moving<D> other = gather_moving(d, pass_.rows, pass_.neighbours + n);
                dx = minus(other.x, x_);
                const V root = scaled_inverse_root(d, square(d, dx));
                const V rate = hn::Mul(c, dot(dx, minus(other.v, v_)));
                strength = hn::MulAdd(root, hn::MulSub(rate, root, tension), k);
            } else {
                dx = minus(gather_rows(d, pass_.rows, pass_.neighbours + n), x_);
                const V root = scaled_inverse_root(d, square(d, dx));
                strength = hn::NegMulAdd(root, tension, k);
            }
            sum = plus_scaled(sum, strength, dx);
        }
        force = sum;
    }

    HWY_INLINE void add_thirds(P& force) const {
        const D d;
        const std::size_t lanes = hn::Lanes(d);
        P sum = force;
        const std::size_t end = pass_.triangle_starts[slice_ + 1];
        for (std::size_t n = pass_.triangle_starts[slice_]; n < end; ++n) {
            const std::uint32_t* const triangles = pass_.triangles + n * lanes;
            hwy::Prefetch(triangles + table_ahead);
            sum = plus(sum, gather_rows(d, pass_.thirds, triangles));
        }
        force = sum;
    }

    // force: all but gravity and drag.
    HWY_INLINE void apply(const P& force) const {
        const D d;
        const V w = hn::Load(d, pass_.inverse_masses + slot_);
        const auto free = hn::Gt(w, hn::Zero(d));
        const P f = minus_scaled(force, hn::Set(d, pass_.drag), v_);
        const P g = set(d, pass_.gravity);
        const P a = plus_scaled(P{hn::IfThenElseZero(free, g.x), hn::IfThenElseZero(free, g.y),
                                  hn::IfThenElseZero(free, g.z)},
                                w, f);
        if (pass_.update == MeshUpdate::acceleration) {
            store(a, pass_.a);
        } else {
            const P moving = plus_scaled(v_, hn::Set(d, pass_.kick), a);
            store(moving, pass_.v);
            store(plus_scaled(x_, hn::Set(d, pass_.drift), moving), pass_.x);
        }
    }

    const MeshPass<T>& pass_;
    const std::size_t slice_, slot_;
    const P x_, v_;
};

template <typename T>
HWY_INLINE void sum_and_move(const MeshPass<T>& pass, std::size_t begin, std::size_t end) {
    for (std::size_t slice = begin; slice < end; ++slice) {
        SliceSums<hn::ScalableTag<T>>(pass, slice).sum_and_move();
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
