#include "forces/grid_kernel.h"

#include <algorithm>
#include <cassert>

#include "math/parallel.h"
#include "math/simd_targets.h"

namespace weft {

namespace {

// Particles worth a thread of their own: fewer take as long as waking the thread.
constexpr std::size_t band_grain = 8192;

std::size_t vector_bytes(InstructionSet set) {
    return set == InstructionSet::avx512 ? 64 : set == InstructionSet::avx2 ? 32 : 16;
}

template <typename Real>
GridFamilyConstants<Real> family_constants(const SpringMaterial& material, double factor,
                                           double rest_length) {
    const double scale = root_scale<Real>;
    return {static_cast<Real>(material.stiffness * factor),
            static_cast<Real>(material.stiffness * factor * rest_length / scale),
            static_cast<Real>(material.damping * factor / (scale * scale))};
}

template <typename Real>
std::array<Real*, 3> components(Vec3View<Real> view) {
    return {view.x, view.y, view.z};
}

// A pass reads x and v through the pointers that others move them by.
template <typename Real>
Vec3View<Real> writable(ConstVec3View<Real> view) {
    return {const_cast<Real*>(view.x), const_cast<Real*>(view.y), const_cast<Real*>(view.z),
            view.size};
}

}  // namespace

template <typename Real>
GridKernel<Real>::GridKernel(const ClothModel& cloth, const ForcesDescription& forces,
                             const std::optional<WindDescription>& wind,
                             std::span<const Real> inverse_masses, InstructionSet set,
                             int threads) {
    assert(set != InstructionSet::scalar && inverse_masses.size() == cloth.layout.slot_count());
    if constexpr (sizeof(Real) == 4) {
        function_ = grid_pass_single(set);
    } else {
        function_ = grid_pass_double(set);
    }
    pass_.columns = cloth.shape.columns;
    pass_.rows = cloth.shape.rows;
    pass_.stride = cloth.layout.row_stride();
    pass_.inverse_masses = inverse_masses.data();
    pass_.drag = static_cast<Real>(forces.damping);
    pass_.gravity = vec3_cast<Real>(forces.gravity);
    pass_.air = wind.has_value();
    if (wind) pass_.air_constants = AirConstants<Real>(*wind);
    strips_ = GridStripState<Real>(pass_.columns, pass_.rows, pass_.stride,
                                   vector_bytes(set) / sizeof(Real));
    set_constants(cloth);
    cut_bands(threads);
}

template <typename Real>
void GridKernel<Real>::set_constants(const ClothModel& cloth) {
    const GridShape& shape = cloth.shape;
    const std::size_t inner_column = shape.columns > 2 ? 1 : 0;
    for (std::size_t n = 0; n < grid_family_count; ++n) {
        const GridSpringFamily& family = cloth.families[n];
        const SpringMaterial& material = cloth.materials[static_cast<std::size_t>(family.kind)];
        pass_.damped |= material.damping > 0.0;
        // A family along columns has its factor from the column, one along rows from the row.
        const double column_base = !family.along_column() ? 1.0
                                   : family.factor > 0.0  ? family.factor
                                                          : family.border_factor;
        factors_.column[n].assign(pass_.stride, Real{0});
        for (std::size_t i = 0; i < family.owner_columns; ++i) {
            const double factor =
                family.along_column() ? family.spring_factor(i, 0, shape) / column_base : 1.0;
            factors_.column[n][i] = static_cast<Real>(column_base > 0.0 ? factor : 0.0);
        }
        factors_in_strips_.column[n] = strips_.in_strips(factors_.column[n]);
        if (factors_.column[n][0] != factors_.column[n][inner_column]) pass_.left_edge = true;
        for (std::size_t j = 0; j < shape.rows; ++j) {
            GridRowConstants<Real>& row = pass_.row_constants[pass_.row_kind(j)];
            const bool present = j < family.owner_rows;
            const auto constants = [&](double factor) {
                return family_constants<Real>(material, present ? factor : 0.0, family.rest_length);
            };
            row.inner[n] = constants(family.spring_factor(inner_column, j, shape));
            row.edge[n] =
                constants(family.along_column() ? column_base : family.spring_factor(0, j, shape));
            row.has_triangles = j + 1 < shape.rows;
        }
    }
    factors_.triangle.assign(pass_.stride, Real{0});
    std::fill_n(factors_.triangle.begin(), shape.columns - 1, Real{1});
    factors_in_strips_.triangle = strips_.in_strips(factors_.triangle);
    follow_strips();
}

template <typename Real>
void GridKernel<Real>::cut_bands(int threads) {
    using Band = GridBand<Real>;
    const std::size_t most = std::max<std::size_t>(pass_.rows * pass_.columns / band_grain, 1);
    const std::size_t count =
        std::min({static_cast<std::size_t>(std::max(threads, 1)), most, pass_.rows});
    const std::size_t lines = 2 * Band::line_count * pass_.stride;
    const std::size_t halo =
        count > 1
            ? Band::halo_rows * std::max(Band::halo_arrays * pass_.stride, strips_.largest_row())
            : 0;
    scratch_ = LineAligned<Real>(count * (lines + halo));
    Real* next = scratch_.data();
    for (std::size_t n = 0; n < count; ++n) {
        Band band{n * pass_.rows / count, (n + 1) * pass_.rows / count, next, nullptr};
        if (halo > 0) band.halo = next + lines;
        next += lines + halo;
        bands_.push_back(band);
    }
}

template <typename Real>
void GridKernel<Real>::set_state(Vec3View<Real> x, Vec3View<Real> v) {
    pass_.x = components(x);
    pass_.v = components(v);
}

template <typename Real>
void GridKernel<Real>::copy_halo(const GridBand<Real>& band, std::size_t arrays) const {
    const auto copy = [&](std::size_t j) {
        const std::size_t place = band.halo_place(j);
        if (holds()) {
            const std::size_t row = pass_.strips.row_size;
            std::copy_n(pass_.strips.blocks + j * row, row, band.halo + place * row);
            return;
        }
        for (std::size_t c = 0; c < arrays; ++c) {
            const Real* const base = c < 3 ? pass_.x[c] : c < 6 ? pass_.v[c - 3] : pass_.a[c - 6];
            std::copy_n(base + j * pass_.stride, pass_.stride,
                        band.halo + (c * GridBand<Real>::halo_rows + place) * pass_.stride);
        }
    };
    for (std::size_t n = 1; n <= 2 && n <= band.row_begin; ++n) copy(band.row_begin - n);
    for (std::size_t n = 0; n < 2 && band.row_end + n < pass_.rows; ++n) copy(band.row_end + n);
}

template <typename Real>
void GridKernel<Real>::run_in_place(std::size_t arrays) {
    if (bands_.size() > 1) {
        parallel_for(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) copy_halo(bands_[n], arrays);
        });
    }
    parallel_for(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) function_(pass_, bands_[n]);
    });
}

template <typename Real>
void GridKernel<Real>::accelerate(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                                  Vec3View<Real> a) {
    pass_.update = GridUpdate::acceleration;
    pass_.wind = wind;
    set_state(writable(x), writable(v));
    pass_.a = components(a);
    parallel_for(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            GridBand<Real> band = bands_[n];
            band.halo = nullptr;  // nothing moves
            function_(pass_, band);
        }
    });
}

template <typename Real>
void GridKernel<Real>::kick_drift(Vec3<Real> wind, double kick, double drift, Vec3View<Real> x,
                                  Vec3View<Real> v) {
    GridPass<Real>& pass = waits_ ? second_ : pass_;
    if (waits_) second_ = pass_;
    pass.update = GridUpdate::kick_drift;
    pass.wind = wind;
    pass.kick = static_cast<Real>(kick);
    pass.drift = static_cast<Real>(drift);
    set_state(x, v);
    if (holds() && joins_ && !waits_) {
        waits_ = true;
        return;
    }
    if (waits_) pass_.second = &second_;
    run_in_place(6);
    pass_.second = nullptr;
    waits_ = false;
}

template <typename Real>
void GridKernel<Real>::verlet(Vec3<Real> wind, double h, std::span<const PinTarget<Real>> pins,
                              Vec3View<Real> x, Vec3View<Real> v, Vec3View<Real> a) {
    pass_.update = GridUpdate::verlet;
    pass_.wind = wind;
    pass_.kick = static_cast<Real>(h);
    pass_.pins = pins.data();
    pass_.pin_count = pins.size();
    set_state(x, v);
    pass_.a = components(a);
    run_in_place(9);
}

template <typename Real>
void GridKernel<Real>::hold(ConstVec3View<Real> x, ConstVec3View<Real> v, ConstVec3View<Real> a,
                            bool pins_rest) {
    if (!strips_.pays()) return;
    joins_ = pins_rest && bands_.size() == 1;
    strips_.take(x, v, pass_.inverse_masses, a);
    follow_strips();
}

template <typename Real>
void GridKernel<Real>::release(Vec3View<Real> x, Vec3View<Real> v, Vec3View<Real> a) {
    if (!holds()) return;
    if (waits_) run_in_place(6);
    waits_ = false;
    strips_.give(x, v, a);
    follow_strips();
}

template <typename Real>
void GridKernel<Real>::follow_strips() {
    pass_.strips = strips_.strips();
    const Factors& factors = holds() ? factors_in_strips_ : factors_;
    for (std::size_t n = 0; n < grid_family_count; ++n) {
        pass_.column_factors[n] = factors.column[n].data();
    }
    pass_.triangle_factors = factors.triangle.data();
}

template class GridKernel<float>;
template class GridKernel<double>;

}  // namespace weft
