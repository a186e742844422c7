// A running simulation: a scene made into a cloth and advanced frame by frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weft/frame.h"
#include "weft/measures.h"
#include "weft/scene.h"

namespace weft {

/// Why and where a run diverged: a co-ordinate that is not a finite number, or a spring longer than
/// max_strain allows.
struct Divergence {
    static constexpr double max_strain = 100.0;

    std::size_t step = 0;                 ///< from 1, over the whole run
    double time = 0.0;                    ///< after that step [s]
    std::optional<SpringStrain> spring;   ///< the spring overstretched ...
    std::optional<std::size_t> particle;  ///< ... or the first particle not finite
    double time_step = 0.0;               ///< the step used [s]
    double stable_step = 0.0;             ///< what would have been stable [s]; 0: no step is
    std::string message;                  ///< all of it in one line
    std::string advice;                   ///< what to try
};

/// What advancing by a frame came to. On divergence the state is that of the last good frame.
struct [[nodiscard]] FrameReport {
    std::size_t steps = 0;   ///< made in this frame
    double time_step = 0.0;  ///< their length [s]
    /// Of the step, made in this frame. Implicit methods shorten it for the frame alone.
    int halvings = 0;
    std::optional<Divergence> divergence;

    [[nodiscard]] bool ok() const { return !divergence.has_value(); }
};

/// What settling came to.
struct SettleReport {
    bool converged = false;
    std::size_t newton_iterations = 0;
    std::size_t linear_iterations = 0;
    double residual = 0.0;           ///< largest unbalanced force on a particle [N] ...
    double relative_residual = 0.0;  ///< ... over the mean weight of one (or the first residual)
    std::string message;             ///< all of it in one line
};

/// A spring between a particle and a point of space, as of a hand that holds the cloth. Stable at
/// any stiffness and step: implicit methods have it in their equations, after the steps of others
/// the particle is corrected implicitly. Pinned particles do not feel it.
struct Grip {
    std::size_t particle = 0;
    Vec3d point{};           ///< [m]
    double stiffness = 0.0;  ///< [N/m]
    double damping = 0.0;    ///< against the particle's velocity [N s/m]
};

/// The scene's cloth linearised at its start.
struct LinearAnalysis {
    double omega_max = 0.0;      ///< largest angular frequency [1/s]
    double damping_ratio = 0.0;  ///< zeta of that mode
};

/// Not copyable; use from one thread at a time. The same scene gives the same states, to the bit,
/// for any number of threads.
class Simulation {
public:
    /// @param threads at least 1; 0: all hardware threads.
    /// @throws Error (usage) where check_scene() does, for pins that select nothing, or where
    ///         time_step is "auto" and the method is stable at no step; Error (file) for a mesh
    ///         that cannot be a cloth.
    explicit Simulation(const SceneDescription& scene, int threads = 1);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    [[nodiscard]] const SceneDescription& scene() const;
    [[nodiscard]] const Surface& surface() const;
    [[nodiscard]] std::size_t particle_count() const;
    [[nodiscard]] std::size_t pinned_count() const;
    [[nodiscard]] std::array<std::size_t, 3> spring_counts() const;  ///< structural, shear, bend
    [[nodiscard]] double total_mass() const;                         ///< [kg]
    /// Findings in the mesh, a line each; empty for a grid or a flawless mesh.
    [[nodiscard]] const std::vector<std::string>& mesh_findings() const;
    [[nodiscard]] int threads() const;
    /// Of the kernels it runs: the instruction_set() of when it was made.
    [[nodiscard]] std::string_view instruction_set() const;

    [[nodiscard]] LinearAnalysis linear_analysis() const;
    /// Largest step at which `method` is stable on this scene, linearised at its start [s];
    /// 0: at none; infinity: no spring limits it.
    [[nodiscard]] double stable_step(std::string_view method) const;

    /// The method that runs: the scene's, or the one chosen for "auto" ...
    [[nodiscard]] std::string_view method() const;
    /// ... and why, in one line; empty where the scene names it.
    [[nodiscard]] const std::string& method_reason() const;
    /// The linear solver of an implicit method: "multigrid", ...; empty for others.
    [[nodiscard]] std::string_view linear_solver() const;
    /// What its steps took so far; zero for methods of fixed cost.
    [[nodiscard]] SolverCounts solver_counts() const;
    /// What happened while it ran that one should know of, a line each: that a linear solver chosen
    /// automatically broke down, and by what it was replaced.
    [[nodiscard]] const std::vector<std::string>& warnings() const;

    [[nodiscard]] std::size_t frame() const;       ///< frames completed
    [[nodiscard]] double time() const;             ///< [s]
    [[nodiscard]] std::size_t step_count() const;  ///< steps completed
    [[nodiscard]] double time_step() const;        ///< of the next frame's steps [s]
    [[nodiscard]] std::size_t steps_per_frame() const;

    /// Advances to the next frame.
    FrameReport advance_frame();

    /// Copies the present state, and its normals.
    /// @param needs what to fill; the rest of the buffer is emptied.
    void capture(FrameBuffer& buffer, FrameNeeds needs = {}) const;

    /// Replaces positions [m] and velocities [m/s] of all particles; pinned ones stay.
    /// @pre both have particle_count() elements.
    void set_state(std::span<const Vec3d> positions, std::span<const Vec3d> velocities);

    /// Goes on by another method, step or solver from the present state and time.
    /// @throws Error (usage) where check_scene() or the constructor would, and for another
    ///         precision than the present; nothing has changed then.
    void set_integrator(const IntegratorDescription& integrator);

    /// Goes on with an edited scene from the present positions, velocities and time: material,
    /// forces, wind, pins, obstacles, integrator. Pinned particles go to where the new scene has
    /// them. What is kept from earlier steps is forgotten where more than obstacles changed.
    /// @throws Error (usage) as the constructor, and where cloth, start, frame rate or precision
    ///         would become others than the present; nothing has changed then.
    void change_scene(const SceneDescription& scene);

    /// Replaces the grips that pull at the cloth; an empty list lets go. No part of the scene.
    /// @throws Error (usage) for a particle that does not exist or a number that is not finite or
    ///         negative.
    void set_grips(std::span<const Grip> grips);
    /// With which all grips together pull now [N].
    [[nodiscard]] Vec3d grip_force() const;

    /// Moves the cloth to a state of rest near the present one, where the forces of gravity,
    /// springs and the wind at time() balance; velocities become zero.
    /// Grips pull; on failure the state is as it was.
    /// @throws Error (usage) where the scene has obstacles: what rests on them is not found yet.
    SettleReport settle();
    /// What the last settle() came to, also the one of output.settle.
    [[nodiscard]] const std::optional<SettleReport>& settle_report() const;

    [[nodiscard]] Energy energy() const;
    /// Work since the start; zero unless the scene sets output.energy_balance.
    [[nodiscard]] Work work() const;
    [[nodiscard]] SpringStrain largest_strain() const;
    /// Of the bits of x and v.
    [[nodiscard]] std::uint64_t state_hash() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The version of the library, e.g. "0.1.0".
std::string_view version();

}  // namespace weft
