// Time integrators: advance positions and velocities by one step of x' = v, M v' = f(t, x, v).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloth/particle_state.h"
#include "integrators/dynamics_system.h"
#include "math/instruction_sets.h"
#include "weft/integrators.h"
#include "weft/measures.h"

namespace weft {

/// Why a step could not be made; the state is as before it.
struct StepFailure {
    std::string reason;  ///< one line: what did not converge, after how much, how far it came
    std::string advice;  ///< what to try
};

/// What making a step came to.
struct StepReport {
    std::optional<StepFailure> failure;
    [[nodiscard]] bool ok() const { return !failure.has_value(); }
};

template <typename Real>
class Integrator {
public:
    virtual ~Integrator() = default;

    /// Sizes the work arrays as the system's states; nothing else allocates but the first begin().
    /// What is zero in x, v and every acceleration, as padding is, stays zero.
    virtual void prepare(DynamicsSystem<Real>& system) = 0;

    /// Advances `state` from t to t + dt; adaptive methods do so in steps of their own. On failure
    /// the state is as it was.
    /// @pre dt > 0 and finite [s]; prepare() ran for this system.
    virtual StepReport step(DynamicsSystem<Real>& system, double dt,
                            ParticleState<Real>& state) = 0;

    /// Says that until finish() nobody but step(), always with this system and state, looks at the
    /// state's arrays: the system may hold them meanwhile (DynamicsSystem::hold).
    virtual void begin(DynamicsSystem<Real>& /*system*/, const ParticleState<Real>& /*state*/) {}
    virtual void finish(DynamicsSystem<Real>& /*system*/, ParticleState<Real>& /*state*/) {}

    /// What its steps took since prepare().
    [[nodiscard]] virtual SolverCounts counts() const { return {}; }

    /// Forgets what is kept from earlier steps: the next step starts from the state alone.
    virtual void restart() {}

    /// What is kept from earlier steps, for going back: save() into `history`, restore() from it.
    struct History {
        std::vector<Vec3Array<Real>> arrays;
        double last_step = 0.0;           ///< [s]; 0: none
        std::array<double, 3> control{};  ///< of methods that control their steps
    };
    virtual void save(History& history) const { history = {}; }
    virtual void restore(const History&) {}
};

/// begin() now, finish() at the end of the scope.
template <typename Real>
class UnseenSteps {
public:
    UnseenSteps(Integrator<Real>& integrator, DynamicsSystem<Real>& system,
                ParticleState<Real>& state)
        : integrator_(integrator), system_(system), state_(state) {
        integrator.begin(system, state);
    }
    UnseenSteps(const UnseenSteps&) = delete;
    UnseenSteps& operator=(const UnseenSteps&) = delete;
    ~UnseenSteps() { integrator_.finish(system_, state_); }

private:
    Integrator<Real>& integrator_;
    DynamicsSystem<Real>& system_;
    ParticleState<Real>& state_;
};

/// What a user may set of a method; each reads what concerns it.
struct IntegratorSettings {
    InstructionSet instruction_set = chosen_instruction_set();  ///< of its own loops
    std::optional<double> tolerance;                            ///< of IntegratorDescription [m]
    std::optional<int> iterations;                              ///< likewise
    std::optional<double> largest_step;                         ///< of an adaptive method [s]
};

/// @pre find_integrator(name) is not null.
template <typename Real>
std::unique_ptr<Integrator<Real>> make_integrator(std::string_view name,
                                                  const IntegratorSettings& settings = {});

extern template std::unique_ptr<Integrator<float>> make_integrator(std::string_view,
                                                                   const IntegratorSettings&);
extern template std::unique_ptr<Integrator<double>> make_integrator(std::string_view,
                                                                    const IntegratorSettings&);

}  // namespace weft
