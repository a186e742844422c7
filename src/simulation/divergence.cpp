#include "simulation/divergence.h"

#include <fmt/format.h>

#include <cmath>

#include "forces/energy.h"

namespace weft {

namespace {

// The check's strain is as exact as the state: nearer to the limit, the exact one decides.
constexpr double surely_sound = 0.999 * Divergence::max_strain;

}  // namespace

template <typename Real>
std::optional<Divergence> find_divergence(const ClothModel& cloth, const ParticleState<Real>& state,
                                          const StrainCheck& check) {
    if (check.finite && check.strain <= surely_sound) return std::nullopt;
    Divergence found;
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        if (found.particle) return;
        if (!is_finite(state.x[slot]) || !is_finite(state.v[slot])) found.particle = p;
    });
    if (found.particle) return found;
    const SpringStrain strain = largest_strain(cloth, state.x.view());
    if (std::abs(strain.strain) <= Divergence::max_strain) return std::nullopt;
    found.spring = strain;
    return found;
}

template std::optional<Divergence> find_divergence(const ClothModel&, const ParticleState<float>&,
                                                   const StrainCheck&);
template std::optional<Divergence> find_divergence(const ClothModel&, const ParticleState<double>&,
                                                   const StrainCheck&);

void describe_failure(Divergence& failed, const StepFailure& failure, std::string_view method) {
    failed.message = fmt::format("{} cannot make step {}, of {:.4g} s: {}", method, failed.step,
                                 failed.time_step, failure.reason);
    failed.advice = failure.advice;
}

void describe_divergence(Divergence& divergence, const ClothModel& cloth, std::string_view method) {
    const std::string where =
        divergence.particle
            ? fmt::format("particle {} is no longer at a finite place",
                          cloth.particle_name(*divergence.particle))
            : fmt::format(
                  "the {} spring between particles {} and {} is stretched {:.3g} times its "
                  "length",
                  divergence.spring->kind, cloth.particle_name(divergence.spring->p),
                  cloth.particle_name(divergence.spring->q), divergence.spring->strain + 1);
    divergence.message = fmt::format("{} diverged in step {} at t = {:.6g} s: {}", method,
                                     divergence.step, divergence.time, where);
    if (divergence.stable_step <= 0.0) {
        divergence.advice = fmt::format(
            "{} is stable at no step without damping: choose another method (velocity-verlet, "
            "rk4), "
            "or give the springs damping.",
            method);
    } else if (std::isinf(divergence.stable_step)) {
        divergence.advice = fmt::format(
            "Every step is stable with {}; the forces are too large for {:.4g} s (wind, moving "
            "pins, a violent start). Try a smaller integrator.time_step or integrator.tolerance.",
            method, divergence.time_step);
    } else if (divergence.time_step > divergence.stable_step) {
        divergence.advice = fmt::format(
            "The step was {:.4g} s; up to {:.4g} s would have been stable. Set "
            "integrator.time_step "
            "= \"auto\" or below that, or integrator.on_divergence = \"halve-step\".",
            divergence.time_step, divergence.stable_step);
    } else {
        divergence.advice = fmt::format(
            "The step of {:.4g} s is below the limit of the cloth at rest, {:.4g} s: the forces "
            "are "
            "too large for it (wind, moving pins, a violent start). Try a smaller "
            "integrator.time_step, or integrator.on_divergence = \"halve-step\".",
            divergence.time_step, divergence.stable_step);
    }
}

}  // namespace weft
