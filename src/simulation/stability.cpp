#include "simulation/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "forces/linearised.h"
#include "math/random.h"
#include "weft/integrators.h"

namespace weft {

namespace {

template <typename Real>
void start_vector(const ParticleLayout& layout, Vec3Array<Real>& vector) {
    const auto random = [](std::size_t p, std::uint64_t component) {
        return static_cast<Real>(random_uniform(1, component, p) - 0.5);
    };
    layout.for_each([&](std::size_t p, std::size_t slot) {
        vector.set(slot, {random(p, 0), random(p, 1), random(p, 2)});
    });
}

// product(in, out) in the symmetric form M^-1/2 A M^-1/2.
template <typename Real, typename Product>
auto mass_scaled(const ClothSystem<Real>& system, Vec3Array<Real>& scaled, const Product& product) {
    return [&system, &scaled, product](const Vec3Array<Real>& in, Vec3Array<Real>& out) {
        scaled = in;
        system.scale_by_root_inverse_mass(scaled.view());
        product(std::as_const(scaled).view(), out.view());
        system.scale_by_root_inverse_mass(out.view());
    };
}

double least_damping_per_stiffness(const ClothModel& cloth) {
    double least = std::numeric_limits<double>::infinity();
    cloth.for_each_spring([&](const Spring&, const SpringConstants& constants) {
        if (constants.stiffness > 0.0) {
            least = std::min(least, constants.damping / constants.stiffness);
        }
    });
    return std::isfinite(least) ? least : 0.0;
}

}  // namespace

double StabilityModes::stable_step(std::string_view method) const {
    double step = std::numeric_limits<double>::infinity();
    const auto limit_by = [&](const Mode& mode) {
        if (mode.omega <= 0.0) return;
        const double zeta = mode.damping_rate / (2.0 * mode.omega);
        step = std::min(step, stability_limit(method, zeta) / mode.omega);
    };
    for (const Mode& mode : modes) limit_by(mode);
    if (find_integrator(method)->imaginary_limit == 0.0) limit_by(least_damped);
    return step;
}

template <typename Real>
double follow_largest_stiffness(const ClothModel& cloth, const ClothSystem<Real>& system,
                                ConstVec3View<Real> x, Vec3Array<Real>& vector, int products) {
    Vec3Array<Real> scaled(cloth.layout.slot_count()), image(cloth.layout.slot_count());
    const auto stiffness = mass_scaled(
        system, scaled,
        [&](ConstVec3View<Real> in, Vec3View<Real> out) { stiffness_product(cloth, x, in, out); });
    double value = 0.0;
    for (int n = 0; n < products; ++n) value = power_step(stiffness, vector, image);
    return value;
}

// The unit vector that `product` multiplies most, and how much. Its work space ends with it: this
// is where a simulation needs the most memory.
template <typename Real, typename Product>
std::pair<double, Vec3Array<Real>> dominant(const ClothModel& cloth,
                                            const ClothSystem<Real>& system,
                                            const Product& product) {
    // Enough for six digits on a small cloth; on a million particles for three, in a few seconds.
    constexpr double tolerance = 1e-6, product_budget = 2e7;
    const int max_products = static_cast<int>(
        std::clamp(product_budget / static_cast<double>(cloth.particle_count), 40.0, 200.0));
    LargestEigenvalue<Real> search(cloth.layout.slot_count());
    start_vector(cloth.layout, search.vector());
    system.scale_by_root_inverse_mass(search.vector().view());  // nothing on pinned particles
    const double value = search.iterate(product, tolerance, max_products).value;
    return {std::max(value, 0.0), std::move(search.vector())};
}

template <typename Real, typename Product>
double rayleigh_quotient(const Vec3Array<Real>& vector, const Product& product) {
    Vec3Array<Real> image(vector.size());
    product(vector, image);
    return dot_product(vector, image);
}

// A composition with a negative kick amplifies damped modes well below the fastest: between zero
// and it, modes are damped at about the rate alpha + beta omega^2 of Rayleigh's model, fitted to
// the fastest.
void add_slower_modes(StabilityModes& found, double alpha) {
    const Mode fastest = found.modes.front();
    if (!(fastest.damping_rate > 0.0)) return;
    const double beta =
        std::max(fastest.damping_rate - alpha, 0.0) / (fastest.omega * fastest.omega);
    constexpr int samples = 20;
    for (int n = 1; n < samples; ++n) {
        const double omega = fastest.omega * n / samples;
        found.modes.push_back({omega, alpha + beta * omega * omega});
    }
}

template <typename Real>
StabilityModes stability_modes(const ClothModel& cloth, const ForcesDescription& forces,
                               const ClothSystem<Real>& system, ConstVec3View<Real> x,
                               Vec3Array<Real>& fastest_mode) {
    Vec3Array<Real> scaled(cloth.layout.slot_count());
    const auto damping =
        mass_scaled(system, scaled, [&](ConstVec3View<Real> in, Vec3View<Real> out) {
            damping_product(cloth, forces, x, in, out);
        });
    const auto stiffness = mass_scaled(
        system, scaled,
        [&](ConstVec3View<Real> in, Vec3View<Real> out) { stiffness_product(cloth, x, in, out); });
    StabilityModes found;
    double squared = 0.0;
    std::tie(squared, fastest_mode) = dominant(cloth, system, stiffness);
    const Mode fastest{std::sqrt(squared), rayleigh_quotient(fastest_mode, damping)};
    found.modes.push_back(fastest);
    const auto [lightest, heaviest] = std::minmax_element(cloth.masses.begin(), cloth.masses.end());
    found.least_damped = {
        fastest.omega, forces.damping / *heaviest + least_damping_per_stiffness(cloth) * squared};
    // A mode of next to no stiffness is limited by its decay alone; this little keeps zeta finite.
    const auto damped_mode = [](double omega, double rate) {
        return Mode{std::max(omega, 1e-3 * rate), rate};
    };
    if (fastest.damping_rate > 0.0) {
        const auto [rate, vector] = dominant(cloth, system, damping);
        found.modes.push_back(damped_mode(std::sqrt(rayleigh_quotient(vector, stiffness)), rate));
    }
    if (forces.damping > 0.0) {
        found.modes.push_back(damped_mode(1e-3 * fastest.omega, forces.damping / *lightest));
    }
    add_slower_modes(
        found, forces.damping * static_cast<double>(cloth.particle_count) / cloth.total_mass());
    return found;
}

template double follow_largest_stiffness(const ClothModel&, const ClothSystem<float>&,
                                         ConstVec3View<float>, Vec3Array<float>&, int);
template double follow_largest_stiffness(const ClothModel&, const ClothSystem<double>&,
                                         ConstVec3View<double>, Vec3Array<double>&, int);
template StabilityModes stability_modes(const ClothModel&, const ForcesDescription&,
                                        const ClothSystem<float>&, ConstVec3View<float>,
                                        Vec3Array<float>&);
template StabilityModes stability_modes(const ClothModel&, const ForcesDescription&,
                                        const ClothSystem<double>&, ConstVec3View<double>,
                                        Vec3Array<double>&);

}  // namespace weft
