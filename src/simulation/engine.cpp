#include "simulation/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "forces/measure_cloth.h"
#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "simulation/divergence.h"
#include "simulation/settle.h"
#include "simulation/stability.h"
#include "weft/error.h"
#include "weft/integrators.h"

namespace weft {

namespace {

constexpr int max_halvings = 12;  // of the step, over a run; of implicit ones in a frame
constexpr std::size_t frames_between_estimates = 8;
constexpr int products_per_estimate = 2;

Work operator+(const Work& a, const Work& b) {
    return {a.dashpots + b.dashpots, a.drag + b.drag, a.air + b.air, a.pins + b.pins};
}

Work operator*(double s, const Work& a) {
    return {s * a.dashpots, s * a.drag, s * a.air, s * a.pins};
}

template <typename Real>
class ClothEngine final : public Engine {
public:
    ClothEngine(const ClothModel& cloth, const SceneDescription& scene,
                const EngineOptions& options);

    FrameReport advance_frame() override;
    void capture(FrameBuffer& buffer, FrameNeeds needs) const override;
    void set_state(std::span<const Vec3d> x, std::span<const Vec3d> v) override;

    void change_integrator() override;
    SettleReport settle() override;
    [[nodiscard]] const std::optional<SettleReport>& settle_report() const override {
        return settle_report_;
    }
    [[nodiscard]] const MethodChoice& method() const override { return method_; }
    [[nodiscard]] std::string_view linear_solver() override {
        return kind() == IntegratorKind::implicit ? system_.implicit_system()->solver_name()
                                                  : std::string_view{};
    }
    [[nodiscard]] SolverCounts solver_counts() const override {
        return counts_before_ + integrator_->counts();
    }
    [[nodiscard]] const std::vector<std::string>& warnings() const override {
        return system_.warnings();
    }
    [[nodiscard]] LinearAnalysis linear_analysis() const override;
    [[nodiscard]] double stable_step(std::string_view method) const override {
        return modes_.stable_step(method);
    }
    [[nodiscard]] std::size_t frame() const override { return frame_; }
    [[nodiscard]] double time() const override { return state_.time; }
    [[nodiscard]] std::size_t step_count() const override { return step_count_; }
    [[nodiscard]] std::size_t steps_per_frame() const override { return steps_per_frame_; }
    [[nodiscard]] Energy energy() const override {
        return measures_.energy(state_.x.view(), state_.v.view());
    }
    [[nodiscard]] Work work() const override { return work_; }
    [[nodiscard]] SpringStrain largest_strain() const override {
        if (!strain_check_) strain_check_ = measures_.check(state_.x.view(), state_.v.view());
        return measures_.largest_strain(state_.x.view(), *strain_check_);
    }
    [[nodiscard]] std::uint64_t state_hash() const override {
        return measures_.state_hash(state_.x.view(), state_.v.view());
    }

private:
    using History = typename Integrator<Real>::History;

    [[nodiscard]] double frame_length() const { return 1.0 / scene_.output.frames_per_second; }
    [[nodiscard]] double frame_time(std::size_t frame) const {
        return static_cast<double>(frame) / scene_.output.frames_per_second;
    }
    [[nodiscard]] bool is_auto() const { return !scene_.integrator.time_step.has_value(); }
    // Whether the step is kept stable while the cloth moves.
    [[nodiscard]] bool follows_stability() const {
        return is_auto() && kind() == IntegratorKind::explicit_steps;
    }
    [[nodiscard]] std::size_t steps_of(const std::string& method) const {
        return steps_a_frame(scene_, method, modes_);
    }
    [[nodiscard]] IntegratorKind kind() const { return find_integrator(method_.method)->kind; }
    void keep_stable();
    std::optional<StepFailure> run_steps(std::size_t count, std::size_t steps_per_frame);
    Divergence describe_failure(const StepFailure& failure, std::size_t steps_per_frame) const;
    [[nodiscard]] bool may_halve(int in_frame) const;
    void start_at_rest();
    void state_changed();
    void save();
    void go_back();
    std::optional<Divergence> find_divergence();
    Divergence trace_divergence(std::size_t steps_per_frame, bool restarted);

    const ClothModel& cloth_;
    const SceneDescription& scene_;
    EngineOptions options_;
    ClothSystem<Real> system_;
    std::unique_ptr<Integrator<Real>> integrator_;
    ParticleState<Real> state_;
    mutable ClothMeasures<Real> measures_;             // its scratch memory changes
    mutable std::optional<StrainCheck> strain_check_;  // of the present state, where known
    StabilityModes modes_;
    MethodChoice method_;
    SolverCounts counts_before_;  // of integrators before the present one
    std::optional<SettleReport> settle_report_;
    std::optional<StabilityAnalysis<Real>> analysis_;  // while the step follows it
    std::size_t frame_ = 0, step_count_ = 0, steps_per_frame_ = 1;
    int halvings_ = 0;
    Work work_, last_power_;
    bool power_known_ = false;
    struct {
        ParticleState<Real> state;
        History history;
        Work work;
    } good_;  // the last frame that was
};

template <typename Real>
ClothEngine<Real>::ClothEngine(const ClothModel& cloth, const SceneDescription& scene,
                               const EngineOptions& options)
    : cloth_(cloth),
      scene_(scene),
      options_(options),
      system_(cloth, scene, options.instruction_set, options.threads),
      measures_(cloth, scene.forces, options.instruction_set) {
    state_.x = Vec3Array<Real>(cloth.layout.slot_count());
    state_.v = Vec3Array<Real>(cloth.layout.slot_count());
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        state_.x.set(slot, vec3_cast<Real>(cloth.rest_position(p)));
    });
    system_.constrain(0.0, state_.x.view(), state_.v.view());
    analysis_.emplace(cloth, scene.forces, options.instruction_set, options.threads);
    modes_ = analysis_->find(std::as_const(state_.x).view());
    change_integrator();
    if (scene.output.settle) start_at_rest();
}

template <typename Real>
void ClothEngine<Real>::start_at_rest() {
    const SettleReport report = settle();
    if (report.converged) return;
    throw Error(ErrorKind::diverged, {.file = scene_.file, .key = "output.settle"}, report.message,
                "Steady wind may keep a cloth from any rest; try output.settle = false, or "
                "integrator.linear_solver = \"cholesky\".");
}

template <typename Real>
void ClothEngine<Real>::change_integrator() {
    const MethodChoice choice = choose_method(scene_, cloth_, modes_);
    steps_per_frame_ = steps_of(choice.method);  // may throw: before anything changes
    if (integrator_) counts_before_ = solver_counts();
    method_ = choice;
    system_.forget_implicit_system();
    const IntegratorDescription& chosen = scene_.integrator;
    integrator_ = make_integrator<Real>(
        method_.method, {options_.instruction_set, solver_tolerance(scene_, cloth_, method_.method),
                         chosen.iterations, chosen.time_step});
    integrator_->prepare(system_);
    if (follows_stability() && !analysis_) {
        analysis_.emplace(cloth_, scene_.forces, options_.instruction_set, options_.threads);
        modes_ = analysis_->find(std::as_const(state_.x).view());
    } else if (!follows_stability()) {
        analysis_.reset();
    }
    power_known_ = false;
    save();
}

template <typename Real>
LinearAnalysis ClothEngine<Real>::linear_analysis() const {
    const Mode& fastest = modes_.modes.front();
    return {fastest.omega,
            fastest.omega > 0.0 ? fastest.damping_rate / (2.0 * fastest.omega) : 0.0};
}

// Under "auto", follows the largest frequency while the cloth stretches, and refines the step.
template <typename Real>
void ClothEngine<Real>::keep_stable() {
    if (!follows_stability() || frame_ == 0 || frame_ % frames_between_estimates != 0) return;
    const double squared = analysis_->follow(std::as_const(state_.x).view(), products_per_estimate);
    Mode& fastest = modes_.modes.front();
    if (!(squared > fastest.omega * fastest.omega)) return;
    fastest.omega = std::sqrt(squared);
    steps_per_frame_ = std::max(steps_per_frame_, steps_of(method_.method));
}

template <typename Real>
std::optional<StepFailure> ClothEngine<Real>::run_steps(std::size_t count,
                                                        std::size_t steps_per_frame) {
    const double dt = frame_length() / static_cast<double>(steps_per_frame);
    const bool balance = scene_.output.energy_balance;
    const auto power = [&] {
        return system_.power(state_.time, std::as_const(state_.x).view(),
                             std::as_const(state_.v).view());
    };
    if (balance && !power_known_) last_power_ = power();
    power_known_ = balance;
    for (std::size_t n = 1; n <= count; ++n) {
        StepReport report = integrator_->step(system_, dt, state_);
        if (!report.ok()) return std::move(report.failure);
        // From the frame's number, so that rounding does not add up over a long run.
        state_.time = n == steps_per_frame ? frame_time(frame_ + 1)
                                           : frame_time(frame_) + static_cast<double>(n) * dt;
        if (balance) {
            const Work now = power();
            work_ = work_ + 0.5 * dt * (last_power_ + now);
            last_power_ = now;
        }
    }
    return std::nullopt;
}

template <typename Real>
void ClothEngine<Real>::save() {
    good_.state.x = state_.x;
    good_.state.v = state_.v;
    good_.state.time = state_.time;
    integrator_->save(good_.history);
    good_.work = work_;
}

template <typename Real>
void ClothEngine<Real>::go_back() {
    state_.x = good_.state.x;
    state_.v = good_.state.v;
    state_.time = good_.state.time;
    integrator_->restore(good_.history);
    strain_check_.reset();
    work_ = good_.work;
    power_known_ = false;
}

template <typename Real>
std::optional<Divergence> ClothEngine<Real>::find_divergence() {
    strain_check_ = measures_.check(state_.x.view(), state_.v.view());
    return weft::find_divergence(cloth_, state_, *strain_check_);
}

// Runs the failed frame once more, as it was run, looking after every step.
// @param restarted whether the integrator had forgotten its history (after a halving).
template <typename Real>
Divergence ClothEngine<Real>::trace_divergence(std::size_t steps_per_frame, bool restarted) {
    const double dt = frame_length() / static_cast<double>(steps_per_frame);
    const std::optional<Divergence> at_end = find_divergence();
    std::optional<Divergence> found;
    std::size_t step = 0;
    go_back();
    if (restarted) integrator_->restart();
    while (!found && step < steps_per_frame) {
        (void)integrator_->step(system_, dt, state_);  // as it went before
        ++step;
        state_.time = frame_time(frame_) + static_cast<double>(step) * dt;
        found = find_divergence();
    }
    if (!found) found = at_end;  // another linear solver than before took it elsewhere
    found->step = step_count_ + step;
    found->time = state_.time;
    found->time_step = dt;
    found->stable_step = modes_.stable_step(method_.method);
    describe_divergence(*found, cloth_, method_.method);
    return *found;
}

// A step that could not be made, told as a divergence. state_.time is where it began.
template <typename Real>
Divergence ClothEngine<Real>::describe_failure(const StepFailure& failure,
                                               std::size_t steps_per_frame) const {
    Divergence divergence;
    divergence.time_step = frame_length() / static_cast<double>(steps_per_frame);
    divergence.time = state_.time;
    divergence.step = step_count_ + 1 +
                      static_cast<std::size_t>(
                          std::llround((state_.time - frame_time(frame_)) / divergence.time_step));
    divergence.stable_step = modes_.stable_step(method_.method);
    divergence.message = fmt::format("{} cannot make step {}, of {:.4g} s: {}", method_.method,
                                     divergence.step, divergence.time_step, failure.reason);
    divergence.advice = failure.advice;
    return divergence;
}

template <typename Real>
SettleReport ClothEngine<Real>::settle() {
    ImplicitSystem& system = *system_.implicit_system();
    Vec3Array<double> x(cloth_.layout.slot_count());
    cloth_.layout.for_each(
        [&](std::size_t, std::size_t slot) { x.set(slot, vec3_cast<double>(state_.x[slot])); });
    const double weight = length(scene_.forces.gravity) * cloth_.total_mass() /
                          static_cast<double>(cloth_.particle_count);
    settle_report_ = weft::settle(system, state_.time, weight, {}, x);
    if (settle_report_->converged) {
        cloth_.layout.for_each(
            [&](std::size_t, std::size_t slot) { state_.x.set(slot, vec3_cast<Real>(x[slot])); });
        state_.v.fill_zero();
        state_changed();
    }
    return *settle_report_;
}

// After others than the integrator moved the cloth.
template <typename Real>
void ClothEngine<Real>::state_changed() {
    system_.constrain(state_.time, state_.x.view(), state_.v.view());
    strain_check_.reset();
    integrator_->restart();
    power_known_ = false;
    save();
}

// An implicit step that cannot be solved, or leads nowhere, is not too long for the cloth but for
// this one moment: it is shortened for the frame alone.
template <typename Real>
bool ClothEngine<Real>::may_halve(int in_frame) const {
    const bool asked = is_auto() || scene_.integrator.on_divergence == OnDivergence::halve_step;
    if (!asked || kind() == IntegratorKind::adaptive) return false;
    return (kind() == IntegratorKind::implicit ? in_frame : halvings_) < max_halvings;
}

template <typename Real>
FrameReport ClothEngine<Real>::advance_frame() {
    keep_stable();
    FrameReport report;
    std::size_t steps = steps_per_frame_;
    while (true) {
        const std::optional<StepFailure> failure = run_steps(steps, steps);
        report.steps = steps;
        report.time_step = frame_length() / static_cast<double>(steps);
        if (!failure && !find_divergence()) break;
        if (!may_halve(report.halvings)) {
            report.divergence = failure ? describe_failure(*failure, steps)
                                        : trace_divergence(steps, report.halvings > 0);
            go_back();
            return report;
        }
        go_back();
        integrator_->restart();  // what it keeps belongs to the longer step
        steps *= 2;
        ++report.halvings;
        if (kind() == IntegratorKind::implicit) continue;
        steps_per_frame_ = steps;
        ++halvings_;
    }
    ++frame_;
    step_count_ += report.steps;
    save();
    return report;
}

template <typename Real>
void ClothEngine<Real>::capture(FrameBuffer& buffer, FrameNeeds needs) const {
    buffer.index = frame_;
    buffer.time = state_.time;
    const auto count = [&](bool needed) { return needed ? cloth_.particle_count : 0; };
    buffer.positions.resize(count(needs.positions));
    buffer.velocities.resize(count(needs.velocities));
    buffer.normals.resize(count(needs.normals));
    buffer.rounded_positions.resize(count(needs.rounded_positions));
    const auto x = state_.x.view(), v = state_.v.view();
    if (needs.positions) measures_.copy(x, std::span(buffer.positions));
    if (needs.velocities) measures_.copy(v, std::span(buffer.velocities));
    if (needs.normals) measures_.normals(x, buffer.normals);
    if (needs.rounded_positions) measures_.copy(x, std::span(buffer.rounded_positions));
}

template <typename Real>
void ClothEngine<Real>::set_state(std::span<const Vec3d> x, std::span<const Vec3d> v) {
    cloth_.layout.for_each([&](std::size_t p, std::size_t slot) {
        state_.x.set(slot, vec3_cast<Real>(x[p]));
        state_.v.set(slot, vec3_cast<Real>(v[p]));
    });
    state_changed();
}

}  // namespace

template <typename Real>
std::unique_ptr<Engine> make_engine(const ClothModel& cloth, const SceneDescription& scene,
                                    const EngineOptions& options) {
    return std::make_unique<ClothEngine<Real>>(cloth, scene, options);
}

template std::unique_ptr<Engine> make_engine<float>(const ClothModel&, const SceneDescription&,
                                                    const EngineOptions&);
template std::unique_ptr<Engine> make_engine<double>(const ClothModel&, const SceneDescription&,
                                                     const EngineOptions&);

}  // namespace weft
