// One level of a grid's multigrid solver: a sheet of springs, its matrix, and the fields that a
// V-cycle needs there.
#pragma once

#include <optional>
#include <vector>

#include "cloth/cloth_model.h"
#include "cloth/particle_layout.h"
#include "forces/grid_multigrid_transfer.h"
#include "forces/newton_matrix.h"
#include "forces/newton_pass.h"
#include "math/line_aligned.h"
#include "math/vec3_array.h"

namespace weft {

/// The springs and pins of a level.
struct MultigridSheet {
    std::size_t columns = 0, rows = 0;
    GridSpringFamilies families{};
    std::vector<bool> pinned;  ///< [row * columns + column]
};

MultigridSheet finest_sheet(const ClothModel& cloth);

/// The next coarser sheet, or nothing where the sheet is small enough to be solved directly.
/// Columns and rows are halved, or, where springs along them are much stiffer, one of them: errors
/// that point by point smoothing leaves are smooth in the stiff direction only. Rest lengths grow
/// as distances do. A strip as wide as a row's distance keeps its tension at unit strain, and a
/// cell its modulus of shear:
///     along a row  k' = k ry / rx,   shear  k' = k (dx dy / L^2) (L'^2 / (dx' dy')),
/// with rx, ry how much farther apart columns and rows become; springs along a border line also
/// take over those of the half strip that the line then stands for. A node is pinned where the
/// finer node nearest to it is.
std::optional<MultigridSheet> coarser_sheet(const MultigridSheet& sheet);

class MultigridLevel {
public:
    /// @param coarser the next level's sheet, if there is one.
    MultigridLevel(const MultigridSheet& sheet, const ClothModel& cloth,
                   const std::optional<MultigridSheet>& coarser, const NewtonKernels& kernels,
                   int threads);
    MultigridLevel(MultigridLevel&&) = default;

    /// Takes the matrix, on the finest level; positions are kept relative to the grid's middle.
    /// @param blocks B; of no meaning where particles are pinned.
    void set_matrix(ConstVec3View<double> positions, double inverse_tau,
                    const SymmetricBlocks<double>& blocks);
    /// Another level's, from the next finer one.
    void set_matrix(const MultigridLevel& finer);

    /// out = A u; returns u.out.
    double multiply(const Vec3Array<float>& operand, Vec3Array<float>& out);
    /// u = omega D^-1 b.
    void start(float omega);
    /// u += omega D^-1 (b - A u); returns b.u.
    double smooth(float omega);
    /// coarser.b = P^T (b - A u).
    void send_residual(MultigridLevel& coarser);
    /// u += P coarser.u.
    void add_correction(const MultigridLevel& coarser);

    [[nodiscard]] std::size_t columns() const { return grid_.columns; }
    [[nodiscard]] std::size_t rows() const { return grid_.rows; }
    [[nodiscard]] std::size_t slot(std::size_t i, std::size_t j) const {
        return j * grid_.stride + i;
    }
    /// [slot], more than zero where particles are free.
    [[nodiscard]] const float* free() const { return grid_.blocks[0]; }

    Vec3Array<float> b, u;  ///< what the V-cycle solves here: A u = b; zero where pinned

private:
    void set_family(const MultigridSheet& sheet, const SpringMaterial& material, std::size_t n);
    void set_pointers();
    void cut_bands(int threads, const std::optional<MultigridSheet>& coarser);
    void factor();
    void set_positions(ConstVec3View<double> positions);
    void set_blocks(const SymmetricBlocks<double>& blocks);
    [[nodiscard]] std::size_t entry_count() const { return grid_.isotropic ? 1 : 6; }
    [[nodiscard]] float* block(std::size_t entry);
    [[nodiscard]] double sum_of_rows() const;

    const NewtonKernels& kernels_;
    NewtonGrid grid_;
    std::array<std::vector<float>, grid_family_count> column_factors_;
    std::vector<float> free_;  // [slot], 1; pinned or padding: 0
    Vec3Array<float> x_, spare_;
    std::array<Vec3Array<float>, 2> blocks_, factors_;
    std::optional<MultigridTransfer> transfer_;
    std::vector<double> sums_;  // [row]
    std::vector<NewtonBand> bands_, coarse_bands_;
    LineAligned<float> lines_;  // scratch memory of the bands
};

}  // namespace weft
