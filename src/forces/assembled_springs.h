// The springs of a cloth as couplings between the free particles' rows, and Newton's matrix of them
// (forces/newton_matrix.h) at given positions.
#pragma once

#include <vector>

#include "cloth/spring_network.h"
#include "forces/assembled_newton_pass.h"
#include "forces/newton_matrix.h"
#include "math/aggregates.h"
#include "math/line_aligned.h"

namespace weft {

/// Rows are slots, those of pinned particles and padding held at zero.
class AssembledSprings {
public:
    /// @param places [slot], where particles are at rest [m].
    AssembledSprings(const SpringNetwork& network, std::vector<Vec3d> places, InstructionSet set);

    [[nodiscard]] const BlockPattern& pattern() const { return pattern_; }
    [[nodiscard]] bool is_free(std::size_t slot) const { return graph_.takes_part[slot] != 0; }

    /// The springs with a free end, and the place of each in the pattern.
    [[nodiscard]] const RowGraph& graph() const { return graph_; }
    [[nodiscard]] const std::vector<std::uint32_t>& edge_places() const { return edge_places_; }

    /// Takes what the matrix is made of; `blocks` must stay as they are.
    void linearise(ConstVec3View<double> x, double inverse_tau,
                   const SymmetricBlocks<double>& blocks);

    /// Couplings and own blocks, in float.
    /// @param a of pattern() and form spring.
    void assemble(BlockMatrix& a) const;

    /// out = r where free, and zero elsewhere.
    /// @return |out|
    double masked(ConstVec3View<double> r, Vec3View<double> out);

    /// out = r - A d in double, straight from the positions; zero where held.
    /// @return |out|
    double residual(ConstVec3View<double> r, ConstVec3View<double> d, Vec3View<double> out);

private:
    void set_springs(const SpringNetwork& network);
    /// Sets out to what value(slot) is where free, and to zero elsewhere.
    /// @return |out|
    template <typename Value>
    double set_free(Vec3View<double> out, const Value& value);
    [[nodiscard]] AssembledPass pass() const;

    AssembledFunctions functions_;
    RowGraph graph_;
    BlockPattern pattern_;
    std::vector<std::uint32_t> edge_places_;
    LineAligned<double> rest_lengths_, stiffnesses_, dampings_;  // [vector][lane]
    LineAligned<double> x_, u_, product_;                        // [slot][4]
    std::vector<double> sums_;                                   // [block]
    double inverse_tau_ = 0.0;
    const SymmetricBlocks<double>* blocks_ = nullptr;
};

}  // namespace weft
