#include "simulation/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/largest_eigenvalue.h"
#include "simulation/mode_guess.h"
#include "weft/integrators.h"

namespace weft {

namespace {

// Whether the cloth has springs of a kind.
bool has_springs(const ClothModel& cloth, SpringKind kind) {
    const auto in_family = [&](const GridSpringFamily& family) {
        return family.kind == kind && family.owner_columns > 0 && family.owner_rows > 0 &&
               (family.factor > 0.0 || family.border_factor > 0.0);
    };
    const auto in_kind = [&](const Spring& spring) { return spring.kind == kind; };
    return std::any_of(cloth.families.begin(), cloth.families.end(), in_family) ||
           std::any_of(cloth.springs.begin(), cloth.springs.end(), in_kind);
}

// The smallest ratio c/k of any spring [s].
double least_damping_per_stiffness(const ClothModel& cloth) {
    double least = std::numeric_limits<double>::infinity();
    for (const SpringKind kind : {SpringKind::structural, SpringKind::shear, SpringKind::bend}) {
        const SpringMaterial& material = cloth.materials[static_cast<std::size_t>(kind)];
        if (material.stiffness > 0.0 && has_springs(cloth, kind)) {
            least = std::min(least, material.damping / material.stiffness);
        }
    }
    return std::isfinite(least) ? least : 0.0;
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

// A mode of next to no stiffness is limited by its decay alone; this little keeps zeta finite.
Mode damped_mode(double omega, double rate) {
    return {std::max(omega, 1e-3 * rate), rate};
}

// How long to search: until gains foretell six digits. A search may dwell on a mode that is not the
// highest: a small cloth can afford to find out, on a large one such modes are so close to each
// other that it does not matter.
SearchEffort effort(std::size_t particle_count) {
    const int least = static_cast<int>(
        std::clamp<std::size_t>(100'000 / std::max<std::size_t>(particle_count, 1), 12, 100));
    return {1e-6, least, particle_count > 100'000 ? 50 : 200};
}

}  // namespace

double StabilityModes::stable_step(std::string_view method) const {
    const IntegratorInfo& info = *find_integrator(method);
    // What a step of its own is worth, an adaptive method finds out itself.
    if (info.kind == IntegratorKind::adaptive) return std::numeric_limits<double>::infinity();
    double step = std::numeric_limits<double>::infinity();
    const auto limit_by = [&](const Mode& mode) {
        if (mode.omega <= 0.0) return;
        const double zeta = mode.damping_rate / (2.0 * mode.omega);
        step = std::min(step, stability_limit(method, zeta) / mode.omega);
    };
    for (const Mode& mode : modes) limit_by(mode);
    if (info.imaginary_limit == 0.0) limit_by(least_damped);
    return step;
}

template <typename Real>
StabilityAnalysis<Real>::StabilityAnalysis(const ClothModel& cloth, const ForcesDescription& forces,
                                           InstructionSet set, int threads)
    : cloth_(cloth), forces_(forces), set_(set), kernel_(cloth, forces, set, threads) {}

template <typename Real>
double StabilityAnalysis<Real>::quotient(LinearMatrix matrix, const Vec3Array<Real>& unit) {
    if (image_.size() != unit.size()) image_ = Vec3Array<Real>(unit.size());
    ++products_;
    return kernel_.multiply(matrix, 1.0, unit.view(), image_.view()).in_out;
}

template <typename Real>
Mode StabilityAnalysis<Real>::find_fastest() {
    LargestEigenvalue<Real> search(cloth_.layout.slot_count(), set_);
    guess_fastest_mode(cloth_, kernel_.root_inverse_masses(), search.vector());
    const auto multiply = [&](const Vec3Array<Real>& in, Vec3Array<Real>& out) {
        return kernel_.multiply(LinearMatrix::stiffness, 1.0, in.view(), out.view()).in_out;
    };
    const EigenvalueResult result = search.iterate(multiply, effort(cloth_.particle_count));
    products_ += result.products;
    fastest_mode_ = std::move(search.vector());
    length_ = 1.0;
    return {std::sqrt(std::max(result.value, 0.0)), 0.0};
}

template <typename Real>
Mode StabilityAnalysis<Real>::find_most_damped() {
    LargestEigenvalue<Real> search(cloth_.layout.slot_count(), set_);
    search.vector() = fastest_mode_;
    disturb_mode(cloth_, kernel_.root_inverse_masses(), search.vector());
    const auto multiply = [&](const Vec3Array<Real>& in, Vec3Array<Real>& out) {
        return kernel_.multiply(LinearMatrix::damping, 1.0, in.view(), out.view()).in_out;
    };
    const EigenvalueResult result = search.iterate(multiply, {1e-4, 6, 100});
    products_ += result.products;
    const double squared = quotient(LinearMatrix::stiffness, search.vector());
    return damped_mode(std::sqrt(std::max(squared, 0.0)), result.value);
}

template <typename Real>
StabilityModes StabilityAnalysis<Real>::find(ConstVec3View<Real> x) {
    products_ = 0;
    kernel_.linearise_at(x);
    StabilityModes found;
    Mode fastest = find_fastest();
    fastest.damping_rate = std::max(quotient(LinearMatrix::damping, fastest_mode_), 0.0);
    found.modes.push_back(fastest);
    const auto [lightest, heaviest] =
        std::minmax_element(cloth_.masses.begin(), cloth_.masses.end());
    found.least_damped = {fastest.omega,
                          forces_.damping / *heaviest +
                              least_damping_per_stiffness(cloth_) * fastest.omega * fastest.omega};
    if (fastest.damping_rate > 0.0) found.modes.push_back(find_most_damped());
    if (forces_.damping > 0.0) {
        found.modes.push_back(damped_mode(1e-3 * fastest.omega, forces_.damping / *lightest));
    }
    add_slower_modes(
        found, forces_.damping * static_cast<double>(cloth_.particle_count) / cloth_.total_mass());
    image_ = {};  // a simulation needs the most memory here
    return found;
}

template <typename Real>
double StabilityAnalysis<Real>::follow(ConstVec3View<Real> x, int products) {
    if (image_.size() != fastest_mode_.size()) image_ = Vec3Array<Real>(fastest_mode_.size());
    kernel_.linearise_at(x);
    double value = 0.0;
    for (int n = 0; n < products && length_ > 0.0; ++n) {
        const LinearSums sums =
            kernel_.multiply(LinearMatrix::stiffness, 1.0 / length_,
                             std::as_const(fastest_mode_).view(), image_.view());
        value = sums.in_out / length_;
        const double next = std::sqrt(sums.out_out);
        if (!(next > 0.0) || !std::isfinite(next)) break;
        std::swap(fastest_mode_, image_);
        length_ = next;
    }
    return value;
}

template class StabilityAnalysis<float>;
template class StabilityAnalysis<double>;

}  // namespace weft
