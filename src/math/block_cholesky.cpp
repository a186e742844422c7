#include "math/block_cholesky.h"

#include <cholmod.h>

#include <algorithm>
#include <array>
#include <new>
#include <vector>

namespace weft {

struct BlockCholesky::Impl {
    // Where a block stands among the matrix's values, column by column of the lower triangle.
    struct Place {
        std::array<std::size_t, 3> columns{};
    };

    cholmod_common common{};
    cholmod_sparse* matrix = nullptr;  // lower triangle
    cholmod_factor* factor = nullptr;
    cholmod_dense *b = nullptr, *x = nullptr, *y = nullptr, *e = nullptr;
    std::vector<Coupling> couplings;
    std::vector<Place> diagonal, below;  // [row], [coupling]

    Impl();
    ~Impl();
    void set_structure(std::size_t rows);
    [[nodiscard]] Place place_of(const std::vector<std::uint32_t>& rows, std::size_t column,
                                 std::uint32_t row) const;
    void analyse();
    [[nodiscard]] double* values() const { return static_cast<double*>(matrix->x); }
};

namespace {

// Row numbers of the lower triangle's blocks, [column], rising, each once; the diagonal's first.
std::vector<std::vector<std::uint32_t>> lower_rows(std::size_t rows,
                                                   std::span<const Coupling> couplings) {
    std::vector<std::vector<std::uint32_t>> lower(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        lower[row].push_back(static_cast<std::uint32_t>(row));
    }
    for (const Coupling& c : couplings) {
        lower[std::min(c.row, c.column)].push_back(std::max(c.row, c.column));
    }
    for (auto& column : lower) {
        std::sort(column.begin(), column.end());
        column.erase(std::unique(column.begin(), column.end()), column.end());
    }
    return lower;
}

}  // namespace

BlockCholesky::Impl::Impl() {
    cholmod_start(&common);
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.final_ll = 1;  // L L^T: where small, L D L^T would pass what is not positive
}

BlockCholesky::Impl::~Impl() {
    cholmod_free_sparse(&matrix, &common);
    cholmod_free_factor(&factor, &common);
    for (cholmod_dense** dense : {&b, &x, &y, &e}) cholmod_free_dense(dense, &common);
    cholmod_finish(&common);
}

// Of a block whose column's blocks are `rows`.
BlockCholesky::Impl::Place BlockCholesky::Impl::place_of(const std::vector<std::uint32_t>& rows,
                                                         std::size_t column,
                                                         std::uint32_t row) const {
    const int* const starts = static_cast<const int*>(matrix->p);
    const auto at = std::lower_bound(rows.begin(), rows.end(), row);
    const auto block = static_cast<std::size_t>(at - rows.begin());
    Place place;
    for (std::size_t c = 0; c < 3; ++c) {
        // The numbers of the diagonal block above the diagonal are not there.
        place.columns[c] = static_cast<std::size_t>(starts[3 * column + c]) + 3 * block - c;
    }
    return place;
}

void BlockCholesky::Impl::set_structure(std::size_t rows) {
    const auto lower = lower_rows(rows, couplings);
    std::size_t count = 0;  // of values: whole blocks below, six numbers on the diagonal
    for (const auto& column : lower) count += 9 * column.size() - 3;
    matrix = cholmod_allocate_sparse(3 * rows, 3 * rows, count, 1, 1, -1, CHOLMOD_REAL, &common);
    if (matrix == nullptr) throw std::bad_alloc();
    int* const starts = static_cast<int*>(matrix->p);
    int* const numbers = static_cast<int*>(matrix->i);
    int next = 0;
    for (std::size_t column = 0; column < rows; ++column) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            starts[3 * column + c] = next;
            for (const std::uint32_t row : lower[column]) {
                for (std::uint32_t r = row == column ? c : 0; r < 3; ++r) {
                    numbers[next++] = static_cast<int>(3 * row + r);
                }
            }
        }
    }
    starts[3 * rows] = next;
    for (std::size_t row = 0; row < rows; ++row) {
        diagonal.push_back(place_of(lower[row], row, static_cast<std::uint32_t>(row)));
    }
    for (const Coupling& c : couplings) {
        const std::uint32_t column = std::min(c.row, c.column);
        below.push_back(place_of(lower[column], column, std::max(c.row, c.column)));
    }
}

// The order of elimination is CHOLMOD's choice: minimum degree (AMD), and where that fills in much,
// nested dissection (METIS) if better. Either alone is slower at one size or another.
void BlockCholesky::Impl::analyse() {
    factor = cholmod_analyze(matrix, &common);
    b = cholmod_allocate_dense(matrix->nrow, 1, matrix->nrow, CHOLMOD_REAL, &common);
    if (factor == nullptr || b == nullptr) throw std::bad_alloc();
}

BlockCholesky::BlockCholesky(std::size_t rows, std::span<const Coupling> couplings, Modules modules)
    : impl_(std::make_unique<Impl>()) {
    if (modules == Modules::simplicial) impl_->common.supernodal = CHOLMOD_SIMPLICIAL;
    impl_->couplings.assign(couplings.begin(), couplings.end());
    impl_->set_structure(rows);
    impl_->analyse();
}

BlockCholesky::~BlockCholesky() = default;

void BlockCholesky::clear() {
    std::fill_n(impl_->values(), impl_->matrix->nzmax, 0.0);
}

void BlockCholesky::add_own(std::size_t row, const SymmetricBlock& b) {
    // A column's numbers begin on the diagonal: those above are not stored.
    double* const values = impl_->values();
    const auto& at = impl_->diagonal[row].columns;
    values[at[0]] += b.xx, values[at[0] + 1] += b.xy, values[at[0] + 2] += b.xz;
    values[at[1] + 1] += b.yy, values[at[1] + 2] += b.yz;
    values[at[2] + 2] += b.zz;
}

void BlockCholesky::add_coupling(std::size_t c, const SymmetricBlock& k) {
    add_own(impl_->couplings[c].row, k);
    add_own(impl_->couplings[c].column, k);
    const std::array<std::array<double, 3>, 3> columns{
        {{k.xx, k.xy, k.xz}, {k.xy, k.yy, k.yz}, {k.xz, k.yz, k.zz}}};
    for (std::size_t n = 0; n < 3; ++n) {
        double* const at = impl_->values() + impl_->below[c].columns[n];
        for (std::size_t r = 0; r < 3; ++r) at[r] -= columns[n][r];
    }
}

bool BlockCholesky::factor() {
    const bool ran = cholmod_factorize(impl_->matrix, impl_->factor, &impl_->common) != 0;
    return ran && impl_->common.status == CHOLMOD_OK && impl_->factor->minor == impl_->factor->n;
}

void BlockCholesky::solve(std::span<const double> b, std::span<double> x) {
    std::copy(b.begin(), b.end(), static_cast<double*>(impl_->b->x));
    cholmod_solve2(CHOLMOD_A, impl_->factor, impl_->b, nullptr, &impl_->x, nullptr, &impl_->y,
                   &impl_->e, &impl_->common);
    std::copy_n(static_cast<const double*>(impl_->x->x), x.size(), x.begin());
}

double BlockCholesky::factor_size() const {
    return impl_->common.lnz;
}

}  // namespace weft
