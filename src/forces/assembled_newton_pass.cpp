// Compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/assembled_newton_pass.cpp"  // NOLINT
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "forces/assembled_newton_pass.h"
#include "forces/mesh_pass_rows-inl.h"
#include "math/pack-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

using DoubleTag = hn::ScalableTag<double>;
using DoublePack = Pack<DoubleTag>;

// A spring a lane as a I + g g^T.
struct SpringCoupling {
    hn::Vec<DoubleTag> a;
    DoublePack g;
};

HWY_INLINE SpringCoupling coupling_at(const AssembledPass& pass, std::size_t place,
                                      const DoublePack& x) {
    const DoubleTag d;
    const DoublePack dx = minus(gather_rows(d, pass.x, pass.columns + place), x);
    const auto root = inverse_root(d, square(d, dx));
    const auto k = hn::Load(d, pass.stiffnesses + place);
    const auto strain =
        hn::NegMulAdd(hn::Load(d, pass.rest_lengths + place), root, hn::Set(d, 1.0));
    const auto across = hn::Mul(k, hn::Max(hn::Zero(d), strain));
    const auto along = hn::MulAdd(hn::Load(d, pass.dampings + place), hn::Set(d, pass.inverse_tau),
                                  hn::Sub(k, across));
    return {across, times(hn::Mul(hn::Sqrt(along), root), dx)};
}

HWY_INLINE DoublePack load_rows(const double* rows) {
    DoublePack p;
    auto rest = hn::Zero(DoubleTag());
    hn::LoadInterleaved4(DoubleTag(), rows, p.x, p.y, p.z, rest);
    return p;
}

// Calls body(slice, lane) for the vectors of rows of slices.
template <class Body>
HWY_INLINE void for_lanes(std::size_t begin, std::size_t end, const Body& body) {
    for (std::size_t slice = begin; slice < end; ++slice) {
        for (std::size_t lane = 0; lane < block_lanes; lane += hn::Lanes(DoubleTag())) {
            body(slice, lane);
        }
    }
}

void assemble(const AssembledPass& pass, std::size_t begin, std::size_t end) {
    const hn::Rebind<float, DoubleTag> floats;
    for_lanes(begin, end, [&](std::size_t slice, std::size_t lane) HWY_ATTR {
        const DoublePack x = load_rows(pass.x + 4 * (slice * block_lanes + lane));
        for (std::size_t n = pass.starts[slice]; n < pass.starts[slice + 1]; ++n) {
            const SpringCoupling k = coupling_at(pass, n * block_lanes + lane, x);
            float* const to = pass.couplings + 4 * n * block_lanes + lane;
            hn::Store(hn::DemoteTo(floats, k.a), floats, to);
            hn::Store(hn::DemoteTo(floats, k.g.x), floats, to + block_lanes);
            hn::Store(hn::DemoteTo(floats, k.g.y), floats, to + 2 * block_lanes);
            hn::Store(hn::DemoteTo(floats, k.g.z), floats, to + 3 * block_lanes);
        }
    });
}

void product(const AssembledPass& pass, std::size_t begin, std::size_t end) {
    const DoubleTag d;
    for_lanes(begin, end, [&](std::size_t slice, std::size_t lane) HWY_ATTR {
        const std::size_t row = 4 * (slice * block_lanes + lane);
        const DoublePack x = load_rows(pass.x + row), u = load_rows(pass.u + row);
        DoublePack sum = zero_pack(d);
        for (std::size_t n = pass.starts[slice]; n < pass.starts[slice + 1]; ++n) {
            const std::size_t place = n * block_lanes + lane;
            const SpringCoupling k = coupling_at(pass, place, x);
            const DoublePack du = minus(u, gather_rows(d, pass.u, pass.columns + place));
            sum = plus_scaled(sum, k.a, du);
            sum = plus_scaled(sum, dot(k.g, du), k.g);
        }
        hn::StoreInterleaved4(sum.x, sum.y, sum.z, hn::Zero(d), d, pass.out + row);
    });
}

AssembledFunctions compiled_assembled_functions() {
    return {assemble, product};
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#if HWY_ONCE
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

// The readable twins.
Vec3d row_of(const double* rows, std::size_t row) {
    return {rows[4 * row], rows[4 * row + 1], rows[4 * row + 2]};
}

struct PlainCoupling {
    double a = 0.0;
    Vec3d g{};
};

PlainCoupling plain_coupling(const AssembledPass& pass, std::size_t place, std::size_t row) {
    const Vec3d d = row_of(pass.x, pass.columns[place] / 4) - row_of(pass.x, row);
    const double l = length(d);
    if (!(l > 0.0)) return {};
    const double k = pass.stiffnesses[place];
    const double across = k * std::max(0.0, 1 - pass.rest_lengths[place] / l);
    const double along = k - across + pass.dampings[place] * pass.inverse_tau;
    return {across, (std::sqrt(along) / l) * d};
}

// Calls body(place, row) for the places of rows of slices.
template <typename Body>
void for_places(const AssembledPass& pass, std::size_t begin, std::size_t end, const Body& body) {
    for (std::size_t slice = begin; slice < end; ++slice) {
        for (std::size_t place = pass.starts[slice] * block_lanes;
             place < pass.starts[slice + 1] * block_lanes; ++place) {
            body(place, slice * block_lanes + place % block_lanes);
        }
    }
}

void plain_assemble(const AssembledPass& pass, std::size_t begin, std::size_t end) {
    for_places(pass, begin, end, [&](std::size_t place, std::size_t row) {
        const PlainCoupling k = plain_coupling(pass, place, row);
        float* const to =
            pass.couplings + place / block_lanes * 4 * block_lanes + place % block_lanes;
        to[0] = static_cast<float>(k.a);
        to[block_lanes] = static_cast<float>(k.g.x);
        to[2 * block_lanes] = static_cast<float>(k.g.y);
        to[3 * block_lanes] = static_cast<float>(k.g.z);
    });
}

void plain_product(const AssembledPass& pass, std::size_t begin, std::size_t end) {
    std::fill(pass.out + 4 * begin * block_lanes, pass.out + 4 * end * block_lanes, 0.0);
    for_places(pass, begin, end, [&](std::size_t place, std::size_t row) {
        const PlainCoupling k = plain_coupling(pass, place, row);
        const Vec3d du = row_of(pass.u, row) - row_of(pass.u, pass.columns[place] / 4);
        const Vec3d f = k.a * du + dot(k.g, du) * k.g;
        double* const out = pass.out + 4 * row;
        out[0] += f.x, out[1] += f.y, out[2] += f.z;
    });
}

}  // namespace

AssembledFunctions assembled_functions(InstructionSet set) {
    AssembledFunctions (*const compiled)() = WEFT_SIMD_FUNCTION(set, compiled_assembled_functions);
    return compiled != nullptr ? compiled() : AssembledFunctions{plain_assemble, plain_product};
}

}  // namespace weft
#endif
