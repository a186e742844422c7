// What every time integrator states of itself. The tests measure each statement.
#pragma once

#include <span>
#include <string_view>

namespace weft {

/// What limits a method's step.
enum class IntegratorKind {
    explicit_steps,  ///< stability
    adaptive,        ///< the error that the user allows: it chooses its steps itself
    implicit,        ///< accuracy alone; a step is a nonlinear system, solved by Newton
    by_springs,      ///< the same; solved by iterations that treat springs or particles one by one
};

/// A row of `weft list integrators`.
struct IntegratorInfo {
    std::string_view name;   ///< key in scene files: "velocity-verlet"
    int order;               ///< the global error is O(dt^order), for smooth forces
    int damped_order;        ///< the same where forces depend on velocity
    int evaluations;         ///< of the forces, per step; 0: as many as it takes
    bool symplectic;         ///< energy error stays bounded for conservative forces
    double imaginary_limit;  ///< undamped: stable up to dt * omega; 0: at no step
    IntegratorKind kind;
    double auto_step;          ///< what time_step = "auto" takes where nothing limits it [s]; or 0
    std::string_view formula;  ///< the update
    std::string_view reference;  ///< where it comes from
};

/// All integrators, in menu order.
std::span<const IntegratorInfo> integrator_catalogue();

/// @return nullptr where no such method exists.
const IntegratorInfo* find_integrator(std::string_view name);

/// Largest growth per step of an oscillator x'' = -omega^2 x - 2 zeta omega x', the spectral radius
/// of the method's one-step matrix. At most 1: stable.
/// @param omega_dt omega times the step, >= 0.  @param zeta damping ratio, >= 0.
double amplification(std::string_view method, double omega_dt, double zeta);

/// The largest omega * dt below which every step is stable for damping ratio zeta; 0: none is.
double stability_limit(std::string_view method, double zeta);

}  // namespace weft
