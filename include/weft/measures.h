// What can be measured on a cloth.
#pragma once

#include <cstddef>
#include <string_view>

namespace weft {

/// Energies by kind [J].
struct Energy {
    double kinetic = 0.0;
    double gravity = 0.0;  ///< -sum m g.x, zero at the origin
    double structural = 0.0, shear = 0.0, bend = 0.0;

    [[nodiscard]] double springs() const { return structural + shear + bend; }
    [[nodiscard]] double total() const { return kinetic + gravity + springs(); }
};

/// Work done on the cloth since the start by what has no energy [J].
struct Work {
    double dashpots = 0.0;  ///< in the springs; never positive
    double drag = 0.0;      ///< on the particles; never positive
    double air = 0.0;
    double pins = 0.0;  ///< by moving pins

    [[nodiscard]] double total() const { return dashpots + drag + air + pins; }
};

/// What the steps of a method that solves or controls itself took, over a run; zero for others.
struct SolverCounts {
    std::size_t steps = 0;              ///< of its own choosing, taken
    std::size_t rejected = 0;           ///< tried, too inaccurate, repeated
    std::size_t evaluations = 0;        ///< of the forces
    std::size_t newton_iterations = 0;  ///< or the method's own iterations
    std::size_t linear_iterations = 0;  ///< of the linear solvers within

    friend SolverCounts operator+(const SolverCounts& a, const SolverCounts& b) {
        return {a.steps + b.steps, a.rejected + b.rejected, a.evaluations + b.evaluations,
                a.newton_iterations + b.newton_iterations,
                a.linear_iterations + b.linear_iterations};
    }
};

/// A spring and how far it is from its rest length L: strain = l / L - 1.
struct SpringStrain {
    double strain = 0.0;
    std::size_t p = 0, q = 0;  ///< its particles
    std::string_view kind;     ///< "structural", "shear" or "bend"
};

}  // namespace weft
