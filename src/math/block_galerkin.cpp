#include "math/block_galerkin.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/parallel.h"

namespace weft {

namespace {

constexpr double negligible = 1e-9;       // beside weights of a prolongation, which are about 1
constexpr std::size_t chunk_rows = 4096;  // of whose coarse blocks a core's cache holds the sums

struct Weight {
    std::uint32_t column = 0;
    double value = 0.0;
};

void add_row(const Prolongation& p, std::size_t row, double sign, std::vector<Weight>& weights) {
    for (std::size_t n = p.starts[row]; n < p.starts[row + 1]; ++n) {
        const auto at = std::find_if(weights.begin(), weights.end(),
                                     [&](const Weight& w) { return w.column == p.columns[n]; });
        if (at != weights.end()) {
            at->value += sign * p.weights[n];
        } else {
            weights.push_back({p.columns[n], sign * p.weights[n]});
        }
    }
}

// A block whose numbers stand block_lanes apart, as a record.
void read_block(const float* from, BlockForm form, float* record) {
    constexpr std::size_t next = block_lanes;
    if (form == BlockForm::symmetric) {
        for (std::size_t n = 0; n < 6; ++n) record[n] = from[n * next];
        return;
    }
    const float a = from[0], x = from[next], y = from[2 * next], z = from[3 * next];
    record[0] = a + x * x, record[1] = x * y, record[2] = x * z;
    record[3] = a + y * y, record[4] = y * z, record[5] = a + z * z;
}

const float* block_at(const float* blocks, std::size_t place, std::size_t size) {
    return blocks + place / block_lanes * size * block_lanes + place % block_lanes;
}

}  // namespace

// What the sources add, chunk by chunk, while it is found.
class BlockGalerkin::Builder {
public:
    Builder(BlockGalerkin& galerkin, const RowGraph& graph, const Prolongation& p)
        : g_(galerkin), graph_(graph), p_(p), known_(p.coarse_rows) {}

    void build(std::span<const std::uint32_t> places);
    // [target] the fine edges' weights times theirs.
    [[nodiscard]] std::span<const double> weights() const { return weights_; }

private:
    struct Known {
        std::uint32_t column = 0, target = 0;
    };

    void begin_chunk() {
        g_.chunks_.push_back(
            {g_.sources_.size(), g_.sources_.size(), g_.terms_.size(), sum_targets_.size()});
    }
    void add_source(std::uint32_t place, double edge_weight);
    void add_term(std::uint32_t row, std::uint32_t column, double weight, double edge_weight);
    std::uint32_t target_of(std::uint32_t row, std::uint32_t column);
    void set_parts();

    BlockGalerkin& g_;
    const RowGraph& graph_;
    const Prolongation& p_;
    std::vector<Weight> row_;                 // of the source at hand
    std::vector<std::vector<Known>> known_;   // [coarse row]
    std::vector<double> weights_;             // [target]
    std::vector<std::uint32_t> last_sums_;    // [target], its latest sum
    std::vector<std::uint32_t> sum_targets_;  // [sum]
};

std::uint32_t BlockGalerkin::Builder::target_of(std::uint32_t row, std::uint32_t column) {
    for (const Known& k : known_[row]) {
        if (k.column == column) return k.target;
    }
    const auto target = static_cast<std::uint32_t>(g_.targets_.size());
    known_[row].push_back({column, target});
    g_.targets_.push_back({row, column, 0, 0});
    weights_.push_back(0.0);
    last_sums_.push_back(0);
    return target;
}

void BlockGalerkin::Builder::add_term(std::uint32_t row, std::uint32_t column, double weight,
                                      double edge_weight) {
    if (std::abs(weight) <= negligible) return;
    const std::uint32_t target = target_of(row, column);
    weights_[target] += weight * edge_weight;
    std::uint32_t& sum = last_sums_[target];
    if (sum < g_.chunks_.back().sums || sum >= sum_targets_.size() || sum_targets_[sum] != target) {
        sum = static_cast<std::uint32_t>(sum_targets_.size());
        sum_targets_.push_back(target);
    }
    g_.terms_.push_back({sum, static_cast<float>(weight)});
    ++g_.sources_.back().terms;
}

// With w the difference of the two rows' weights, an edge's K adds w_I w_J K to the coarse matrix's
// block (I, J); a row's B does so with w the row's weights. The coarse K_IJ is minus that block,
// and the coarse B_I the sum of row I's.
void BlockGalerkin::Builder::add_source(std::uint32_t place, double edge_weight) {
    g_.sources_.push_back({place, 0});
    double sum = 0.0;
    for (const Weight& w : row_) sum += w.value;
    for (const Weight& i : row_) {
        add_term(i.column, i.column, i.value * sum, edge_weight);
        for (const Weight& j : row_) {
            if (i.column < j.column) add_term(i.column, j.column, -i.value * j.value, edge_weight);
        }
    }
    if (g_.sources_.back().terms == 0) g_.sources_.pop_back();
    row_.clear();
}

void BlockGalerkin::Builder::build(std::span<const std::uint32_t> places) {
    std::vector<std::uint32_t> order(graph_.edges.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto chunk_of = [&](std::uint32_t e) { return graph_.edges[e].p / chunk_rows; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return chunk_of(a) != chunk_of(b) ? chunk_of(a) < chunk_of(b) : places[a] < places[b];
    });
    auto edge = order.begin();
    for (std::size_t first = 0; first < graph_.rows(); first += chunk_rows) {
        begin_chunk();
        for (; edge != order.end() && chunk_of(*edge) == first / chunk_rows; ++edge) {
            const RowGraph::Edge& e = graph_.edges[*edge];
            add_row(p_, e.p, 1.0, row_);
            add_row(p_, e.q, -1.0, row_);
            add_source(places[*edge], e.weight);
        }
        g_.chunks_.back().rows = g_.sources_.size();
        for (std::size_t row = first; row < std::min(first + chunk_rows, graph_.rows()); ++row) {
            add_row(p_, row, 1.0, row_);
            add_source(static_cast<std::uint32_t>(row), 0.0);
        }
    }
    begin_chunk();
    set_parts();
}

void BlockGalerkin::Builder::set_parts() {
    std::vector<std::uint32_t>& starts = g_.parts_starts_;
    starts.assign(g_.targets_.size() + 1, 0);
    for (const std::uint32_t target : sum_targets_) ++starts[target + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    g_.parts_.resize(sum_targets_.size());
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (std::size_t sum = 0; sum < sum_targets_.size(); ++sum) {
        g_.parts_[next[sum_targets_[sum]]++] = static_cast<std::uint32_t>(sum);
    }
    g_.sums_ = LineAligned<float>(record_size * sum_targets_.size());
}

BlockGalerkin::BlockGalerkin(const RowGraph& graph, std::span<const std::uint32_t> places,
                             const Prolongation& prolongation) {
    Builder builder(*this, graph, prolongation);
    builder.build(places);
    set_coarse(builder.weights(), prolongation);
}

void BlockGalerkin::set_coarse(std::span<const double> weights, const Prolongation& prolongation) {
    coarse_.takes_part.assign(prolongation.coarse_rows, 1);
    coarse_.places = prolongation.places;
    std::vector<Coupling> couplings;
    for (std::size_t t = 0; t < targets_.size(); ++t) {
        const Target& target = targets_[t];
        if (target.row == target.column) continue;
        couplings.push_back({target.row, target.column});
        couplings.push_back({target.column, target.row});
        coarse_.edges.push_back({target.row, target.column, std::max(weights[t], 0.0)});
    }
    pattern_ = BlockPattern(prolongation.coarse_rows, couplings);
    std::size_t c = 0;
    for (Target& target : targets_) {
        if (target.row == target.column) continue;
        target.place = static_cast<std::uint32_t>(pattern_.place(c++));
        target.mirror = static_cast<std::uint32_t>(pattern_.place(c++));
        places_.push_back(target.place);
    }
}

using BlockRecord = Eigen::Array<float, 8, 1>;

// Batches of blocks are read first, then added: a vector read right after its numbers were stored
// one by one would wait for them.
template <typename ReadBlock>
const BlockGalerkin::Term* BlockGalerkin::add_sources(std::size_t begin, std::size_t end,
                                                      const Term* term, const ReadBlock& read) {
    constexpr std::size_t batch = 64;
    alignas(64) float blocks[batch * record_size] = {};
    for (std::size_t first = begin; first < end; first += batch) {
        const std::size_t count = std::min(batch, end - first);
        for (std::size_t n = 0; n < count; ++n) {
            read(sources_[first + n].place, blocks + record_size * n);
        }
        for (std::size_t n = 0; n < count; ++n) {
            const BlockRecord k = Eigen::Map<const BlockRecord>(blocks + record_size * n);
            for (const Term* const last = term + sources_[first + n].terms; term != last; ++term) {
                Eigen::Map<BlockRecord, Eigen::Aligned32> sum(sums_.data() +
                                                              record_size * term->sum);
                sum += term->weight * k;
            }
        }
    }
    return term;
}

void BlockGalerkin::add_up(const BlockMatrix& fine, std::size_t chunk) {
    const Chunk& begin = chunks_[chunk];
    const Chunk& end = chunks_[chunk + 1];
    std::fill(sums_.data() + record_size * begin.sums, sums_.data() + record_size * end.sums, 0.0f);
    const Term* term = terms_.data() + begin.terms;
    const std::size_t size = static_cast<std::size_t>(fine.form);
    term = add_sources(begin.couplings, begin.rows, term, [&](std::size_t place, float* record) {
        read_block(block_at(fine.couplings.data(), place, size), fine.form, record);
    });
    add_sources(begin.rows, end.couplings, term, [&](std::size_t row, float* record) {
        read_block(block_at(fine.own.data(), row, 6), BlockForm::symmetric, record);
    });
}

void BlockGalerkin::compute(const BlockMatrix& fine, BlockMatrix& coarse) {
    parallel_for(chunks_.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t chunk = begin; chunk < end; ++chunk) add_up(fine, chunk);
    });
    constexpr std::size_t grain = 4096;
    parallel_for(targets_.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            BlockRecord sum = BlockRecord::Zero();
            for (std::size_t n = parts_starts_[t]; n < parts_starts_[t + 1]; ++n) {
                sum += Eigen::Map<const BlockRecord, Eigen::Aligned32>(sums_.data() +
                                                                       record_size * parts_[n]);
            }
            const SymmetricBlock block{sum[0], sum[1], sum[2], sum[3], sum[4], sum[5]};
            if (targets_[t].row == targets_[t].column) {
                coarse.set_own(targets_[t].row, block);
            } else {
                coarse.set_coupling(targets_[t].place, block);
                coarse.set_coupling(targets_[t].mirror, block);
            }
        }
    });
}

}  // namespace weft
