// Compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/block_pass.cpp"  // NOLINT
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "math/block_factor-inl.h"
#include "math/block_pass.h"
#include "math/pack-inl.h"
#include "math/records-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

using FloatTag = hn::ScalableTag<float>;
using FloatVector = hn::Vec<FloatTag>;
using FloatPack = Pack<FloatTag>;

// Numbers n and up of a group, block_lanes apart.
HWY_INLINE FloatVector number(const float* group, std::size_t n) {
    return hn::Load(FloatTag(), group + n * block_lanes);
}

// The rows of one vector: `lanes` of a slice, the first of them `lane`.
struct RowsAt {
    std::size_t slice, lane;

    HWY_INLINE FloatPack load(const float* values) const {
        const float* const at = values + 3 * block_lanes * slice + lane;
        return {number(at, 0), number(at, 1), number(at, 2)};
    }
    HWY_INLINE void store(const FloatPack& p, float* values) const {
        const FloatTag d;
        float* const at = values + 3 * block_lanes * slice + lane;
        hn::Store(p.x, d, at);
        hn::Store(p.y, d, at + block_lanes);
        hn::Store(p.z, d, at + 2 * block_lanes);
    }
    // Values, and records where somebody reads them.
    HWY_INLINE void store(const FloatPack& p, const BlockPass& pass) const {
        store(p, pass.out);
        if (pass.out_records == nullptr) return;
        store_records(FloatTag(), p, pass.out_records + 4 * (block_lanes * slice + lane));
    }
};

// sum + S u of symmetric blocks.
HWY_INLINE FloatPack plus_symmetric(FloatPack sum, const float* block, const FloatPack& u) {
    const auto xy = number(block, 1), xz = number(block, 2), yz = number(block, 4);
    sum = plus_scaled(sum, u.x, FloatPack{number(block, 0), xy, xz});
    sum = plus_scaled(sum, u.y, FloatPack{xy, number(block, 3), yz});
    return plus_scaled(sum, u.z, FloatPack{xz, yz, number(block, 5)});
}

// A u at these rows.
template <BlockForm form>
HWY_INLINE FloatPack row_product(const BlockPass& pass, RowsAt rows, const FloatPack& u) {
    const FloatTag d;
    constexpr std::size_t size = static_cast<std::size_t>(form) * block_lanes;
    FloatPack sum =
        plus_symmetric(zero_pack(d), pass.own + 6 * block_lanes * rows.slice + rows.lane, u);
    for (std::size_t n = pass.starts[rows.slice]; n < pass.starts[rows.slice + 1]; ++n) {
        const float* const k = pass.couplings + size * n + rows.lane;
        const std::uint32_t* const columns = pass.columns + block_lanes * n + rows.lane;
        const FloatPack du = minus(u, gather_records(d, pass.u_records, columns));
        if constexpr (form == BlockForm::spring) {
            const FloatPack g{number(k, 1), number(k, 2), number(k, 3)};
            sum = plus_scaled(sum, number(k, 0), du);
            sum = plus_scaled(sum, dot(g, du), g);
        } else {
            sum = plus_symmetric(sum, k, du);
        }
    }
    return sum;
}

// weight W^T W r
HWY_INLINE FloatPack divided(const BlockPass& pass, RowsAt rows, const FloatPack& r) {
    const float* const w = pass.factors + 6 * block_lanes * rows.slice + rows.lane;
    const auto yx = number(w, 1), zx = number(w, 2), zy = number(w, 4);
    const auto xx = number(w, 0), yy = number(w, 3), zz = number(w, 5);
    const auto x = hn::Mul(xx, r.x);
    const auto y = hn::MulAdd(yx, r.x, hn::Mul(yy, r.y));
    const auto z = hn::MulAdd(zx, r.x, hn::MulAdd(zy, r.y, hn::Mul(zz, r.z)));
    const FloatPack solved{hn::MulAdd(xx, x, hn::MulAdd(yx, y, hn::Mul(zx, z))),
                           hn::MulAdd(yy, y, hn::Mul(zy, z)), hn::Mul(zz, z)};
    return times(hn::Set(FloatTag(), pass.weight), solved);
}

// Calls body(rows, sum) for all rows of blocks; `sum` in every lane its own.
template <class Body>
HWY_INLINE void for_rows(const BlockPass& pass, std::size_t begin, std::size_t end,
                         const Body& body) {
    const FloatTag d;
    for (std::size_t block = begin; block < end; ++block) {
        const std::size_t first = block * slices_per_block;
        const std::size_t rest = pass.slices - first;
        const std::size_t last = first + (rest < slices_per_block ? rest : slices_per_block);
        auto sum = hn::Zero(d);
        for (std::size_t slice = first; slice < last; ++slice) {
            for (std::size_t lane = 0; lane < block_lanes; lane += hn::Lanes(d)) {
                body(RowsAt{slice, lane}, sum);
            }
        }
        if (pass.sums != nullptr) {
            pass.sums[block] = static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)));
        }
    }
}

HWY_INLINE FloatVector plus_dot(const FloatPack& a, const FloatPack& b, FloatVector sum) {
    return hn::Add(sum, dot(a, b));
}

template <BlockForm form>
HWY_NOINLINE void product_of(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](RowsAt rows, FloatVector& sum) HWY_ATTR {
        const FloatPack u = rows.load(pass.u);
        const FloatPack out = row_product<form>(pass, rows, u);
        sum = plus_dot(u, out, sum);
        rows.store(out, pass);
    });
}

template <BlockForm form>
HWY_NOINLINE void residual_of(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](RowsAt rows, FloatVector&) HWY_ATTR {
        const FloatPack product = row_product<form>(pass, rows, rows.load(pass.u));
        rows.store(minus(rows.load(pass.b), product), pass);
    });
}

template <BlockForm form>
HWY_NOINLINE void smooth_of(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](RowsAt rows, FloatVector& sum) HWY_ATTR {
        const FloatPack u = rows.load(pass.u), b = rows.load(pass.b);
        const FloatPack r = minus(b, row_product<form>(pass, rows, u));
        const FloatPack out = plus(u, divided(pass, rows, r));
        sum = plus_dot(b, out, sum);
        rows.store(out, pass);
    });
}

void product(const BlockPass& pass, std::size_t begin, std::size_t end) {
    if (pass.form == BlockForm::spring) return product_of<BlockForm::spring>(pass, begin, end);
    product_of<BlockForm::symmetric>(pass, begin, end);
}
void residual(const BlockPass& pass, std::size_t begin, std::size_t end) {
    if (pass.form == BlockForm::spring) return residual_of<BlockForm::spring>(pass, begin, end);
    residual_of<BlockForm::symmetric>(pass, begin, end);
}
void smooth(const BlockPass& pass, std::size_t begin, std::size_t end) {
    if (pass.form == BlockForm::spring) return smooth_of<BlockForm::spring>(pass, begin, end);
    smooth_of<BlockForm::symmetric>(pass, begin, end);
}

void precondition(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](RowsAt rows, FloatVector& sum) HWY_ATTR {
        const FloatPack b = rows.load(pass.b), out = divided(pass, rows, b);
        sum = plus_dot(b, out, sum);
        rows.store(out, pass);
    });
}

void advance(const BlockPass& pass, std::size_t begin, std::size_t end) {
    const auto weight = hn::Set(FloatTag(), pass.weight);
    for_rows(pass, begin, end, [&](RowsAt rows, FloatVector& sum) HWY_ATTR {
        rows.store(plus_scaled(rows.load(pass.out), weight, rows.load(pass.u)), pass.out);
        const FloatPack r = minus_scaled(rows.load(pass.residual), weight, rows.load(pass.b));
        sum = plus_dot(r, r, sum);
        rows.store(r, pass.residual);
    });
}

void direction(const BlockPass& pass, std::size_t begin, std::size_t end) {
    const auto weight = hn::Set(FloatTag(), pass.weight);
    for_rows(pass, begin, end, [&](RowsAt rows, FloatVector&) HWY_ATTR {
        rows.store(plus_scaled(rows.load(pass.u), weight, rows.load(pass.out)), pass);
    });
}

void transfer(const BlockPass& pass, std::size_t begin, std::size_t end) {
    const FloatTag d;
    for_rows(pass, begin, end, [&](RowsAt rows, FloatVector&) HWY_ATTR {
        FloatPack sum = pass.u == nullptr ? zero_pack(d) : rows.load(pass.u);
        for (std::size_t n = pass.starts[rows.slice]; n < pass.starts[rows.slice + 1]; ++n) {
            const std::size_t at = block_lanes * n + rows.lane;
            sum = plus_scaled(sum, hn::Load(d, pass.couplings + at),
                              gather_records(d, pass.u_records, pass.columns + at));
        }
        rows.store(sum, pass);
    });
}

BlockFunctions compiled_block_functions() {
    return {factor, product, residual, smooth, precondition, advance, direction, transfer};
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#if HWY_ONCE
namespace weft {

BlockFunctions block_functions(InstructionSet set) {
    BlockFunctions (*const compiled)() = WEFT_SIMD_FUNCTION(set, compiled_block_functions);
    return compiled != nullptr ? compiled() : plain_block_functions();
}

}  // namespace weft
#endif
