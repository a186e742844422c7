// XPBD: extended position-based dynamics, for small steps.
#pragma once

#include "integrators/integrator.h"
#include "integrators/position_step.h"
#include "integrators/spring_colours.h"

namespace weft {

/// Macklin, Mueller, Chentanez (2016) "XPBD: position-based simulation of compliant constrained
/// dynamics", Motion in Games; with one sweep a step and steps as small as the time allows:
/// Macklin, Storey, Lu, Terdiman, Chentanez, Jeschke, Mueller (2019) "Small steps in physics
/// simulation", SCA (their substep is our step).
///
/// Each spring is a constraint C = |x_q - x_p| - L of compliance 1/k; with n its gradient at q and
/// w = 1/m_p + 1/m_q, a sweep solves one spring after the other (eq. 26 of the 2016 paper),
///     dlambda = (-C - alpha lambda - gamma n.(u_q - u_p)) / ((1 + gamma) w + alpha),
///     x_p -= dlambda n / m_p,     x_q += dlambda n / m_q,
/// with alpha = 1 / (k h^2), u = x - x_n and gamma = alpha beta / h. The paper's damping beta is
/// the spring's dashpot, beta = h^2 c, so gamma = c / (k h). Multiplied by k h^2, which is how it
/// is computed, a dashpot without a spring (k = 0) is no special case.
///
/// Starts from y (position_step.h) with lambda = 0. However many sweeps, the limit is implicit
/// Euler on a line only: a spring's impulses point where it pointed when each was added, which the
/// paper leaves out as small; it is of order h^4 a step. Momentum is conserved.
///
/// Gauss-Seidel by colours of springs: the same bits for any number of threads.
template <typename Real>
class Xpbd final : public Integrator<Real> {
public:
    /// @param iterations sweeps over all springs a step, at least 1.
    explicit Xpbd(int iterations = 1) : iterations_(iterations) {}

    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    [[nodiscard]] SolverCounts counts() const override { return counts_; }

private:
    struct Constraint {
        std::uint32_t p = 0, q = 0;
        Real rest_length{}, stiffness{}, damping{};
    };
    void sweep(Real h, Vec3View<Real> x);
    template <bool damped>
    void project(Real h, Vec3View<Real> x, std::size_t begin, std::size_t end);

    int iterations_;
    bool damped_ = false;
    PositionStep<Real> position_step_;
    std::vector<Constraint> constraints_;  // by colour
    std::vector<std::size_t> first_;       // [colour], and the end of the last
    std::vector<Real> multipliers_;        // lambda, by constraint [kg m]
    SolverCounts counts_;
};

extern template class Xpbd<float>;
extern template class Xpbd<double>;

}  // namespace weft
