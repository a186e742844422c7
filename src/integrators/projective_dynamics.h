// Projective dynamics, as local and global steps or as a quasi-Newton method.
#pragma once

#include "integrators/integrator.h"
#include "integrators/position_step.h"
#include "integrators/projective_matrix.h"
#include "integrators/spring_colours.h"
#include "math/limited_memory.h"

namespace weft {

/// Bouaziz, Martin, Liu, Kavan, Pauly (2014) "Projective dynamics: fusing constraint projections
/// for fast simulation", ACM Trans. Graph. 33 (4), 154; for springs first in Liu, Bargteil,
/// O'Brien, Kavan (2013). Minimises, with d = x_q - x_p along each spring,
///     G(x) = |x - y|_M^2 / (2 h^2) + sum over springs (k/2) |d - L n|^2 + (c / (2 h)) |d - p|^2
/// (position_step.h has y), where n = d / |d| and p are what the local step projects d on: the
/// sphere of radius L; and, for a dashpot, the plane through d_n (the spring at the step's start)
/// with normal n_n = d_n / |d_n|, so that the term is (c / (2 h)) (n_n.(d - d_n))^2: the dashpot
/// pulls along where the spring lay when the step began. The rest is implicit Euler.
///
/// Local and global step together are x -= A^-1 grad G, with the constant
///     A = M / h^2 + sum over springs (k + c / h) (e_p - e_q) (e_p - e_q)^T,
/// factored once for each step size: Liu, Bouaziz, Kavan (2017) "Quasi-Newton methods for real-time
/// simulation of hyperelastic materials", ACM Trans. Graph. 36 (3), 23. As there, the last m pairs
/// of steps and gradients correct A (L-BFGS), and steps are halved until G falls enough (Armijo,
/// 1e-4); m = 0 is the method of 2014. Starts from y.
///
/// Computes in double whatever the state's precision. The solve with A runs on one thread.
template <typename Real>
class ProjectiveDynamics final : public Integrator<Real> {
public:
    struct Settings {
        int iterations = 20;     ///< at most, at least 1
        double tolerance = 0.0;  ///< ends when no coordinate moved by more in an iteration [m]
        int memory = 5;          ///< m, pairs of L-BFGS; 0: none
    };

    explicit ProjectiveDynamics(const Settings& settings) : settings_(settings) {}

    void prepare(DynamicsSystem<Real>& system) override;
    /// Fails where A cannot be factored: masses, stiffnesses or step beyond double's range.
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    [[nodiscard]] SolverCounts counts() const override { return counts_; }

private:
    bool factor(double h);
    void minimise(double h);
    double evaluate(double h, const Vec3Array<double>& x, Vec3Array<double>& gradient);
    double evaluate_row(double h, std::size_t row, const Vec3Array<double>& x,
                        Vec3Array<double>& gradient) const;
    void find_direction();
    double advance(double h, double value);
    [[nodiscard]] double largest_move() const;

    Settings settings_;
    double factored_step_ = 0.0;  // [s]; 0: none
    bool damped_ = false;
    PositionStep<Real> position_step_;
    SpringRows<double> rows_;  // by rising slot
    ProjectiveMatrix matrix_;
    LimitedMemory memory_;
    Vec3Array<double> start_, target_, x_, next_, gradient_, next_gradient_, direction_;
    std::vector<double> block_sums_;
    SolverCounts counts_;
};

extern template class ProjectiveDynamics<float>;
extern template class ProjectiveDynamics<double>;

}  // namespace weft
