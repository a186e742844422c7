#include "simulation/cloth_motion.h"

#include <cmath>
#include <utility>

namespace weft {

template <typename Real>
ClothMotion<Real>::ClothMotion(const ClothModel& cloth, const SceneDescription& scene,
                               InstructionSet set, int threads)
    : cloth_(cloth),
      balance_(scene.output.energy_balance),
      clock_(scene.start.time, scene.output.frames_per_second),
      system_(cloth, scene, set, threads),
      filter_(cloth),
      measures_(cloth, scene.forces, set) {
    state_.x = Vec3Array<Real>(cloth.layout.slot_count());
    state_.v = Vec3Array<Real>(cloth.layout.slot_count());
    state_.time = clock_.time(0);
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        state_.x.set(slot, vec3_cast<Real>(cloth.rest_position(p)));
    });
    system_.constrain(state_.time, state_.x.view(), state_.v.view());
    filter_.set_obstacles(scene.obstacles);
}

template <typename Real>
void ClothMotion<Real>::go_on_from(const ClothMotion& other) {
    state_ = other.state_;
    frame_ = other.frame_;
    step_count_ = other.step_count_;
    meter_.set_work(other.work());
    system_.adopt_warnings(other.system_.warnings());
    system_.constrain(state_.time, state_.x.view(), state_.v.view());
}

template <typename Real>
void ClothMotion<Real>::set_integrator(std::unique_ptr<Integrator<Real>> integrator) {
    integrator_ = std::move(integrator);
    integrator_->prepare(system_);
    meter_.forget_power();
    save();
}

template <typename Real>
std::optional<StepFailure> ClothMotion<Real>::run_frame(std::size_t steps) {
    const double dt = frame_length() / static_cast<double>(steps);
    const auto power = [&] {
        return system_.power(state_.time, std::as_const(state_.x).view(),
                             std::as_const(state_.v).view());
    };
    if (balance_) meter_.begin(power);
    // A few steps are not worth another order in memory, to which they are copied and back.
    constexpr std::size_t fewest_unseen = 96;
    std::optional<UnseenSteps<Real>> unseen;
    if (!balance_ && !filter_.looks(system_) && steps >= fewest_unseen) {
        unseen.emplace(*integrator_, system_, state_);
    }
    for (std::size_t n = 1; n <= steps; ++n) {
        StepReport report = make_step(dt);
        if (!report.ok()) return std::move(report.failure);
        // From the frame's number, so that rounding does not add up over a long run.
        state_.time = n == steps ? clock_.time(frame_ + 1)
                                 : clock_.time(frame_) + static_cast<double>(n) * dt;
        if (balance_) meter_.add(dt, power());
    }
    return std::nullopt;
}

template <typename Real>
void ClothMotion<Real>::count_frame(std::size_t steps) {
    ++frame_;
    step_count_ += steps;
    save();
}

template <typename Real>
void ClothMotion<Real>::save() {
    good_.state.x = state_.x;
    good_.state.v = state_.v;
    good_.state.time = state_.time;
    integrator_->save(good_.history);
    good_.work = meter_.work();
}

template <typename Real>
void ClothMotion<Real>::go_back() {
    state_.x = good_.state.x;
    state_.v = good_.state.v;
    state_.time = good_.state.time;
    integrator_->restore(good_.history);
    strain_check_.reset();
    meter_.set_work(good_.work);
}

template <typename Real>
void ClothMotion<Real>::state_changed() {
    system_.constrain(state_.time, state_.x.view(), state_.v.view());
    strain_check_.reset();
    if (!integrator_) return;
    integrator_->restart();
    meter_.forget_power();
    save();
}

template <typename Real>
std::optional<Divergence> ClothMotion<Real>::find_divergence() {
    strain_check_ = measures_.check(state_.x.view(), state_.v.view());
    return weft::find_divergence(cloth_, state_, *strain_check_);
}

template <typename Real>
SpringStrain ClothMotion<Real>::largest_strain() const {
    if (!strain_check_) strain_check_ = measures_.check(state_.x.view(), state_.v.view());
    return measures_.largest_strain(state_.x.view(), *strain_check_);
}

template <typename Real>
Divergence ClothMotion<Real>::trace_divergence(std::size_t steps, bool restarted) {
    const double dt = frame_length() / static_cast<double>(steps);
    const std::optional<Divergence> at_end = find_divergence();
    std::optional<Divergence> found;
    std::size_t step = 0;
    go_back();
    if (restarted) integrator_->restart();
    while (!found && step < steps) {
        (void)make_step(dt);  // as it went before
        ++step;
        state_.time = clock_.time(frame_) + static_cast<double>(step) * dt;
        found = find_divergence();
    }
    if (!found) found = at_end;  // another linear solver than before took it elsewhere
    found->step = step_count_ + step;
    found->time = state_.time;
    found->time_step = dt;
    return *found;
}

template <typename Real>
Divergence ClothMotion<Real>::failed_step(std::size_t steps) const {
    Divergence failed;
    failed.time_step = frame_length() / static_cast<double>(steps);
    failed.time = state_.time;  // where it began
    const double into_frame = state_.time - clock_.time(frame_);
    failed.step =
        step_count_ + 1 + static_cast<std::size_t>(std::llround(into_frame / failed.time_step));
    return failed;
}

template class ClothMotion<float>;
template class ClothMotion<double>;

}  // namespace weft
