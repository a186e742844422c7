#include "math/block_galerkin.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "math/parallel.h"

namespace weft {

// Of a source to the coarse block (row, column).
struct BlockGalerkin::Contribution {
    std::uint32_t row = 0, column = 0, source = 0;
    double weight = 0.0;
};

namespace {

constexpr double negligible = 1e-9;  // beside weights of a prolongation, which are about 1

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

}  // namespace

// With w the difference of the two rows' weights, an edge's K adds w_I w_J K to the coarse matrix's
// block (I, J); a row's B does so with w the row's weights. The coarse K_IJ is minus that block,
// and the coarse B_I the sum of row I's.
std::vector<BlockGalerkin::Contribution> BlockGalerkin::contributions(const RowGraph& graph,
                                                                      const Prolongation& p) const {
    std::vector<Contribution> result;
    std::vector<Weight> weights;
    const auto add_all = [&](std::uint32_t source) {
        double sum = 0.0;
        for (const Weight& w : weights) sum += w.value;
        for (const Weight& i : weights) {
            if (std::abs(i.value * sum) > negligible) {
                result.push_back({i.column, i.column, source, i.value * sum});
            }
            for (const Weight& j : weights) {
                if (i.column >= j.column || std::abs(i.value * j.value) <= negligible) continue;
                result.push_back({i.column, j.column, source, -i.value * j.value});
            }
        }
        weights.clear();
    };
    for (std::size_t e = 0; e < edge_count_; ++e) {
        add_row(p, graph.edges[e].p, 1.0, weights);
        add_row(p, graph.edges[e].q, -1.0, weights);
        add_all(static_cast<std::uint32_t>(e));
    }
    for (std::size_t row = 0; row < graph.rows(); ++row) {
        add_row(p, row, 1.0, weights);
        add_all(static_cast<std::uint32_t>(edge_count_ + row));
    }
    return result;
}

// By row, column and source: by counting rows, which leaves little to sort.
std::vector<BlockGalerkin::Contribution> BlockGalerkin::by_target(
    const std::vector<Contribution>& all, std::size_t rows) {
    std::vector<std::size_t> starts(rows + 1, 0);
    for (const Contribution& c : all) ++starts[c.row + 1];
    for (std::size_t row = 0; row < rows; ++row) starts[row + 1] += starts[row];
    std::vector<Contribution> sorted(all.size());
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (const Contribution& c : all) sorted[next[c.row]++] = c;
    const auto at = [&](std::size_t n) { return sorted.begin() + static_cast<std::ptrdiff_t>(n); };
    for (std::size_t row = 0; row < rows; ++row) {
        std::sort(at(starts[row]), at(starts[row + 1]),
                  [](const Contribution& a, const Contribution& b) {
                      return a.column != b.column ? a.column < b.column : a.source < b.source;
                  });
    }
    return sorted;
}

BlockGalerkin::BlockGalerkin(const RowGraph& graph, std::span<const std::uint32_t> places,
                             const Prolongation& prolongation)
    : edge_count_(graph.edges.size()),
      source_places_(places.begin(), places.end()),
      sources_(record_size * (graph.edges.size() + graph.rows())) {
    std::vector<Contribution> all =
        by_target(contributions(graph, prolongation), prolongation.coarse_rows);
    set_targets(all);
    set_coarse(graph, prolongation);
}

void BlockGalerkin::set_targets(const std::vector<Contribution>& sorted) {
    for (const Contribution& c : sorted) {
        if (targets_.empty() || targets_.back().row != c.row ||
            targets_.back().column != c.column) {
            targets_.push_back({c.row, c.column, 0, 0});
            starts_.push_back(static_cast<std::uint32_t>(terms_.size()));
        }
        terms_.push_back({c.source, static_cast<float>(c.weight)});
    }
    starts_.push_back(static_cast<std::uint32_t>(terms_.size()));
}

void BlockGalerkin::set_coarse(const RowGraph& graph, const Prolongation& prolongation) {
    coarse_.takes_part.assign(prolongation.coarse_rows, 1);
    coarse_.places = prolongation.places;
    std::vector<Coupling> couplings;
    for (std::size_t t = 0; t < targets_.size(); ++t) {
        const Target& target = targets_[t];
        if (target.row == target.column) continue;
        couplings.push_back({target.row, target.column});
        couplings.push_back({target.column, target.row});
        double weight = 0.0;
        for (std::size_t n = starts_[t]; n < starts_[t + 1]; ++n) {
            if (terms_[n].source >= edge_count_) continue;
            weight += static_cast<double>(terms_[n].weight) * graph.edges[terms_[n].source].weight;
        }
        coarse_.edges.push_back({target.row, target.column, std::max(weight, 0.0)});
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

void BlockGalerkin::read_sources(const BlockMatrix& fine) {
    constexpr std::size_t grain = 8192;
    const std::size_t size = static_cast<std::size_t>(fine.form);
    parallel_for(edge_count_, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
            const std::size_t place = source_places_[e];
            const float* const from =
                fine.couplings.data() + place / block_lanes * size * block_lanes;
            read_block(from + place % block_lanes, fine.form, sources_.data() + record_size * e);
        }
    });
    float* const rows = sources_.data() + record_size * edge_count_;
    parallel_for(fine.pattern->rows(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const float* const from = fine.own.data() + row / block_lanes * 6 * block_lanes;
            read_block(from + row % block_lanes, BlockForm::symmetric, rows + record_size * row);
        }
    });
}

void BlockGalerkin::compute(const BlockMatrix& fine, BlockMatrix& coarse) {
    read_sources(fine);
    using Record = Eigen::Array<float, record_size, 1>;
    constexpr std::size_t grain = 1024;
    parallel_for(targets_.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            Record sum = Record::Zero();
            for (std::size_t n = starts_[t]; n < starts_[t + 1]; ++n) {
                const float* const source = sources_.data() + record_size * terms_[n].source;
                sum += terms_[n].weight * Eigen::Map<const Record, Eigen::Aligned32>(source);
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
