#include "forces/measure_cloth.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

#include "forces/energy.h"
#include "math/parallel.h"
#include "math/random.h"

namespace weft {

namespace {

constexpr std::size_t particle_grain = 16384;         // worth a thread of its own
constexpr std::size_t particles_of_block = 1024;      // of a mesh, summed one by one
constexpr std::uint64_t apart = 0xd6e8feb86659fd93u;  // odd: tells all indices of a hash apart

template <typename Real>
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

// Whether all is finite: an exponent of ones is not.
template <typename Real>
bool all_finite(const Real* values, std::size_t count) {
    constexpr auto exponent = std::bit_cast<Bits<Real>>(std::numeric_limits<Real>::infinity());
    Bits<Real> bad = 0;
    for (std::size_t n = 0; n < count; ++n) {
        bad |= (std::bit_cast<Bits<Real>>(values[n]) & exponent) == exponent ? 1U : 0U;
    }
    return bad == 0;
}

template <typename Real>
bool all_finite(ConstVec3View<Real> a) {
    std::atomic<bool> finite = true;
    parallel_for(a.size, particle_grain, [&](std::size_t begin, std::size_t end) {
        for (const Real* component : {a.x, a.y, a.z}) {
            if (!all_finite(component + begin, end - begin)) finite = false;
        }
    });
    return finite;
}

std::size_t row_grain(const ClothModel& cloth) {
    return std::max<std::size_t>(particle_grain / cloth.layout.row_stride(), 1);
}

// The larger of two strains; the first of equal ones.
void take_larger(SpringStrain& largest, const SpringStrain& strain) {
    if (std::abs(strain.strain) > std::abs(largest.strain)) largest = strain;
}

Energy operator+(const Energy& a, const Energy& b) {
    return {a.kinetic + b.kinetic, a.gravity + b.gravity, a.structural + b.structural,
            a.shear + b.shear, a.bend + b.bend};
}

// The range that holds all, and where its ends are.
template <typename Real>
StrainCheck widest(std::span<const RatioRange<Real>> ranges) {
    StrainCheck check;
    std::size_t smallest = 0, largest = 0;
    for (std::size_t n = 0; n < ranges.size(); ++n) {
        if (ranges[n].smallest < ranges[smallest].smallest) smallest = n;
        if (ranges[n].largest > ranges[largest].largest) largest = n;
    }
    if (ranges.empty()) return check;
    const double stretched = std::sqrt(double{ranges[largest].largest}) - 1.0;
    const double shortened = 1.0 - std::sqrt(double{ranges[smallest].smallest});
    check.finite = std::isfinite(ranges[largest].largest);
    check.strain = std::max(stretched, shortened);
    check.place = stretched >= shortened ? largest : smallest;
    return check;
}

}  // namespace

template <typename Real>
ClothMeasures<Real>::ClothMeasures(const ClothModel& cloth, const ForcesDescription& forces,
                                   InstructionSet set)
    : cloth_(cloth), forces_(forces), set_(set), mesh_(cloth) {
    if constexpr (sizeof(Real) == 4) {
        sweeps_ = grid_measures_single(set);
    } else {
        sweeps_ = grid_measures_double(set);
    }
    if (cloth.is_grid()) {
        set_grid();
        ranges_.resize(cloth.shape.rows);
        energies_.resize(cloth.shape.rows);
    } else {
        const std::size_t slots = cloth.layout.slot_count();
        ranges_.resize(mesh_.block_count());
        energies_.resize(mesh_.block_count() +
                         (slots + particles_of_block - 1) / particles_of_block);
    }
}

template <typename Real>
void ClothMeasures<Real>::set_grid() {
    grid_.columns = cloth_.shape.columns;
    grid_.rows = cloth_.shape.rows;
    grid_.stride = cloth_.layout.row_stride();
    grid_.masses = cloth_.masses.data();
    grid_.gravity = forces_.gravity;
    for (std::size_t n = 0; n < grid_family_count; ++n) set_family(n);
}

// A family's factors depend on the column or on the row, not on both.
template <typename Real>
void ClothMeasures<Real>::set_family(std::size_t n) {
    const GridShape& shape = cloth_.shape;
    const GridSpringFamily& family = cloth_.families[n];
    const double stiffness = cloth_.materials[static_cast<std::size_t>(family.kind)].stiffness;
    Family& own = families_[n];
    own.columns.assign(grid_.stride, Real{0});
    own.stiffness.assign(grid_.stride, 0.0);
    own.rows.assign(grid_.rows, 0.0);
    for (std::size_t i = 0; i < family.owner_columns; ++i) {
        const double factor = family.along_row() ? 1.0 : family.spring_factor(i, 0, shape);
        own.columns[i] = factor != 0.0 ? Real{1} : Real{0};
        own.stiffness[i] = 0.5 * stiffness * factor;
    }
    for (std::size_t j = 0; j < family.owner_rows; ++j) {
        own.rows[j] = family.along_row() ? family.spring_factor(0, j, shape) : 1.0;
    }
    const std::size_t inner_column = shape.columns > 2 ? 1 : 0;
    grid_.left_edge |= own.columns[0] != own.columns[inner_column];
    const double length = family.rest_length;
    grid_.families[n] = {length,
                         static_cast<Real>(1.0 / (length * length)),
                         own.columns.data(),
                         own.stiffness.data(),
                         own.rows.data(),
                         own.columns[inner_column] != 0};
}

template <typename Real>
StrainCheck ClothMeasures<Real>::check(View x, View v) {
    if (uses_twins()) {
        const bool finite = all_finite(x) && all_finite(v);
        return {finite, std::abs(weft::largest_strain(cloth_, x).strain), 0};
    }
    if (cloth_.is_grid()) {
        parallel_for(grid_.rows, row_grain(cloth_), [&](std::size_t begin, std::size_t end) {
            sweeps_.strain(grid_, x, v, begin, end, ranges_.data());
        });
        return widest<Real>(ranges_);
    }
    mesh_.strain(x, ranges_);
    StrainCheck check = widest<Real>(ranges_);
    check.finite = check.finite && all_finite(x) && all_finite(v);
    return check;
}

template <typename Real>
SpringStrain ClothMeasures<Real>::largest_strain(View x, const StrainCheck& check) const {
    if (uses_twins() || !check.finite) return weft::largest_strain(cloth_, x);
    if (cloth_.is_grid()) return largest_strain_of_row(x, check.place);
    return mesh_.block_count() > 0 ? mesh_.largest_strain(x, check.place) : SpringStrain{};
}

// By the twin's formula, in its order.
template <typename Real>
SpringStrain ClothMeasures<Real>::largest_strain_of_row(View x, std::size_t j) const {
    SpringStrain largest;
    const std::size_t stride = grid_.stride;
    for (std::size_t n = 0; n < grid_family_count; ++n) {
        const GridSpringFamily& family = cloth_.families[n];
        if (families_[n].rows[j] == 0.0) continue;
        for (std::size_t i = 0; i < family.owner_columns; ++i) {
            if (families_[n].columns[i] == 0) continue;
            const std::size_t p = i + family.ai, q = i + family.bi, row = j + family.bj;
            const Vec3d d =
                vec3_cast<double>(x[row * stride + q]) - vec3_cast<double>(x[j * stride + p]);
            take_larger(largest, {length(d) / family.rest_length - 1.0, cloth_.shape.index(p, j),
                                  cloth_.shape.index(q, row),
                                  spring_kind_names[static_cast<std::size_t>(family.kind)]});
        }
    }
    return largest;
}

template <typename Real>
void ClothMeasures<Real>::mesh_particle_energy(View x, View v) {
    const auto particles = mesh_.particles();
    const std::size_t slots = particles.size(), first = mesh_.block_count();
    const std::size_t blocks = energies_.size() - first;
    constexpr std::size_t grain = particle_grain / particles_of_block;
    parallel_for(blocks, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            Energy sum;
            const std::size_t last = std::min((b + 1) * particles_of_block, slots);
            for (std::size_t s = b * particles_of_block; s < last; ++s) {
                const double mass = cloth_.masses[particles[s]];
                const Vec3d velocity = vec3_cast<double>(v[s]);
                sum.kinetic += 0.5 * mass * dot(velocity, velocity);
                sum.gravity -= mass * dot(forces_.gravity, vec3_cast<double>(x[s]));
            }
            energies_[first + b] = sum;
        }
    });
}

template <typename Real>
Energy ClothMeasures<Real>::energy(View x, View v) {
    if (uses_twins()) return weft::energy(cloth_, forces_, x, v);
    if (cloth_.is_grid()) {
        parallel_for(grid_.rows, row_grain(cloth_), [&](std::size_t begin, std::size_t end) {
            sweeps_.energy(grid_, x, v, begin, end, energies_.data());
        });
    } else {
        mesh_.energy(x, std::span(energies_).first(mesh_.block_count()));
        mesh_particle_energy(x, v);
    }
    Energy sum;
    for (const Energy& part : energies_) sum = sum + part;
    return sum;
}

template <typename Real>
void ClothMeasures<Real>::normals(View x, std::span<Vec3f> out) {
    if (uses_twins()) {
        std::vector<Vec3d> positions(cloth_.particle_count);
        copy(x, positions);
        compute_normals(cloth_.surface, positions, out);
    } else if (cloth_.is_grid()) {
        parallel_for(grid_.rows, row_grain(cloth_), [&](std::size_t begin, std::size_t end) {
            sweeps_.normals(grid_, x, begin, end, out.data());
        });
    } else {
        mesh_.normals(x, out);
    }
}

template <typename Real>
void ClothMeasures<Real>::copy(View x, std::span<Vec3d> out) const {
    if (uses_twins()) {
        cloth_.layout.for_each(
            [&](std::size_t p, std::size_t slot) { out[p] = vec3_cast<double>(x[slot]); });
    } else if (cloth_.is_grid()) {
        parallel_for(grid_.rows, row_grain(cloth_), [&](std::size_t begin, std::size_t end) {
            sweeps_.copy(grid_, x, begin, end, out.data());
        });
    } else {
        mesh_.copy(x, out);
    }
}

template <typename Real>
void ClothMeasures<Real>::copy(View x, std::span<Vec3f> out) const {
    if (uses_twins()) {
        cloth_.layout.for_each(
            [&](std::size_t p, std::size_t slot) { out[p] = vec3_cast<float>(x[slot]); });
    } else if (cloth_.is_grid()) {
        parallel_for(grid_.rows, row_grain(cloth_), [&](std::size_t begin, std::size_t end) {
            sweeps_.copy_rounded(grid_, x, begin, end, out.data());
        });
    } else {
        mesh_.copy(x, out);
    }
}

// A wrapping sum over (particle, x or v, component): no term waits for another, and the layout does
// not matter.
template <typename Real>
std::uint64_t ClothMeasures<Real>::state_hash(View x, View v) const {
    std::uint64_t sum = cloth_.particle_count, component = 0;
    for (const Real* values : {x.x, x.y, x.z, v.x, v.y, v.z}) {
        sum += component_hash(values, component++);
    }
    return mix_bits(sum);
}

// The sum over particles p of mix_bits(bits + (6 p + component) apart).
template <typename Real>
std::uint64_t ClothMeasures<Real>::component_hash(const Real* values,
                                                  std::uint64_t component) const {
    std::uint64_t sum = 0;
    if (!uses_twins() && cloth_.is_grid()) {
        for (std::size_t j = 0; j < grid_.rows; ++j) {
            sum += sweeps_.hash(values + j * grid_.stride, grid_.columns,
                                (6 * j * grid_.columns + component) * apart, 6 * apart);
        }
        return sum;
    }
    const auto add = [&](std::size_t p, std::size_t slot) {
        sum += mix_bits(std::bit_cast<Bits<Real>>(values[slot]) + (6 * p + component) * apart);
    };
    if (!uses_twins()) {
        const auto particles = mesh_.particles();
        for (std::size_t slot = 0; slot < particles.size(); ++slot) add(particles[slot], slot);
    } else {
        cloth_.layout.for_each(add);
    }
    return sum;
}

template class ClothMeasures<float>;
template class ClothMeasures<double>;

}  // namespace weft
