// Vertex block descent.
#pragma once

#include "integrators/integrator.h"
#include "integrators/position_step.h"
#include "integrators/spring_colours.h"

namespace weft {

/// Chen, Liu, Yang, Yuksel (2024) "Vertex block descent", ACM Trans. Graph. 43 (4), 116.
///
/// Minimises G(x) = |x - y|_M^2 / (2 h^2) + E(x) (position_step.h has y) one particle after the
/// other, each by one Newton step on its own three coordinates, x_i += H_i^-1 f_i (section 3.2),
/// with
///     f_i = -m (x_i - y_i) / h^2 + sum over springs (k (l - L) + (c / h) n.(u_j - u_i)) n,
///     H_i = m / h^2 + sum over springs k (n n^T + max(0, 1 - L/l) (I - n n^T)) + (c / h) n n^T,
/// u = x - x_n. Two departures: the paper leaves Hessians indefinite, we leave out their negative
/// part (compressed springs), so that each solve descends; and its damping, (k_d / h) H (x_i -
/// x_n), holds a particle back in space, ours is the spring's dashpot between both ends: its limit
/// is that of implicit-euler.
///
/// Starts from the paper's adaptive guess (section 3.7), x_n + h v_n + h^2 a, where a is the last
/// step's acceleration (v_n - v_(n-1)) / h along the external one, held between none and all of it;
/// a first step takes all of it, y. Accelerated by Chebyshev's semi-iteration over sweeps (section
/// 3.8; Wang 2015): x^(n) = w_n (x - x^(n-2)) + x^(n-2), w_2 = 2 / (2 - rho^2),
/// w_n = 4 / (4 - rho^2 w_(n-1)).
///
/// Gauss-Seidel by colours of particles: the same bits for any number of threads.
template <typename Real>
class VertexBlockDescent final : public Integrator<Real> {
public:
    using History = typename Integrator<Real>::History;

    /// @param iterations sweeps over all particles a step, at least 1.
    /// @param rho estimated convergence rate of a sweep, in [0, 1); 0: not accelerated. Above the
    ///        true rate it leaves up to 1 / T_n(1 / rho) of the first error after n sweeps (T_n:
    ///        Chebyshev's polynomial), so it is lowered to where that is a twentieth.
    explicit VertexBlockDescent(int iterations = 20, double rho = 0.9);

    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    [[nodiscard]] SolverCounts counts() const override { return counts_; }
    void restart() override { started_ = false; }
    void save(History& history) const override {
        history.arrays.resize(1);
        history.arrays[0] = acceleration_;
        history.last_step = started_ ? 1.0 : 0.0;
    }
    void restore(const History& history) override;

private:
    void guess(Real h, ParticleState<Real>& state) const;
    void sweep(Real h, Vec3View<Real> x) const;
    void descend(Real h, std::size_t row, Vec3View<Real> x) const;
    void extrapolate(int iteration, Vec3Array<Real>& x);
    void keep_acceleration(Real h, const ParticleState<Real>& state);

    int iterations_;
    double rho_, weight_ = 1.0;  // Chebyshev's w_n
    bool started_ = false;       // acceleration_ is that of the last step
    PositionStep<Real> position_step_;
    SpringRows<Real> rows_;               // by colour
    std::vector<std::size_t> first_;      // [colour] row, and the end of the last
    Vec3Array<Real> acceleration_;        // of the last step [m/s2]
    Vec3Array<Real> last_, before_last_;  // x^(n-1), x^(n-2); with Chebyshev only
    SolverCounts counts_;
};

extern template class VertexBlockDescent<float>;
extern template class VertexBlockDescent<double>;

}  // namespace weft
