// The cloth as implicit methods solve with it: forces in double, Newton's matrix, its solver.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/contact_supports.h"
#include "contact/grip_springs.h"
#include "forces/air_damping.h"
#include "forces/newton_matrix.h"
#include "integrators/dynamics_system.h"
#include "math/instruction_sets.h"

namespace weft {

/// The solver that `integrator.linear_solver` names; for "auto", the one that measures best:
/// multigrid on a grid; on a mesh aggregation, for small ones block Jacobi.
/// @pre not multigrid on a mesh.
std::unique_ptr<NewtonMatrixSolver> make_newton_solver(const ClothModel& cloth, LinearSolver solver,
                                                       InstructionSet set, int threads);

class ClothImplicitSystem final : public ImplicitSystem {
public:
    /// @param forces the cloth's forces in double; they and the cloth outlive the system.
    /// @param grips, supports act besides them; they outlive the system, and may change between
    ///        steps.
    /// @param warnings outlives the system; gets a line when a solver is replaced.
    ClothImplicitSystem(const ClothModel& cloth, const SceneDescription& scene,
                        DynamicsSystem<double>& forces, const GripSprings& grips,
                        const ContactSupports& supports, std::vector<std::string>& warnings,
                        InstructionSet set, int threads);

    void acceleration(double t, ConstVec3View<double> x, ConstVec3View<double> v,
                      Vec3View<double> a) override;
    void constrain(double t, Vec3View<double> x, Vec3View<double> v) const override {
        forces_.constrain(t, x, v);
    }
    [[nodiscard]] std::span<const double> inverse_masses() const override {
        return inverse_masses_;
    }
    void linearise(double t, double inverse_tau, ConstVec3View<double> x,
                   ConstVec3View<double> v) override;
    /// Where the solver was chosen automatically and breaks down, as floats do on springs whose
    /// stiffnesses differ by more than their digits, Cholesky's factorisation takes its place from
    /// then on.
    LinearReport solve(ConstVec3View<double> r, double tolerance, Vec3View<double> d) override;

    [[nodiscard]] std::string_view solver_name() const { return solver_->name(); }

private:
    const ClothModel& cloth_;
    InstructionSet instruction_set_;
    int threads_;
    bool automatic_;  // whether another solver may be chosen
    DynamicsSystem<double>& forces_;
    const GripSprings& grips_;
    const ContactSupports& supports_;
    double drag_;                            // [kg/s]
    std::optional<WindDescription> wind_;    // where there is air
    std::optional<AirDamping> air_damping_;  // likewise
    std::vector<double> inverse_masses_;     // [slot], 0: pinned, or padding [1/kg]
    SymmetricBlocks<double> blocks_;         // of the last linearise(), with ...
    ConstVec3View<double> x_;                // ... its place
    double inverse_tau_ = 0.0;               // ... and [1/s]
    std::unique_ptr<NewtonMatrixSolver> solver_;
    std::vector<std::string>& warnings_;
};

}  // namespace weft
