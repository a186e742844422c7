#include "forces/assembled_springs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t slice_grain = 128;   // slices worth a thread
constexpr std::size_t block_slots = 1024;  // whose squares are summed together

void copy_rows(ConstVec3View<double> from, LineAligned<double>& rows) {
    parallel_for(from.size, slice_grain * block_lanes, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) {
            rows[4 * s] = from.x[s], rows[4 * s + 1] = from.y[s], rows[4 * s + 2] = from.z[s];
        }
    });
}

Vec3d block_times(const SymmetricBlocks<double>& b, std::size_t s, Vec3d u) {
    const auto& [xx, xy, xz, yy, yz, zz] = b.entries;
    return {xx[s] * u.x + xy[s] * u.y + xz[s] * u.z, xy[s] * u.x + yy[s] * u.y + yz[s] * u.z,
            xz[s] * u.x + yz[s] * u.y + zz[s] * u.z};
}

}  // namespace

AssembledSprings::AssembledSprings(const SpringNetwork& network, std::vector<Vec3d> places,
                                   InstructionSet set)
    : functions_(assembled_functions(set)) {
    graph_.places = std::move(places);
    for (const double w : network.inverse_masses) graph_.takes_part.push_back(w > 0.0);
    set_springs(network);
    const std::size_t rows = block_lanes * pattern_.slices();
    x_ = LineAligned<double>(4 * rows);
    u_ = LineAligned<double>(4 * rows);
    product_ = LineAligned<double>(4 * rows);
    sums_.resize((rows + block_slots - 1) / block_slots);
}

void AssembledSprings::set_springs(const SpringNetwork& network) {
    std::vector<Coupling> couplings;
    std::vector<const SpringNetwork::Spring*> springs;  // [coupling]
    std::vector<std::size_t> edges;                     // [edge], one of its couplings
    for (const SpringNetwork::Spring& s : network.springs) {
        const auto [p, q] = is_free(s.p) ? std::pair{s.p, s.q} : std::pair{s.q, s.p};
        if (!is_free(p) || p == q) continue;
        // Without stiffness at all, dashpots say what hangs together.
        graph_.edges.push_back({p, q, s.stiffness > 0.0 ? s.stiffness : s.damping});
        edges.push_back(couplings.size());
        couplings.push_back({p, q});
        springs.push_back(&s);
        if (!is_free(q)) continue;
        couplings.push_back({q, p});
        springs.push_back(&s);
    }
    pattern_ = BlockPattern(graph_.rows(), couplings);
    const std::size_t places = block_lanes * pattern_.vectors();
    rest_lengths_ = LineAligned<double>(places);
    stiffnesses_ = LineAligned<double>(places);
    dampings_ = LineAligned<double>(places);
    for (std::size_t c = 0; c < couplings.size(); ++c) {
        rest_lengths_[pattern_.place(c)] = springs[c]->rest_length;
        stiffnesses_[pattern_.place(c)] = springs[c]->stiffness;
        dampings_[pattern_.place(c)] = springs[c]->damping;
    }
    for (const std::size_t c : edges) {
        edge_places_.push_back(static_cast<std::uint32_t>(pattern_.place(c)));
    }
}

AssembledPass AssembledSprings::pass() const {
    AssembledPass pass;
    pass.starts = pattern_.starts();
    pass.columns = pattern_.columns();
    pass.rest_lengths = rest_lengths_.data();
    pass.stiffnesses = stiffnesses_.data();
    pass.dampings = dampings_.data();
    pass.inverse_tau = inverse_tau_;
    pass.x = x_.data();
    return pass;
}

void AssembledSprings::linearise(ConstVec3View<double> x, double inverse_tau,
                                 const SymmetricBlocks<double>& blocks) {
    copy_rows(x, x_);
    inverse_tau_ = inverse_tau;
    blocks_ = &blocks;
}

void AssembledSprings::assemble(BlockMatrix& a) const {
    AssembledPass assembling = pass();
    assembling.couplings = a.couplings.data();
    const std::size_t rows = graph_.rows();
    parallel_for(pattern_.slices(), slice_grain, [&](std::size_t begin, std::size_t end) {
        functions_.assemble(assembling, begin, end);
        for (std::size_t n = 0; n < 6; ++n) {
            const double* const entry = blocks_->entries[n].data();
            for (std::size_t s = begin * block_lanes; s < std::min(end * block_lanes, rows); ++s) {
                const std::size_t slice = s / block_lanes, lane = s % block_lanes;
                a.own[(6 * slice + n) * block_lanes + lane] =
                    graph_.takes_part[s] != 0 ? static_cast<float>(entry[s]) : 0.0f;
            }
        }
    });
}

template <typename Value>
double AssembledSprings::set_free(Vec3View<double> out, const Value& value) {
    constexpr std::size_t grain = 8;
    parallel_for(sums_.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
            const std::size_t last = std::min((block + 1) * block_slots, out.size);
            double sum = 0.0;
            for (std::size_t s = block * block_slots; s < last; ++s) {
                const Vec3d v = is_free(s) ? value(s) : Vec3d{};
                out.set(s, v);
                sum += dot(v, v);
            }
            sums_[block] = sum;
        }
    });
    double sum = 0.0;
    for (const double block : sums_) sum += block;
    return std::sqrt(sum);
}

double AssembledSprings::residual(ConstVec3View<double> r, ConstVec3View<double> d,
                                  Vec3View<double> out) {
    copy_rows(d, u_);
    AssembledPass multiplying = pass();
    multiplying.u = u_.data();
    multiplying.out = product_.data();
    parallel_for(pattern_.slices(), slice_grain, [&](std::size_t begin, std::size_t end) {
        functions_.product(multiplying, begin, end);
    });
    return set_free(out, [&](std::size_t s) {
        const Vec3d springs{product_[4 * s], product_[4 * s + 1], product_[4 * s + 2]};
        return r[s] - block_times(*blocks_, s, d[s]) - springs;
    });
}

double AssembledSprings::masked(ConstVec3View<double> r, Vec3View<double> out) {
    return set_free(out, [&](std::size_t s) { return r[s]; });
}

}  // namespace weft
