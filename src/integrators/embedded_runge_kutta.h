// Explicit Runge-Kutta methods that choose their own steps by an embedded estimate of the error.
#pragma once

#include <limits>
#include <optional>

#include "integrators/runge_kutta.h"

namespace weft {

/// A method with a second one, of lower order, in the same stages. Its last stage is its end (c =
/// 1, row of a = b), so that a step's last acceleration is the next step's first.
struct EmbeddedTable {
    ButcherTable method;
    ButcherTable::Weights error{};  ///< b less the second method's weights
    ButcherTable::Weights dense{};  ///< d of the continuous extension (EmbeddedRungeKutta)
    int error_order = 0;            ///< q: the estimate is O(h^q)
    double previous_weight = 0.0;   ///< beta of the step control
};

/// Dormand, Prince (1980) J. Comput. Appl. Math. 6, 19: order 5 with 4; its continuous extension by
/// Shampine, as in Hairer, Norsett, Wanner, Solving ODEs I, II.5 and II.6.
extern const EmbeddedTable dopri5_table;
/// Bogacki, Shampine (1989) Appl. Math. Letters 2, 321: order 3 with 2; cubic Hermite between.
extern const EmbeddedTable bosh3_table;

inline double embedded_amplification(const EmbeddedTable& table, double omega_dt, double zeta) {
    return amplification(table.method, omega_dt, zeta);
}

struct ErrorControl {
    /// How far a step may put any particle wrong, > 0 [m]: see EmbeddedRungeKutta.
    double tolerance = 1e-5;
    /// No step is longer, > 0 [s].
    double largest_step = std::numeric_limits<double>::infinity();
};

/// Takes steps h as long as the error allows,
///     max over particles of |e_x|, h |e_v|  <=  max(tolerance, 4 eps (|x|, h |v|)),
/// where e is the two methods' difference at the end of one step: the error of the worse one; the
/// better one goes on. A particle's error in velocity counts as what it does to its place in one
/// such step. The bound with eps, the precision of the states (1.2e-7 in float), is what places can
/// hold: below half a micrometre for each metre from the origin, no tolerance helps in float.
///
/// The next step is h err^-alpha err_previous^beta, alpha = 1/q - 3/4 beta, err in tolerances
/// (PI control: Gustafsson (1991) ACM TOMS 17, 533; Hairer, Norsett, Wanner II.4), at least a fifth
/// and at most ten times the last, no more than that after a rejection. beta is 0.04 for dopri5, as
/// in its authors' program, and 0.4/q for bosh3, as Gustafsson has it for steps that stability
/// limits.
///
/// Steps end where they end; between, with theta = (t - t0) / h, the state is
///     y(theta) = cubic Hermite of both ends + theta^2 (1 - theta)^2 h sum d_i k_i,
/// of order 4 for dopri5 and 3 for bosh3, and pins are where they are at t. So frames fall on exact
/// times and shorten no step. But no step is longer than the dt that is asked for: what may begin
/// between frames, a gust or a pin's motion, is not stepped over.
template <typename Real>
class EmbeddedRungeKutta final : public Integrator<Real> {
public:
    using History = typename Integrator<Real>::History;

    /// A step must not get shorter to meet the tolerance; nor than what t can resolve [s].
    static constexpr double smallest_step = 1e-10;

    EmbeddedRungeKutta(const EmbeddedTable& table, const ErrorControl& control,
                       InstructionSet instruction_set);
    void prepare(DynamicsSystem<Real>& system) override;

    /// Fails where steps would have to be shorter than smallest_step, and then forgets what it has
    /// run ahead. Whoever changes the state in between calls restart().
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    [[nodiscard]] SolverCounts counts() const override { return counts_; }
    void restart() override { started_ = false; }
    void save(History& history) const override;
    void restore(const History& history) override;

private:
    using Weights = ButcherTable::Weights;

    [[nodiscard]] std::size_t last() const {
        return static_cast<std::size_t>(table_.method.stages) - 1;
    }
    void combine(double h, double c, const Weights& x_weights, const Weights& v_weights,
                 Vec3Array<Real>& out_x, Vec3Array<Real>& out_v) const;
    void evaluate(DynamicsSystem<Real>& system, double t, std::size_t stage);
    bool start(DynamicsSystem<Real>& system, double longest, const ParticleState<Real>& state);
    double first_length(DynamicsSystem<Real>& system, double longest);
    std::optional<StepFailure> advance(DynamicsSystem<Real>& system, double longest);
    void take_step(DynamicsSystem<Real>& system);
    double error();
    void interpolate(double t, ParticleState<Real>& state) const;

    EmbeddedTable table_;
    ErrorControl control_;
    InstructionSet instruction_set_;
    std::array<Weights, ButcherTable::max_stages> a_squared_{};

    // The step that was taken last, from begin_ to end_, with the accelerations of its stages.
    ParticleState<Real> begin_, end_;
    std::array<Vec3Array<Real>, ButcherTable::max_stages> slopes_;
    double length_ = 0.0;  // [s]
    bool started_ = false;
    bool retake_ = false;  // restored: of the step only its begin and its length are there
    double next_length_ = 0.0;
    double previous_error_ = 0.0;  // of the step before, in tolerances

    std::vector<double> block_maxima_;
    SolverCounts counts_;
};

}  // namespace weft
