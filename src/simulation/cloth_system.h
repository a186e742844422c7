// The cloth as a second-order system: a(t, x, v) from all forces, and the pins.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cloth/cloth_model.h"
#include "contact/contact_supports.h"
#include "contact/grip_springs.h"
#include "forces/grid_air.h"
#include "forces/grid_kernel.h"
#include "forces/grid_springs.h"
#include "forces/mesh_air.h"
#include "forces/mesh_kernel.h"
#include "forces/mesh_springs.h"
#include "integrators/dynamics_system.h"
#include "simulation/cloth_implicit_system.h"
#include "weft/measures.h"

namespace weft {

template <typename Real>
class ClothSystem final : public DynamicsSystem<Real>,
                          private KickDriftPass<Real>,
                          private VerletPass<Real> {
public:
    /// @param cloth, scene outlive the system.
    /// @param threads that loops may be shared by.
    ClothSystem(const ClothModel& cloth, const SceneDescription& scene,
                InstructionSet instruction_set = chosen_instruction_set(), int threads = 1);

    [[nodiscard]] std::size_t slot_count() const override { return cloth_.layout.slot_count(); }
    void acceleration(double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                      Vec3View<Real> a) override;
    void constrain(double t, Vec3View<Real> x, Vec3View<Real> v) const override;
    [[nodiscard]] KickDriftPass<Real>* kick_drift_pass() override {
        return grid_kernel_ || mesh_kernel_ ? this : nullptr;
    }
    [[nodiscard]] VerletPass<Real>* verlet_pass() override { return grid_kernel_ ? this : nullptr; }
    void hold(ConstVec3View<Real> x, ConstVec3View<Real> v, ConstVec3View<Real> a) override {
        if (grid_kernel_) grid_kernel_->hold(x, v, a, cloth_.motions.empty());
    }
    void release(Vec3View<Real> x, Vec3View<Real> v, Vec3View<Real> a) override {
        if (grid_kernel_) grid_kernel_->release(x, v, a);
    }
    [[nodiscard]] ClothImplicitSystem* implicit_system() override;
    /// The next implicit_system() is made anew, with the scene's linear solver of then.
    void forget_implicit_system() { implicit_system_.reset(); }
    /// Of all its implicit systems so far.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// Those of a system that it takes the place of.
    void adopt_warnings(const std::vector<std::string>& warnings) { warnings_ = warnings; }
    /// What pulls besides the forces: implicit_system() has it, acceleration() does not.
    void set_grips(GripSprings grips) { grips_ = std::move(grips); }
    [[nodiscard]] GripSprings& grips() { return grips_; }
    [[nodiscard]] const GripSprings& grips() const { return grips_; }
    /// What holds up the cloth on obstacles in the next step: likewise.
    [[nodiscard]] ContactSupports& supports() { return supports_; }
    [[nodiscard]] const SpringNetwork* spring_network() override;
    void external_acceleration(double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                               Vec3View<Real> a) override;

    /// Rates of work of what has no energy [W], in the fields of Work.
    Work power(double t, ConstVec3View<Real> x, ConstVec3View<Real> v);

private:
    void kick_drift(double t, double kick, double drift, Vec3View<Real> x,
                    Vec3View<Real> v) override;
    void verlet(double t, double h, Vec3View<Real> x, Vec3View<Real> v, Vec3View<Real> a) override;

    // Which forces, besides gravity.
    enum class Kinds { all, without_springs };

    [[nodiscard]] Vec3<Real> wind_at(double t) const;
    // f = everything but gravity: -c v, springs, air; on rows of a grid or slots of a mesh.
    void add_forces(Kinds kinds, Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                    Vec3View<Real> f, std::size_t begin, std::size_t end) const;
    template <typename Finish>
    void forces(Kinds kinds, double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                Vec3View<Real> f, const Finish& finish);
    void twin_acceleration(Kinds kinds, double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                           Vec3View<Real> a);
    double pin_power(double t, ConstVec3View<Real> f) const;

    const ClothModel& cloth_;
    const SceneDescription& scene_;
    InstructionSet instruction_set_;
    int threads_;
    ForcesDescription description_;
    std::optional<WindDescription> wind_;
    std::vector<Real> inverse_masses_;             ///< [slot], 0: pinned or padding [1/kg]
    std::optional<GridKernel<Real>> grid_kernel_;  ///< for grids, or
    std::optional<MeshKernel<Real>>
        mesh_kernel_;  ///< for meshes; for scalar and power() the twins:
    std::optional<GridSprings<Real>> grid_springs_;
    std::optional<MeshSprings<Real>> mesh_springs_;
    std::optional<GridAir<Real>> grid_air_;
    std::optional<MeshAir<Real>> mesh_air_;
    std::vector<PinTarget<Real>> moving_pins_;  ///< by rising slot, as verlet() last put them
    Vec3Array<Real> forces_;                    ///< for power() with moving pins or air only
    GripSprings grips_;
    ContactSupports supports_;
    // Where asked for:
    std::unique_ptr<SpringNetwork> spring_network_;
    std::unique_ptr<ClothSystem<double>> forces_in_double_;  ///< of a system in float
    std::unique_ptr<ClothImplicitSystem> implicit_system_;
    std::vector<std::string> warnings_;
};

extern template class ClothSystem<float>;
extern template class ClothSystem<double>;

}  // namespace weft
