// A grid's products: constants of the sweep, threads and their scratch memory.
#include <hwy/aligned_allocator.h>

#include <algorithm>

#include "forces/linear_products.h"
#include "math/parallel.h"

namespace weft {

namespace {

// Particles worth a thread of their own: fewer take as long as waking the thread.
constexpr std::size_t band_grain = 8192;

template <typename Real>
class GridProducts final : public LinearKernel<Real>::Products {
public:
    GridProducts(const ClothModel& cloth, const ForcesDescription& forces,
                 std::vector<Real> root_inverse_masses, InstructionSet set, int threads)
        : LinearKernel<Real>::Products(std::move(root_inverse_masses)) {
        if constexpr (sizeof(Real) == 4) {
            function_ = linear_grid_single(set);
        } else {
            function_ = linear_grid_double(set);
        }
        pass_.columns = cloth.shape.columns;
        pass_.rows = cloth.shape.rows;
        pass_.stride = cloth.layout.row_stride();
        pass_.root_inverse_masses = this->root_inverse_masses().data();
        pass_.drag = static_cast<Real>(forces.damping);
        for (std::size_t n = 0; n < grid_family_count; ++n) set_family(cloth, n);
        sums_.resize(pass_.rows);
        pass_.sums = sums_.data();
        cut_bands(threads);
    }

    void linearise_at(ConstVec3View<Real> x) override { pass_.x = {x.x, x.y, x.z}; }

    LinearSums multiply(LinearMatrix matrix, Real scale, ConstVec3View<Real> u,
                        Vec3View<Real> out) override {
        pass_.matrix = matrix;
        pass_.scale = scale;
        pass_.u = {u.x, u.y, u.z};
        pass_.out = {out.x, out.y, out.z};
        parallel_for(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) function_(pass_, bands_[n]);
        });
        LinearSums sums;
        for (const LinearSums& row : sums_) {
            sums.in_out += row.in_out / static_cast<double>(scale);
            sums.out_out += row.out_out;
        }
        return sums;
    }

private:
    // A family along columns has its factor from the column, one along rows from the row.
    void set_family(const ClothModel& cloth, std::size_t n) {
        const GridShape& shape = cloth.shape;
        const GridSpringFamily& family = cloth.families[n];
        const SpringMaterial& material = cloth.materials[static_cast<std::size_t>(family.kind)];
        const std::size_t inner_column = shape.columns > 2 ? 1 : 0;
        const double column_base = !family.along_column() ? 1.0
                                   : family.factor > 0.0  ? family.factor
                                                          : family.border_factor;
        std::vector<Real>& factors = factors_[n];
        factors.assign(pass_.stride, Real{0});
        for (std::size_t i = 0; i < family.owner_columns; ++i) {
            const double factor = family.along_column() ? family.spring_factor(i, 0, shape) : 1.0;
            factors[i] = static_cast<Real>(column_base > 0.0 ? factor / column_base : 0.0);
        }
        pass_.column_factors[n] = factors.data();
        if (factors[0] != factors[inner_column]) pass_.left_edge = true;
        for (std::size_t j = 0; j < shape.rows; ++j) {
            const auto spring = [&](double factor) {
                const double present = j < family.owner_rows ? factor : 0.0;
                return linear_spring<Real>(material.stiffness * present, material.damping * present,
                                           family.rest_length);
            };
            LinearRow<Real>& row = pass_.row_constants[pass_.row_kind(j)];
            row.inner[n] = spring(family.spring_factor(inner_column, j, shape));
            row.edge[n] =
                spring(family.along_column() ? column_base : family.spring_factor(0, j, shape));
        }
    }

    void cut_bands(int threads) {
        using Band = LinearBand<Real>;
        const std::size_t most = std::max<std::size_t>(pass_.rows * pass_.columns / band_grain, 1);
        const std::size_t count =
            std::min({static_cast<std::size_t>(std::max(threads, 1)), most, pass_.rows});
        const std::size_t room = Band::line_count * Band::line_stride(pass_.stride);
        lines_ = hwy::AllocateAligned<Real>(count * room);
        std::fill_n(lines_.get(), count * room, Real{0});
        for (std::size_t n = 0; n < count; ++n) {
            bands_.push_back(
                {n * pass_.rows / count, (n + 1) * pass_.rows / count, lines_.get() + n * room});
        }
    }

    LinearGridPass<Real> pass_;
    LinearGridFunction<Real> function_;
    std::array<std::vector<Real>, grid_family_count> factors_;
    std::vector<LinearSums> sums_;  // [row]
    std::vector<LinearBand<Real>> bands_;
    hwy::AlignedFreeUniquePtr<Real[]> lines_;
};

}  // namespace

template <typename Real>
std::unique_ptr<typename LinearKernel<Real>::Products> make_grid_products(
    const ClothModel& cloth, const ForcesDescription& forces, std::vector<Real> root_inverse_masses,
    InstructionSet set, int threads) {
    return std::make_unique<GridProducts<Real>>(cloth, forces, std::move(root_inverse_masses), set,
                                                threads);
}

template std::unique_ptr<LinearKernel<float>::Products> make_grid_products(const ClothModel&,
                                                                           const ForcesDescription&,
                                                                           std::vector<float>,
                                                                           InstructionSet, int);
template std::unique_ptr<LinearKernel<double>::Products> make_grid_products(
    const ClothModel&, const ForcesDescription&, std::vector<double>, InstructionSet, int);

}  // namespace weft
