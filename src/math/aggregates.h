// The coarse rows of smoothed aggregation (Vanek, Mandel and Brezina, Computing 56, 1996): groups
// of strongly joined rows, and how a coarse vector spreads over them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "weft/vec3.h"

namespace weft {

/// Rows joined by springs: all that coarsening looks at.
struct RowGraph {
    /// Between rows p, which takes part, and q, which may be held.
    struct Edge {
        std::uint32_t p = 0, q = 0;
        double weight = 0.0;  ///< stiffness, not negative
    };
    std::vector<char> takes_part;  ///< [row]
    std::vector<Vec3d> places;     ///< [row], where rows stand to one another
    std::vector<Edge> edges;

    [[nodiscard]] std::size_t rows() const { return takes_part.size(); }
};

/// u_i = sum of weights times coarse u_J, the same for all three components. Rows that are held,
/// or joined to nothing, have no weights.
struct Prolongation {
    std::size_t coarse_rows = 0;
    std::vector<std::uint32_t> starts;  ///< [row + 1]
    std::vector<std::uint32_t> columns;
    std::vector<double> weights;
    std::vector<Vec3d> places;  ///< [coarse row], the middle of an aggregate
};

/// Aggregates of rows joined by springs of more than `least_strength` of what joins either to all
/// others, each row's weights smoothed by one step of Jacobi on the graph's Laplacian, then changed
/// as little as makes the row's place the weighted mean of its aggregates': coarse vectors can then
/// turn and stretch the cloth, as the matrix's soft modes do.
Prolongation prolongation_of(const RowGraph& graph, double least_strength);

}  // namespace weft
