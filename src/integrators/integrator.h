// Time integrators: advance positions and velocities by one step of x' = v, M v' = f(t, x, v).
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "cloth/particle_state.h"
#include "integrators/dynamics_system.h"
#include "math/instruction_sets.h"
#include "weft/integrators.h"

namespace weft {

template <typename Real>
class Integrator {
public:
    virtual ~Integrator() = default;

    /// Sizes the work arrays as the system's states; nothing else allocates. What is zero in x, v
    /// and every acceleration, as padding is, stays zero.
    virtual void prepare(DynamicsSystem<Real>& system) = 0;

    /// Advances `state` from t to t + dt.
    /// @pre dt > 0 and finite [s]; prepare() ran for this system.
    virtual void step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) = 0;

    /// Forgets what is kept from earlier steps: the next step starts from the state alone.
    virtual void restart() {}

    /// What is kept from earlier steps, for going back: save() into `history`, restore() from it.
    struct History {
        std::vector<Vec3Array<Real>> arrays;
        double last_step = 0.0;  ///< [s]; 0: none
    };
    virtual void save(History& history) const { history = {}; }
    virtual void restore(const History&) {}
};

/// @param set of the integrator's own loops; forces are the system's.
/// @pre find_integrator(name) is not null.
template <typename Real>
std::unique_ptr<Integrator<Real>> make_integrator(std::string_view name,
                                                  InstructionSet set = chosen_instruction_set());

extern template std::unique_ptr<Integrator<float>> make_integrator(std::string_view,
                                                                   InstructionSet);
extern template std::unique_ptr<Integrator<double>> make_integrator(std::string_view,
                                                                    InstructionSet);

}  // namespace weft
