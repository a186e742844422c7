#include "simulation/cloth_implicit_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "forces/assembled_newton_matrix.h"
#include "forces/grid_multigrid.h"
#include "forces/wind.h"
#include "simulation/scene_words.h"

namespace weft {

namespace {

// Enough for any matrix that is not singular in the solvers' precision.
constexpr int max_linear_iterations = 2000;

// A relative residual that a solver which works ends below, whatever it was asked for.
constexpr double useless = 0.1;

// Particles of a mesh above which a hierarchy is worth building.
constexpr std::size_t large_mesh = 1000;

LinearSolver best_solver(const ClothModel& cloth) {
    if (cloth.is_grid()) return LinearSolver::multigrid;
    return cloth.particle_count > large_mesh ? LinearSolver::aggregation : LinearSolver::jacobi;
}

}  // namespace

std::unique_ptr<NewtonMatrixSolver> make_newton_solver(const ClothModel& cloth, LinearSolver solver,
                                                       InstructionSet set, int threads) {
    if (solver == LinearSolver::automatic) solver = best_solver(cloth);
    if (solver == LinearSolver::multigrid) return make_grid_multigrid(cloth, set, threads);
    return make_assembled_solver(cloth, scene_word(solver), set, threads);
}

ClothImplicitSystem::ClothImplicitSystem(const ClothModel& cloth, const SceneDescription& scene,
                                         DynamicsSystem<double>& forces, const GripSprings& grips,
                                         const ContactSupports& supports,
                                         std::vector<std::string>& warnings, InstructionSet set,
                                         int threads)
    : cloth_(cloth),
      instruction_set_(set),
      threads_(threads),
      automatic_(scene.integrator.linear_solver == LinearSolver::automatic),
      forces_(forces),
      grips_(grips),
      supports_(supports),
      drag_(scene.forces.damping),
      inverse_masses_(cloth.layout.slot_count()),
      blocks_(cloth.layout.slot_count()),
      solver_(make_newton_solver(cloth, scene.integrator.linear_solver, set, threads)),
      warnings_(warnings) {
    cloth.layout.for_each(
        [&](std::size_t p, std::size_t slot) { inverse_masses_[slot] = 1.0 / cloth.masses[p]; });
    for (const Pin& pin : cloth.pins) inverse_masses_[cloth.slot(pin.particle)] = 0.0;
    if (scene.wind && scene.wind->air_density > 0.0) {
        wind_ = scene.wind;
        air_damping_.emplace(*wind_, cloth);
    }
}

void ClothImplicitSystem::acceleration(double t, ConstVec3View<double> x, ConstVec3View<double> v,
                                       Vec3View<double> a) {
    forces_.acceleration(t, x, v, a);
    for (const GripSpring& grip : grips_) {
        a.add(grip.slot, (1.0 / grip.mass) * grip.force(x[grip.slot], v[grip.slot]));
    }
    for (const ContactSupport& support : supports_.list) {
        a.add(support.slot, supports_.acceleration(support, x[support.slot]));
    }
}

void ClothImplicitSystem::linearise(double t, double inverse_tau, ConstVec3View<double> x,
                                    ConstVec3View<double> v) {
    for (const std::size_t diagonal : {std::size_t{0}, std::size_t{3}, std::size_t{5}}) {
        std::vector<double>& entry = blocks_.entries[diagonal];
        for (std::size_t s = 0; s < entry.size(); ++s) {
            const double w = inverse_masses_[s];
            entry[s] = w > 0.0 ? inverse_tau * (inverse_tau / w + drag_) : 0.0;
        }
        for (const GripSpring& grip : grips_) {
            entry[grip.slot] += grip.stiffness + inverse_tau * grip.damping;
        }
    }
    for (const std::size_t mixed : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
        std::fill(blocks_.entries[mixed].begin(), blocks_.entries[mixed].end(), 0.0);
    }
    for (const ContactSupport& support : supports_.list) {
        const Vec3d n = support.normal;
        const double stiffness = supports_.rate / inverse_masses_[support.slot];
        const std::array<double, 6> outer{n.x * n.x, n.x * n.y, n.x * n.z,
                                          n.y * n.y, n.y * n.z, n.z * n.z};
        for (std::size_t e = 0; e < outer.size(); ++e) {
            blocks_.entries[e][support.slot] += stiffness * outer[e];
        }
    }
    if (air_damping_) {
        const Vec3d wind = wind_velocity(*wind_, t);
        air_damping_->add(wind, x, v, inverse_tau, blocks_);
    }
    x_ = x;
    inverse_tau_ = inverse_tau;
    solver_->linearise(x, inverse_tau, blocks_);
}

LinearReport ClothImplicitSystem::solve(ConstVec3View<double> r, double tolerance,
                                        Vec3View<double> d) {
    const LinearReport report = solver_->solve(r, tolerance, max_linear_iterations, d);
    if (report.converged || report.residual < useless || !automatic_) return report;
    // What is not finite no solver mends.
    double squared = 0.0;
    for (std::size_t s = 0; s < r.size; ++s) {
        if (inverse_masses_[s] > 0.0) squared += dot(r[s], r[s]) + dot(x_[s], x_[s]);
    }
    if (!std::isfinite(squared)) return report;
    automatic_ = false;
    warnings_.push_back(fmt::format(
        "the linear solver {} broke down (relative residual {:.2g} after {} iterations) and was "
        "replaced by cholesky: the springs' stiffnesses differ by too much for it",
        solver_->name(), report.residual, report.iterations));
    // Nobody asked for CHOLMOD's supernodal module, which is under the GPL.
    solver_ = make_assembled_solver(cloth_, "simplicial cholesky", instruction_set_, threads_);
    solver_->linearise(x_, inverse_tau_, blocks_);
    LinearReport again = solver_->solve(r, tolerance, max_linear_iterations, d);
    again.iterations += report.iterations;
    return again;
}

}  // namespace weft
