// A cloth in motion, in one precision: state, integrator, step control. Simulation hides it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cloth/cloth_model.h"
#include "math/instruction_sets.h"
#include "simulation/method_choice.h"
#include "weft/simulation.h"

namespace weft {

class Engine {
public:
    virtual ~Engine() = default;

    virtual FrameReport advance_frame() = 0;
    virtual void capture(FrameBuffer& buffer, FrameNeeds needs) const = 0;
    virtual void set_state(std::span<const Vec3d> x, std::span<const Vec3d> v) = 0;

    /// Goes on as scene.integrator now says, from the present state.
    /// @throws Error (usage) as Simulation's constructor; the engine is as before.
    virtual void change_integrator() = 0;
    /// Scene.obstacles have changed, and nothing else of the scene.
    virtual void change_obstacles() = 0;
    /// @pre check_grips() accepts them.
    virtual void set_grips(std::span<const Grip> grips) = 0;
    [[nodiscard]] virtual Vec3d grip_force() const = 0;
    /// @throws Error (usage) for scenes with obstacles.
    virtual SettleReport settle() = 0;
    [[nodiscard]] virtual const std::optional<SettleReport>& settle_report() const = 0;

    [[nodiscard]] virtual const MethodChoice& method() const = 0;
    [[nodiscard]] virtual std::string_view linear_solver() = 0;
    [[nodiscard]] virtual SolverCounts solver_counts() const = 0;
    [[nodiscard]] virtual const std::vector<std::string>& warnings() const = 0;
    [[nodiscard]] virtual LinearAnalysis linear_analysis() const = 0;
    [[nodiscard]] virtual double stable_step(std::string_view method) const = 0;
    [[nodiscard]] virtual std::size_t frame() const = 0;
    [[nodiscard]] virtual double time() const = 0;
    [[nodiscard]] virtual std::size_t step_count() const = 0;
    [[nodiscard]] virtual std::size_t steps_per_frame() const = 0;
    [[nodiscard]] virtual Energy energy() const = 0;
    [[nodiscard]] virtual Work work() const = 0;
    [[nodiscard]] virtual SpringStrain largest_strain() const = 0;
    [[nodiscard]] virtual std::uint64_t state_hash() const = 0;
};

/// How an engine computes; without effect on what it computes but for rounding.
struct EngineOptions {
    InstructionSet instruction_set = chosen_instruction_set();
    int threads = 1;  ///< that loops may be shared by
};

/// @param cloth, scene outlive the engine.
/// @param previous null: begins as the scene says. Else goes on where this one stands, made by
///        make_engine<Real> for a cloth of the same particles at the same slots; what it counted
///        goes on too. It is not changed, and its own cloth and scene are not looked at.
template <typename Real>
std::unique_ptr<Engine> make_engine(const ClothModel& cloth, const SceneDescription& scene,
                                    const EngineOptions& options = {},
                                    const Engine* previous = nullptr);

extern template std::unique_ptr<Engine> make_engine<float>(const ClothModel&,
                                                           const SceneDescription&,
                                                           const EngineOptions&, const Engine*);
extern template std::unique_ptr<Engine> make_engine<double>(const ClothModel&,
                                                            const SceneDescription&,
                                                            const EngineOptions&, const Engine*);

}  // namespace weft
