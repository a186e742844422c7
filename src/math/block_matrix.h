// Symmetric sparse matrices of 3 x 3 blocks, written as springs between rows:
//     (A u)_i = B_i u_i + sum over couplings (i, j) of K_ij (u_i - u_j),
// that is A_ij = -K_ij and A_ii = B_i + sum_j K_ij. In float this keeps what a plain matrix loses:
// with stiff springs, light masses B are below the last place of A_ii, but not of B.
//
// A row without couplings and with B = 0 does not take part: what others couple to is held at zero.
//
// Sliced ELLPACK (Monakov, Lokhmotov and Avetisyan 2010): 16 rows make a slice, the n-th coupling
// of each stands in the slice's n-th vector. The layout is the same for all instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/line_aligned.h"
#include "weft/vec3.h"

namespace weft {

/// Rows, or couplings, that stand side by side.
inline constexpr std::size_t block_lanes = 16;

/// Row `row` reads what stands at `column`.
struct Coupling {
    std::uint32_t row = 0, column = 0;
};

/// Which rows couple to which: what remains when values change.
class BlockPattern {
public:
    BlockPattern() = default;
    /// @param couplings a row's are taken in the order in which they stand here; pairs may repeat.
    ///        Those of i with j and of j with i are two.
    BlockPattern(std::size_t rows, std::span<const Coupling> couplings)
        : BlockPattern(rows, rows, couplings) {}
    /// Of rows that read a vector of another size.
    BlockPattern(std::size_t rows, std::size_t columns, std::span<const Coupling> couplings);

    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t slices() const { return starts_.empty() ? 0 : starts_.size() - 1; }
    /// Of couplings, over all slices.
    [[nodiscard]] std::size_t vectors() const { return starts_.empty() ? 0 : starts_.back(); }

    /// [slices + 1], where a slice's couplings begin [vector].
    [[nodiscard]] const std::uint32_t* starts() const { return starts_.data(); }
    /// [vector][lane], four times the column, as records stand; where none is, of any column, and
    /// in a square matrix the row's own.
    [[nodiscard]] const std::uint32_t* columns() const { return columns_.data(); }
    /// Where the c-th coupling stands: vector * block_lanes + lane.
    [[nodiscard]] std::size_t place(std::size_t c) const { return places_[c]; }

private:
    std::size_t rows_ = 0;
    std::vector<std::uint32_t> starts_, places_;
    LineAligned<std::uint32_t> columns_;
};

/// How K_ij is stored.
enum class BlockForm {
    spring = 4,     ///< a, g.x, g.y, g.z: a I + g g^T, never negative for a >= 0, rounded or not
    symmetric = 6,  ///< xx, xy, xz, yy, yz, zz
};

/// A symmetric 3 x 3 block: xx, xy, xz, yy, yz, zz.
struct SymmetricBlock {
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

/// The values, in float, half as much to read as in double: digits beyond come by refinement.
struct BlockMatrix {
    const BlockPattern* pattern = nullptr;
    BlockForm form = BlockForm::symmetric;
    LineAligned<float> couplings;  ///< K, [vector][number of the form][lane]
    LineAligned<float> own;        ///< B, [slice][6][lane]
    /// [slice][6][lane], lower triangular W: xx, yx, zx, yy, zy, zz, with W^T W the inverse of
    /// A_ii; zero in rows that do not take part. As a product with its transpose, it stays
    /// positive.
    LineAligned<float> factors;

    BlockMatrix() = default;
    BlockMatrix(const BlockPattern& its_pattern, BlockForm its_form);

    /// K of the coupling at a place.
    [[nodiscard]] SymmetricBlock coupling(std::size_t place) const;
    [[nodiscard]] SymmetricBlock own_block(std::size_t row) const;

    void set_coupling(std::size_t place, const SymmetricBlock& k);  ///< form: symmetric
    void set_spring(std::size_t place, double a, Vec3d g);          ///< form: spring
    void set_own(std::size_t row, const SymmetricBlock& b);
};

/// A vector by rows, and a copy of it that rows elsewhere read.
struct BlockVector {
    LineAligned<float> values;   ///< [slice][3][lane]
    LineAligned<float> records;  ///< [row][4]: x, y, z, 0; empty where nobody reads it

    BlockVector() = default;
    BlockVector(std::size_t slices, bool with_records) : values(3 * block_lanes * slices) {
        if (with_records) records = LineAligned<float>(4 * block_lanes * slices);
    }

    [[nodiscard]] Vec3d operator[](std::size_t row) const {
        const float* const at = values.data() + place(row);
        return {at[0], at[block_lanes], at[2 * block_lanes]};
    }
    /// Records too.
    void set(std::size_t row, Vec3d value) {
        float* const at = values.data() + place(row);
        at[0] = static_cast<float>(value.x);
        at[block_lanes] = static_cast<float>(value.y);
        at[2 * block_lanes] = static_cast<float>(value.z);
        if (records.size() == 0) return;
        for (std::size_t c = 0; c < 3; ++c) records[4 * row + c] = at[c * block_lanes];
    }
    void fill_zero();

private:
    static std::size_t place(std::size_t row) {
        return row / block_lanes * 3 * block_lanes + row % block_lanes;
    }
};

}  // namespace weft
