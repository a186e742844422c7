// Random matrices of math/block_matrix.h, and the same as dense ones.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <vector>

#include "math/aggregates.h"
#include "math/block_matrix.h"
#include "math/random.h"

namespace weft::test {

inline double signed_random(std::uint64_t seed, std::uint64_t stream, std::size_t n) {
    return 2.0 * random_uniform(seed, stream, n) - 1.0;
}

inline Vec3d random_direction(std::uint64_t seed, std::uint64_t stream, std::size_t n) {
    return {signed_random(seed, 3 * stream, n), signed_random(seed, 3 * stream + 1, n),
            signed_random(seed, 3 * stream + 2, n)};
}

/// A sheet of rows joined to those beside, below and across, some to a far one; every seventh is
/// held. Rows have between none and many couplings.
struct BlockExample {
    RowGraph graph;
    BlockPattern pattern;
    std::vector<std::uint32_t> places;  ///< [edge]
    BlockMatrix matrix;

    BlockExample(std::size_t columns, std::size_t rows, BlockForm form, bool with_held = true,
                 double own_size = 0.1) {
        set_graph(columns, rows, with_held);
        std::vector<Coupling> couplings;
        std::vector<std::size_t> edge_of, first;
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            const RowGraph::Edge& edge = graph.edges[e];
            first.push_back(couplings.size());
            couplings.push_back({edge.p, edge.q});
            edge_of.push_back(e);
            if (graph.takes_part[edge.q] == 0) continue;
            couplings.push_back({edge.q, edge.p});
            edge_of.push_back(e);
        }
        pattern = BlockPattern(graph.rows(), couplings);
        for (const std::size_t c : first) {
            places.push_back(static_cast<std::uint32_t>(pattern.place(c)));
        }
        matrix = BlockMatrix(pattern, form);
        for (std::size_t c = 0; c < couplings.size(); ++c) {
            set_coupling(pattern.place(c), edge_of[c]);
        }
        for (std::size_t row = 0; row < graph.rows(); ++row) {
            if (graph.takes_part[row] != 0) matrix.set_own(row, positive_block(row, own_size));
        }
    }
    BlockExample(const BlockExample&) = delete;

    /// A, with ones on the diagonal of what does not take part.
    [[nodiscard]] Eigen::MatrixXd dense() const;

private:
    void set_graph(std::size_t columns, std::size_t rows, bool with_held);
    void set_coupling(std::size_t place, std::size_t edge);
    static SymmetricBlock positive_block(std::size_t n, double size) {
        const Vec3d g = random_direction(11, 0, n);
        return {size + g.x * g.x, g.x * g.y, g.x * g.z,
                size + g.y * g.y, g.y * g.z, size + g.z * g.z};
    }
};

inline void BlockExample::set_graph(std::size_t columns, std::size_t rows, bool with_held) {
    const std::size_t count = columns * rows;
    for (std::size_t n = 0; n < count; ++n) {
        graph.takes_part.push_back(!with_held || n % 7 != 3);
        graph.places.push_back(
            {static_cast<double>(n % columns), static_cast<double>(n / columns), 0.0});
    }
    const auto join = [&](std::size_t a, std::size_t b, double weight) {
        if (a == b || (graph.takes_part[a] == 0 && graph.takes_part[b] == 0)) return;
        if (graph.takes_part[a] == 0) std::swap(a, b);
        graph.edges.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), weight});
    };
    for (std::size_t n = 0; n < count; ++n) {
        const bool right = (n + 1) % columns != 0, down = n + columns < count;
        if (right) join(n, n + 1, 1.0);
        if (down) join(n, n + columns, 1.0);
        if (right && down) join(n, n + columns + 1, 0.5);
        if (n % 23 == 5) join(n, (n * 17) % count, 0.5);
    }
}

inline void BlockExample::set_coupling(std::size_t place, std::size_t edge) {
    const double weight = graph.edges[edge].weight;
    const Vec3d g = std::sqrt(weight) * random_direction(5, 1, edge);
    if (matrix.form == BlockForm::spring) {
        matrix.set_spring(place, 0.3 * weight, g);
    } else {
        SymmetricBlock k = positive_block(edge + 1000, 0.3);
        for (double* number : {&k.xx, &k.xy, &k.xz, &k.yy, &k.yz, &k.zz}) *number *= weight;
        matrix.set_coupling(place, k);
    }
}

inline Eigen::Matrix3d dense_block(const SymmetricBlock& s) {
    Eigen::Matrix3d block;
    block << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    return block;
}

inline Eigen::MatrixXd BlockExample::dense() const {
    const auto size = static_cast<Eigen::Index>(3 * graph.rows());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
    const auto at = [](std::size_t row) { return static_cast<Eigen::Index>(3 * row); };
    for (std::size_t row = 0; row < graph.rows(); ++row) {
        const Eigen::Index r = at(row);
        a.block<3, 3>(r, r) += graph.takes_part[row] != 0 ? dense_block(matrix.own_block(row))
                                                          : Eigen::Matrix3d::Identity();
    }
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const Eigen::Index p = at(graph.edges[e].p), q = at(graph.edges[e].q);
        const Eigen::Matrix3d k = dense_block(matrix.coupling(places[e]));
        a.block<3, 3>(p, p) += k;
        if (graph.takes_part[graph.edges[e].q] == 0) continue;
        a.block<3, 3>(q, q) += k;
        a.block<3, 3>(p, q) -= k;
        a.block<3, 3>(q, p) -= k;
    }
    return a;
}

/// Uniform in [-1, 1] where rows take part, zero elsewhere.
inline BlockVector random_block_vector(const RowGraph& graph, std::size_t slices,
                                       std::uint64_t seed) {
    BlockVector v(slices, true);
    for (std::size_t row = 0; row < graph.rows(); ++row) {
        if (graph.takes_part[row] != 0) v.set(row, random_direction(seed, 2, row));
    }
    return v;
}

inline Eigen::VectorXd as_dense(const BlockVector& v, std::size_t rows) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(3 * rows));
    for (std::size_t row = 0; row < rows; ++row) {
        const Vec3d value = v[row];
        result.segment<3>(static_cast<Eigen::Index>(3 * row)) << value.x, value.y, value.z;
    }
    return result;
}

}  // namespace weft::test
