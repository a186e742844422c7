// Newton's method for the stages of implicit integrators.
#pragma once

#include <cstddef>

#include "integrators/dynamics_system.h"
#include "math/anderson_mixing.h"
#include "math/vec3_array.h"

namespace weft {

/// A stage of step tau from (x0, v0), whose root x makes
///     M (x - x0 - tau v0) / tau^2 = f(t, x, (x - x0) / tau).
/// Backward Euler is one such stage; every diagonally implicit method is a few of them.
struct ImplicitStage {
    double t = 0.0;    ///< where forces and pins are taken [s]
    double tau = 0.0;  ///< [s]
    ConstVec3View<double> x0, v0;
};

struct NewtonLimits {
    double tolerance = 1e-5;    ///< ends when no particle moved farther in an iteration [m] ...
    int max_iterations = 1000;  ///< not converged by then: a failure
    double force = 0.0;         ///< ... or feels no larger unbalanced force [N]
};

/// What a solution came to.
struct NewtonReport {
    bool converged = false;
    int iterations = 0;         ///< linear solves
    int linear_iterations = 0;  ///< within them
    int evaluations = 0;        ///< of the forces
    double displacement = 0.0;  ///< largest of a particle in the last iteration [m]
    double residual = 0.0;      ///< largest unbalanced force on a particle at the end [N]
    bool linear_converged = true;
    double linear_residual = 0.0;  ///< relative, of the last linear solve
};

/// Inexact Newton: linear systems are solved no better than the present residual deserves
/// (Eisenstat, Walker 1996, choice 2). A step that overshoots is shortened: along its direction d
/// the unbalanced force b must not point back by more than half of what it pointed forward, since
/// -b.d is the derivative of what a conservative system minimises; dashpots and air, which have no
/// energy, need no other treatment.
///
/// The matrix leaves out the negative part of compressed springs, and that the air's force turns
/// with the cloth: where cloth buckles Newton alone creeps, in strong wind it goes round in
/// circles. Anderson's mixing of the last iterations (math/anderson_mixing.h), whose directions
/// need not come from a gradient, mends both. Where that takes long, linear systems are solved
/// better: to mixing, what a loose solution leaves out is noise.
class NewtonSolver {
public:
    /// Sizes the work arrays.
    void prepare(std::size_t slots);

    /// @param x in: the first guess; out: the root. Pinned particles are put in place.
    /// @param v out: (x - x0) / tau.
    NewtonReport solve(ImplicitSystem& system, const ImplicitStage& stage,
                       const NewtonLimits& limits, Vec3Array<double>& x, Vec3Array<double>& v);

    /// One linear solve (Baraff, Witkin 1998; they linearise at x0, we at the guess: from
    /// x0 + tau v0 a difference of second order). x moves by less where that overshoots, as in
    /// solve(); they take it whole, and shorten the step where it tears the cloth.
    NewtonReport solve_once(ImplicitSystem& system, const ImplicitStage& stage,
                            Vec3Array<double>& x, Vec3Array<double>& v);

private:
    // b at x, and with it v.
    void evaluate(ImplicitSystem& system, const ImplicitStage& stage, Vec3View<double> x,
                  Vec3View<double> v);
    // d, and b.d.
    double find_direction(ImplicitSystem& system, double forcing);
    // Moves x by as much of d as does not overshoot. False: no way on from x along d.
    bool move_along(ImplicitSystem& system, const ImplicitStage& stage, double slope,
                    Vec3Array<double>& x, Vec3Array<double>& v);
    // False: no way on from x.
    bool iterate(ImplicitSystem& system, const ImplicitStage& stage, double forcing,
                 Vec3Array<double>& x, Vec3Array<double>& v);

    Vec3Array<double> b_, d_, plain_, start_;
    AndersonMixing mixing_;
    NewtonReport report_;
};

}  // namespace weft
