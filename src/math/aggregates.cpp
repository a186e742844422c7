#include "math/aggregates.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

constexpr std::uint32_t none = 0xffffffff;

// A row's strong neighbours, held ones left out, and what joins it to all.
struct StrongGraph {
    struct Neighbour {
        std::uint32_t row = 0;
        double weight = 0.0;
    };
    std::vector<std::uint32_t> starts;  // [row + 1]
    std::vector<Neighbour> neighbours;
    std::vector<double> totals;  // [row], of strong edges, to held rows too

    [[nodiscard]] auto begin(std::size_t row) const {
        return neighbours.begin() + static_cast<std::ptrdiff_t>(starts[row]);
    }
    [[nodiscard]] auto end(std::size_t row) const { return begin(row + 1); }
    [[nodiscard]] bool isolated(std::size_t row) const { return starts[row] == starts[row + 1]; }
};

StrongGraph strong_graph(const RowGraph& graph, double least_strength) {
    const std::size_t rows = graph.rows();
    std::vector<double> sums(rows, 0.0);
    for (const RowGraph::Edge& e : graph.edges) sums[e.p] += e.weight, sums[e.q] += e.weight;
    StrongGraph strong;
    strong.totals.assign(rows, 0.0);
    strong.starts.assign(rows + 1, 0);
    const auto for_strong = [&](const auto& visit) {
        for (const RowGraph::Edge& e : graph.edges) {
            if (!graph.takes_part[e.q]) {
                visit(e, true);
            } else if (e.weight > least_strength * std::sqrt(sums[e.p] * sums[e.q])) {
                visit(e, false);
            }
        }
    };
    for_strong([&](const RowGraph::Edge& e, bool held) {
        strong.totals[e.p] += e.weight;
        if (held) return;
        strong.totals[e.q] += e.weight;
        ++strong.starts[e.p + 1], ++strong.starts[e.q + 1];
    });
    for (std::size_t r = 0; r < rows; ++r) strong.starts[r + 1] += strong.starts[r];
    strong.neighbours.resize(strong.starts.back());
    std::vector<std::uint32_t> next(strong.starts.begin(), strong.starts.end() - 1);
    for_strong([&](const RowGraph::Edge& e, bool held) {
        if (held) return;
        strong.neighbours[next[e.p]++] = {e.q, e.weight};
        strong.neighbours[next[e.q]++] = {e.p, e.weight};
    });
    return strong;
}

// [row], which aggregate it belongs to: `none` where it is held or isolated.
struct Aggregates {
    std::uint32_t count = 0;
    std::vector<std::uint32_t> of_row;
};

// The three passes of Vanek, Mandel and Brezina's algorithm 2: whole neighbourhoods, then rows
// beside them, then what is left.
Aggregates aggregates_of(const StrongGraph& strong) {
    const std::size_t rows = strong.totals.size();
    Aggregates result{0, std::vector<std::uint32_t>(rows, none)};
    std::vector<std::uint32_t>& of_row = result.of_row;
    const auto found = [&](std::size_t row, std::uint32_t number, const auto& takes) {
        of_row[row] = number;
        for (auto n = strong.begin(row); n != strong.end(row); ++n) {
            if (takes(n->row)) of_row[n->row] = number;
        }
    };
    const auto is_free = [&](std::uint32_t row) { return of_row[row] == none; };
    for (std::size_t row = 0; row < rows; ++row) {
        if (strong.isolated(row) || !is_free(static_cast<std::uint32_t>(row))) continue;
        const bool alone = std::all_of(strong.begin(row), strong.end(row),
                                       [&](const auto& n) { return is_free(n.row); });
        if (alone) found(row, result.count++, is_free);
    }
    const std::vector<std::uint32_t> first = of_row;
    for (std::size_t row = 0; row < rows; ++row) {
        double best = 0.0;
        if (first[row] != none) continue;
        for (auto n = strong.begin(row); n != strong.end(row); ++n) {
            if (first[n->row] == none || n->weight <= best) continue;
            best = n->weight;
            of_row[row] = first[n->row];
        }
    }
    for (std::size_t row = 0; row < rows; ++row) {
        if (strong.isolated(row) || !is_free(static_cast<std::uint32_t>(row))) continue;
        found(row, result.count++, is_free);
    }
    return result;
}

std::vector<Vec3d> middles_of(const RowGraph& graph, const Aggregates& aggregates) {
    std::vector<Vec3d> middles(aggregates.count);
    std::vector<double> sizes(aggregates.count, 0.0);
    for (std::size_t row = 0; row < graph.rows(); ++row) {
        const std::uint32_t a = aggregates.of_row[row];
        if (a == none) continue;
        middles[a] += graph.places[row];
        sizes[a] += 1.0;
    }
    for (std::size_t a = 0; a < middles.size(); ++a) middles[a] = middles[a] / sizes[a];
    return middles;
}

// A row's columns and weights while they are made.
struct Row {
    std::vector<std::uint32_t> columns;
    std::vector<double> weights;

    void add(std::uint32_t column, double weight) {
        const auto at = std::find(columns.begin(), columns.end(), column);
        if (at != columns.end()) {
            weights[static_cast<std::size_t>(at - columns.begin())] += weight;
        } else {
            columns.push_back(column);
            weights.push_back(weight);
        }
    }
};

// Weights w + w_J (l0 + l.(X_J - x)) of the same sum, with the row's place x as their mean, where
// so small a change of them can do it: of all changes the least in sum (change^2 / w).
void reproduce_place(Row& row, Vec3d place, const std::vector<Vec3d>& middles) {
    Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
    for (std::size_t n = 0; n < row.columns.size(); ++n) {
        const Vec3d arm = middles[row.columns[n]] - place;
        const Eigen::Vector4d b{1.0, arm.x, arm.y, arm.z};
        moments += row.weights[n] * b * b.transpose();
    }
    const double spread = (moments.trace() - moments(0, 0)) / 3;
    if (!(spread > 0.0)) return;
    Eigen::Vector4d lacks = -moments.col(0);
    lacks[0] = 0.0;
    constexpr double least = 1e-3;  // of the spread: directions in which no aggregates lie
    for (int c = 1; c < 4; ++c) moments(c, c) += least * spread;
    const Eigen::Vector4d change = moments.ldlt().solve(lacks);
    std::vector<double> weights = row.weights;
    for (std::size_t n = 0; n < row.columns.size(); ++n) {
        const Vec3d arm = middles[row.columns[n]] - place;
        weights[n] *= 1 + change[0] + dot({change[1], change[2], change[3]}, arm);
        if (!(std::abs(weights[n]) < 2.0)) return;
    }
    row.weights = std::move(weights);
}

}  // namespace

Prolongation prolongation_of(const RowGraph& graph, double least_strength) {
    const StrongGraph strong = strong_graph(graph, least_strength);
    const Aggregates aggregates = aggregates_of(strong);
    Prolongation result;
    result.coarse_rows = aggregates.count;
    result.places = middles_of(graph, aggregates);
    result.starts = {0};
    constexpr double damping = 2.0 / 3.0;  // 4/3 over the Laplacian's bound of 2
    Row row;
    for (std::size_t r = 0; r < graph.rows(); ++r) {
        row.columns.clear();
        row.weights.clear();
        if (aggregates.of_row[r] != none) {
            row.add(aggregates.of_row[r], 1.0 - damping);
            for (auto n = strong.begin(r); n != strong.end(r); ++n) {
                row.add(aggregates.of_row[n->row], damping * n->weight / strong.totals[r]);
            }
            reproduce_place(row, graph.places[r], result.places);
        }
        result.columns.insert(result.columns.end(), row.columns.begin(), row.columns.end());
        result.weights.insert(result.weights.end(), row.weights.begin(), row.weights.end());
        result.starts.push_back(static_cast<std::uint32_t>(result.columns.size()));
    }
    return result;
}

}  // namespace weft
