#include "integrators/composition.h"

#include <Eigen/Dense>

#include "integrators/array_loop.h"

namespace weft {

const CompositionTable symplectic_euler_table{1, {{{0.0, 1.0}}}, 1.0};

namespace {

// Yoshida (1990) eq. 2.11 with exact forms w1 = 1 / (2 - 2^(1/3)), w0 = 1 - 2 w1; the same
// coefficients as Forest and Ruth (1990) eq. 4.8.
constexpr double w1 = 1.3512071919596577718;
constexpr double w0 = -1.7024143839193155436;

}  // namespace

const CompositionTable fourth_order_table{
    3, {{{w1 / 2, w1}, {(w0 + w1) / 2, w0}, {(w0 + w1) / 2, w1}}}, w1 / 2};

double composition_amplification(const CompositionTable& table, double omega_dt, double zeta) {
    using Matrix = Eigen::Matrix2d;
    const auto drift = [](double d) { return Matrix{{1.0, d}, {0.0, 1.0}}; };
    const auto kick = [&](double k) {
        return Matrix{{1.0, 0.0}, {-k * omega_dt * omega_dt, 1.0 - 2.0 * k * zeta * omega_dt}};
    };
    Matrix step = Matrix::Identity();
    for (std::size_t i = 0; i < static_cast<std::size_t>(table.stages); ++i) {
        step = kick(table.stage[i].kick) * drift(table.stage[i].drift) * step;
    }
    step = drift(table.last_drift) * step;
    return step.eigenvalues().cwiseAbs().maxCoeff();
}

template <typename Real>
void Composition<Real>::prepare(DynamicsSystem<Real>& system) {
    a_ = Vec3Array<Real>(system.kick_drift_pass() != nullptr ? 0 : system.slot_count());
}

// Only the system's pass moves what is held: a drift without a kick before it would not.
template <typename Real>
void Composition<Real>::begin(DynamicsSystem<Real>& system, const ParticleState<Real>& state) {
    if (system.kick_drift_pass() == nullptr || table_.stage[0].drift != 0.0) return;
    system.hold(state.x.view(), state.v.view(), {});
}

template <typename Real>
void Composition<Real>::finish(DynamicsSystem<Real>& system, ParticleState<Real>& state) {
    system.release(state.x.view(), state.v.view(), {});
}

template <typename Real>
void Composition<Real>::drift(double h, ParticleState<Real>& state) const {
    if (h == 0.0) return;
    const Real step = static_cast<Real>(h);
    for_components(state.x, [&](std::size_t begin, std::size_t end) {
        Real* x = state.x.data();
        const Real* v = state.v.data();
        for (std::size_t n = begin; n < end; ++n) x[n] += step * v[n];
    });
}

template <typename Real>
void Composition<Real>::kick(DynamicsSystem<Real>& system, double t, double h,
                             ParticleState<Real>& state) {
    system.acceleration(t, state.x.view(), state.v.view(), a_.view());
    const Real step = static_cast<Real>(h);
    for_components(state.v, [&](std::size_t begin, std::size_t end) {
        Real* v = state.v.data();
        const Real* a = a_.data();
        for (std::size_t n = begin; n < end; ++n) v[n] += step * a[n];
    });
}

template <typename Real>
StepReport Composition<Real>::step(DynamicsSystem<Real>& system, double dt,
                                   ParticleState<Real>& state) {
    double t = state.time;
    const auto drifted = [&](double fraction) {
        if (fraction == 0.0) return;
        t += fraction * dt;
        system.constrain(t, state.x.view(), state.v.view());
    };
    KickDriftPass<Real>* const pass = system.kick_drift_pass();
    const auto stages = static_cast<std::size_t>(table_.stages);
    drift(table_.stage[0].drift * dt, state);
    drifted(table_.stage[0].drift);
    for (std::size_t i = 0; i < stages; ++i) {
        const double kick_step = table_.stage[i].kick * dt;
        const double fraction = i + 1 < stages ? table_.stage[i + 1].drift : table_.last_drift;
        if (pass != nullptr) {
            pass->kick_drift(t, kick_step, fraction * dt, state.x.view(), state.v.view());
        } else {
            kick(system, t, kick_step, state);
            drift(fraction * dt, state);
        }
        drifted(fraction);
    }
    state.time += dt;
    system.constrain(state.time, state.x.view(), state.v.view());
    return {};
}

template class Composition<float>;
template class Composition<double>;

}  // namespace weft
