// A cloth's state, advanced by frames of equal steps, and back where a frame was no good.
#pragma once

#include <memory>
#include <optional>

#include "cloth/particle_state.h"
#include "forces/measure_cloth.h"
#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "simulation/divergence.h"
#include "simulation/frame_clock.h"
#include "simulation/step_filter.h"
#include "simulation/work_meter.h"

namespace weft {

template <typename Real>
class ClothMotion {
public:
    /// At rest at the time of frame 0, pins where they are then. It has no integrator yet.
    /// @param cloth, scene outlive the motion.
    ClothMotion(const ClothModel& cloth, const SceneDescription& scene, InstructionSet set,
                int threads);

    /// Goes on where another one of the same particles at the same slots stands, with the pins of
    /// its own cloth.
    void go_on_from(const ClothMotion& other);

    /// @pre has_integrator() from then on for all that follows.
    void set_integrator(std::unique_ptr<Integrator<Real>> integrator);
    [[nodiscard]] bool has_integrator() const { return integrator_ != nullptr; }
    [[nodiscard]] SolverCounts counts() const { return integrator_->counts(); }
    /// What it keeps from earlier steps.
    void forget_history() { integrator_->restart(); }

    /// Makes a frame of so many steps; count_frame() or go_back() follows.
    /// @return why a step could not be made.
    std::optional<StepFailure> run_frame(std::size_t steps);
    void count_frame(std::size_t steps);
    /// To the end of the last frame that was counted.
    void go_back();

    /// After others than the integrator moved the cloth: pins stay, history is forgotten.
    void state_changed();
    /// What is wrong with the state, if anything.
    std::optional<Divergence> find_divergence();
    /// Makes the frame that was run last once more, looking after every step.
    /// @param restarted whether the integrator had forgotten its history before it.
    /// @return place, step and time of what was found.
    Divergence trace_divergence(std::size_t steps, bool restarted);
    /// Step and time of the step that failed.
    [[nodiscard]] Divergence failed_step(std::size_t steps) const;

    [[nodiscard]] ParticleState<Real>& state() { return state_; }
    [[nodiscard]] const ParticleState<Real>& state() const { return state_; }
    [[nodiscard]] ClothSystem<Real>& system() { return system_; }
    [[nodiscard]] const ClothSystem<Real>& system() const { return system_; }
    [[nodiscard]] StepFilter<Real>& filter() { return filter_; }
    /// Its scratch memory changes.
    [[nodiscard]] ClothMeasures<Real>& measures() const { return measures_; }
    [[nodiscard]] SpringStrain largest_strain() const;
    [[nodiscard]] std::size_t frame() const { return frame_; }
    [[nodiscard]] std::size_t step_count() const { return step_count_; }
    [[nodiscard]] double frame_length() const { return clock_.frame_length(); }
    [[nodiscard]] const Work& work() const { return meter_.work(); }

private:
    void save();
    StepReport make_step(double dt) { return filter_.step(*integrator_, system_, dt, state_); }

    const ClothModel& cloth_;
    bool balance_;  // of work
    FrameClock clock_;
    ClothSystem<Real> system_;
    StepFilter<Real> filter_;
    std::unique_ptr<Integrator<Real>> integrator_;
    ParticleState<Real> state_;
    mutable ClothMeasures<Real> measures_;
    mutable std::optional<StrainCheck> strain_check_;  // of the present state, where known
    std::size_t frame_ = 0, step_count_ = 0;
    WorkMeter meter_;
    struct {
        ParticleState<Real> state;
        typename Integrator<Real>::History history;
        Work work;
    } good_;  // the last frame that was
};

extern template class ClothMotion<float>;
extern template class ClothMotion<double>;

}  // namespace weft
