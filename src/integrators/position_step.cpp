#include "integrators/position_step.h"

#include <cassert>

#include "integrators/array_loop.h"

namespace weft {

template <typename Real>
void PositionStep<Real>::prepare(DynamicsSystem<Real>& system) {
    network_ = system.spring_network();
    assert(network_ != nullptr);
    inverse_masses_.clear();
    for (const double w : network_->inverse_masses) {
        inverse_masses_.push_back(static_cast<Real>(w));
    }
    for (Vec3Array<Real>* array : {&start_, &target_, &external_, &pin_velocities_}) {
        *array = Vec3Array<Real>(system.slot_count());
    }
}

template <typename Real>
void PositionStep<Real>::begin(DynamicsSystem<Real>& system, double dt,
                               const ParticleState<Real>& state) {
    start_ = state.x;
    system.external_acceleration(state.time, state.x.view(), state.v.view(), external_.view());
    const Real h = static_cast<Real>(dt), h2 = static_cast<Real>(dt * dt);
    for_components(target_, [&](std::size_t begin, std::size_t end) {
        const Real *x = state.x.data(), *v = state.v.data(), *a = external_.data();
        Real* y = target_.data();
        for (std::size_t n = begin; n < end; ++n) y[n] = x[n] + (h * v[n] + h2 * a[n]);
    });
    system.constrain(state.time + dt, target_.view(), pin_velocities_.view());
}

template <typename Real>
void PositionStep<Real>::end(DynamicsSystem<Real>& system, double dt,
                             ParticleState<Real>& state) const {
    const Real inverse = static_cast<Real>(1 / dt);
    for_components(state.v, [&](std::size_t begin, std::size_t end) {
        const Real *x = state.x.data(), *start = start_.data();
        Real* v = state.v.data();
        for (std::size_t n = begin; n < end; ++n) v[n] = (x[n] - start[n]) * inverse;
    });
    state.time += dt;
    system.constrain(state.time, state.x.view(), state.v.view());
}

template class PositionStep<float>;
template class PositionStep<double>;

}  // namespace weft
