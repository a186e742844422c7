#include "integrators/verlet.h"

#include <Eigen/Dense>
#include <utility>

#include "integrators/array_loop.h"

namespace weft {

template <typename Real>
void PositionVerlet<Real>::prepare(DynamicsSystem<Real>& system) {
    x_previous_ = Vec3Array<Real>(system.slot_count());
    a_ = Vec3Array<Real>(system.slot_count());
    last_step_ = 0.0;
}

template <typename Real>
void PositionVerlet<Real>::restore(const History& history) {
    x_previous_ = history.arrays[0];
    a_ = history.arrays[1];
    last_step_ = history.last_step;
}

template <typename Real>
void PositionVerlet<Real>::start(DynamicsSystem<Real>& system, double dt,
                                 const ParticleState<Real>& state) {
    system.acceleration(state.time, state.x.view(), state.v.view(), a_.view());
    const Real h = static_cast<Real>(dt), half_h2 = static_cast<Real>(dt * dt / 2);
    for_components(state.x, [&](std::size_t begin, std::size_t end) {
        const Real *x = state.x.data(), *v = state.v.data(), *a = a_.data();
        Real* previous = x_previous_.data();
        for (std::size_t n = begin; n < end; ++n) previous[n] = x[n] - h * v[n] + half_h2 * a[n];
    });
    last_step_ = dt;
}

template <typename Real>
StepReport PositionVerlet<Real>::step(DynamicsSystem<Real>& system, double dt,
                                      ParticleState<Real>& state) {
    if (last_step_ == 0.0 || (!time_corrected_ && last_step_ != dt)) start(system, dt, state);
    const Real ratio = static_cast<Real>(dt / last_step_);
    const Real a_weight = static_cast<Real>(dt * (dt + last_step_) / 2);
    const Real inverse = static_cast<Real>(1 / dt),
               inverse_last = static_cast<Real>(1 / last_step_);
    const Real curvature = static_cast<Real>(dt / (dt + last_step_));
    for_components(state.x, [&](std::size_t begin, std::size_t end) {
        Real *x = state.x.data(), *v = state.v.data(), *previous = x_previous_.data();
        const Real* a = a_.data();
        for (std::size_t n = begin; n < end; ++n) {
            const Real moved = x[n] - previous[n];
            const Real next = x[n] + moved * ratio + a_weight * a[n];
            const Real difference = (next - x[n]) * inverse;
            v[n] = difference + (difference - moved * inverse_last) * curvature;  // one-sided
            previous[n] = x[n];
            x[n] = next;
        }
    });
    state.time += dt;
    system.constrain(state.time, state.x.view(), state.v.view());
    system.acceleration(state.time, state.x.view(), state.v.view(), a_.view());
    const Real half_h = static_cast<Real>(dt / 2);
    for_components(state.v, [&](std::size_t begin, std::size_t end) {
        const Real *x = state.x.data(), *previous = x_previous_.data(), *a = a_.data();
        Real* v = state.v.data();
        for (std::size_t n = begin; n < end; ++n) {
            v[n] = (x[n] - previous[n]) * inverse + half_h * a[n];
        }
    });
    system.constrain(state.time, state.x.view(), state.v.view());
    last_step_ = dt;
    return {};
}

template <typename Real>
void VelocityVerlet<Real>::prepare(DynamicsSystem<Real>& system) {
    a_ = Vec3Array<Real>(system.slot_count());
    a_next_ = Vec3Array<Real>(system.verlet_pass() != nullptr ? 0 : system.slot_count());
    started_ = false;
}

template <typename Real>
void VelocityVerlet<Real>::restore(const History& history) {
    a_ = history.arrays[0];
    started_ = history.last_step != 0.0;
}

template <typename Real>
void VelocityVerlet<Real>::start(DynamicsSystem<Real>& system, const ParticleState<Real>& state) {
    if (started_) return;
    system.acceleration(state.time, state.x.view(), state.v.view(), a_.view());
    started_ = true;
}

template <typename Real>
void VelocityVerlet<Real>::begin(DynamicsSystem<Real>& system, const ParticleState<Real>& state) {
    if (system.verlet_pass() == nullptr) return;
    start(system, state);
    system.hold(state.x.view(), state.v.view(), std::as_const(a_).view());
}

template <typename Real>
void VelocityVerlet<Real>::finish(DynamicsSystem<Real>& system, ParticleState<Real>& state) {
    system.release(state.x.view(), state.v.view(), a_.view());
}

template <typename Real>
StepReport VelocityVerlet<Real>::step(DynamicsSystem<Real>& system, double dt,
                                      ParticleState<Real>& state) {
    start(system, state);
    if (VerletPass<Real>* const pass = system.verlet_pass()) {
        pass->verlet(state.time, dt, state.x.view(), state.v.view(), a_.view());
        state.time += dt;
        return {};
    }
    const Real h = static_cast<Real>(dt), half_h = static_cast<Real>(dt / 2);
    const Real half_h2 = static_cast<Real>(dt * dt / 2);
    for_components(state.x, [&](std::size_t begin, std::size_t end) {
        Real *x = state.x.data(), *v = state.v.data();
        const Real* a = a_.data();
        for (std::size_t n = begin; n < end; ++n) {
            x[n] += h * v[n] + half_h2 * a[n];
            v[n] += h * a[n];  // predicted; corrected below
        }
    });
    state.time += dt;
    system.constrain(state.time, state.x.view(), state.v.view());
    system.acceleration(state.time, state.x.view(), state.v.view(), a_next_.view());
    for_components(state.v, [&](std::size_t begin, std::size_t end) {
        const Real *a = a_.data(), *a_next = a_next_.data();
        Real* v = state.v.data();
        for (std::size_t n = begin; n < end; ++n) v[n] += half_h * (a_next[n] - a[n]);
    });
    std::swap(a_, a_next_);
    system.constrain(state.time, state.x.view(), state.v.view());
    return {};
}

double position_verlet_amplification(double omega_dt, double zeta) {
    // State (x, x_prev, a); x+ = 2 x - x_prev + a; a+ = -w^2 x+ - zeta w (3 x+ - 4 x + x_prev).
    const double w2 = omega_dt * omega_dt, c = zeta * omega_dt;
    const Eigen::RowVector3d next{2.0, -1.0, 1.0};
    Eigen::Matrix3d step;
    step.row(0) = next;
    step.row(1) = Eigen::RowVector3d{1.0, 0.0, 0.0};
    step.row(2) = -(w2 + 3.0 * c) * next + Eigen::RowVector3d{4.0 * c, -c, 0.0};
    return step.eigenvalues().cwiseAbs().maxCoeff();
}

double velocity_verlet_amplification(double omega_dt, double zeta) {
    // State (x, v, a); a+ = -w^2 x+ - 2 zeta w (v + a).
    const double w2 = omega_dt * omega_dt, c = 2.0 * zeta * omega_dt;
    const Eigen::RowVector3d next{1.0, 1.0, 0.5};
    const Eigen::RowVector3d a_next = -w2 * next - c * Eigen::RowVector3d{0.0, 1.0, 1.0};
    Eigen::Matrix3d step;
    step.row(0) = next;
    step.row(1) = Eigen::RowVector3d{0.0, 1.0, 0.5} + 0.5 * a_next;
    step.row(2) = a_next;
    return step.eigenvalues().cwiseAbs().maxCoeff();
}

template class PositionVerlet<float>;
template class PositionVerlet<double>;
template class VelocityVerlet<float>;
template class VelocityVerlet<double>;

}  // namespace weft
