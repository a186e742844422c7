// Kernels of a grid's multigrid solver (forces/grid_multigrid.h): what is done with Newton's matrix
//     A = B + sum over springs of (k (n n^T + max(0, 1 - L/l) (I - n n^T)) + c / tau n n^T)
// on one level, and what passes between levels. All in float; arrays by slot of the level's layout,
// zero in padding.
//
// Products sweep over rows as forces/linear_pass.h does, spring by spring from the positions: each
// row looks only at itself and the two rows below, so that a smoothing sweep may write its result
// over its operand. What springs put on rows below waits in line buffers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cloth/grid_cloth.h"
#include "math/instruction_sets.h"
#include "math/vec3_array.h"

namespace weft {

/// What the springs of a family have in common along a row.
struct NewtonSpring {
    float stiffness = 0;    ///< k [N/m]
    float rest_length = 0;  ///< L [m]
    float damping = 0;      ///< c [N s/m]
};

/// The constants of all families along a row.
struct NewtonRow {
    using Families = std::array<NewtonSpring, grid_family_count>;
    Families inner;  ///< away from the left and right border
    Families edge;   ///< near them: to be multiplied by the column's factor
};

/// A on one level; pointers belong to others.
struct NewtonGrid {
    std::size_t columns = 0, rows = 0, stride = 0;
    std::array<NewtonRow, 6> row_constants;                        ///< by row_kind()
    std::array<const float*, grid_family_count> column_factors{};  ///< [stride], 0: no spring
    bool left_edge = false;  ///< column 0 differs from the inner ones
    float inverse_tau = 0;   ///< 1 / tau [1/s]
    bool isotropic = true;   ///< B is a multiple of the identity at every particle
    ConstVec3View<float> x;  ///< positions [m]
    /// B: xx, xy, xz, yy, yz, zz [slot]; isotropic: only the first is read. xx = 0: pinned or
    /// padding.
    std::array<const float*, 6> blocks{};
    /// A's diagonal blocks D as L diag(d) L^T: 1/d0, 1/d1, 1/d2, L10, L20, L21 [slot]; zero where
    /// pinned.
    std::array<float*, 6> factors{};

    /// Border row or not, and whether 0, 1, 2 or more rows lie below.
    [[nodiscard]] std::size_t row_kind(std::size_t j) const {
        const std::size_t below = rows - 1 - j;
        return 2 * (below < 2 ? below : 2) + (j == 0 || below == 0 ? 1 : 0);
    }
};

/// A band of rows and its scratch memory.
struct NewtonBand {
    static constexpr std::size_t sum_lines = 18;              ///< three rows of six components
    static constexpr std::size_t line_count = sum_lines + 1;  ///< and what transfers combine
    static constexpr std::size_t margin = 16;  ///< floats before that one, zero as those behind it

    std::size_t row_begin = 0, row_end = 0;
    float* lines = nullptr;  ///< [line_count][line_stride(stride)]

    /// Never whole pages of 4 KiB, or the lines would share one set of the first-level cache.
    static constexpr std::size_t line_stride(std::size_t stride) {
        const std::size_t room = stride + 5 * margin;
        return room % 1024 == 0 ? room + margin : room;
    }
    /// The transfers' line.
    [[nodiscard]] float* transfer_line(std::size_t stride) const {
        return lines + sum_lines * line_stride(stride) + margin;
    }
};

/// How one direction of a level hangs together with the next coarser one. Fine node i stands at
/// coarse co-ordinate i (coarse - 1) / (fine - 1), between nodes `left` and left + 1. Tables go on
/// with zeros to whole cache lines.
struct NewtonTransferAxis {
    static constexpr std::size_t taps = 5;  ///< fine nodes between the neighbours of a coarse node

    std::size_t fine = 0, coarse = 0;        ///< nodes; the same: this direction is not coarsened
    const std::int32_t* left = nullptr;      ///< [fine]
    const float* weight = nullptr;           ///< [fine], of node left + 1
    const std::int32_t* first = nullptr;     ///< [coarse], the first fine node
    std::array<const float*, taps> taken{};  ///< [coarse], the weight of fine node first + n

    /// Every second fine node is a coarse one: the tables need not be read.
    [[nodiscard]] bool halves() const { return fine + 1 == 2 * coarse; }
};

struct NewtonTransfer {
    NewtonTransferAxis across, down;
    std::size_t fine_stride = 0, coarse_stride = 0;
};

/// The kernels for one instruction set, each for the rows of a band. Sums are those of each row:
/// [rows].
struct NewtonKernels {
    using Field = Vec3View<float>;
    using ConstField = ConstVec3View<float>;

    /// The factors of D, from B and the springs.
    void (*factor)(const NewtonGrid&, const NewtonBand&);
    /// out = A u; sums: u.out.
    void (*product)(const NewtonGrid&, const NewtonBand&, ConstField u, Field out, double* sums);
    /// out = b - A u.
    void (*residual)(const NewtonGrid&, const NewtonBand&, ConstField u, ConstField b, Field out);
    /// out = u + omega D^-1 (b - A u); sums: b.out. `out` may be u where one band is the whole
    /// grid, but not with the twins.
    void (*smooth)(const NewtonGrid&, const NewtonBand&, float omega, ConstField u, ConstField b,
                   Field out, double* sums);
    /// out = omega D^-1 b.
    void (*start)(const NewtonGrid&, const NewtonBand&, float omega, ConstField b, Field out);

    /// coarse = P^T fine of one component, on coarse rows.
    void (*coarsen)(const NewtonTransfer&, const NewtonBand&, const float* fine, float* coarse);
    /// fine += P coarse of one component, on fine rows, where blocks > 0.
    void (*interpolate)(const NewtonTransfer&, const NewtonBand&, const float* coarse,
                        const float* blocks, float* fine);

    // Of conjugate gradients: on elements [begin, end), whole cache lines.
    /// to = scale from where blocks > 0, else zero; returns to.to.
    double (*narrow)(double scale, const double* from, const float* blocks, float* to,
                     std::size_t begin, std::size_t end);
    /// x += alpha p, r -= alpha q; returns the new r.r.
    double (*advance)(float alpha, const float* p, const float* q, float* x, float* r,
                      std::size_t begin, std::size_t end);
    /// p = z + beta p
    void (*turn)(float beta, const float* z, float* p, std::size_t begin, std::size_t end);
};

/// @return for scalar: the readable twins.
const NewtonKernels& newton_kernels(InstructionSet set);

extern const NewtonKernels newton_twins;

}  // namespace weft
