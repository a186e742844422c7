#include "simulation/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "integrators/integrator.h"
#include "simulation/cloth_motion.h"
#include "simulation/grip_check.h"
#include "simulation/scene_rules.h"
#include "simulation/settle.h"
#include "simulation/stability.h"
#include "weft/error.h"
#include "weft/integrators.h"

namespace weft {

namespace {

constexpr int max_halvings = 12;  // of the step, over a run; of implicit ones in a frame
constexpr std::size_t frames_between_estimates = 8;
constexpr int products_per_estimate = 2;
constexpr double gripped_step = 1.0 / 600;  // [s]

template <typename Real>
class ClothEngine final : public Engine {
public:
    ClothEngine(const ClothModel& cloth, const SceneDescription& scene,
                const EngineOptions& options, const ClothEngine* previous);

    FrameReport advance_frame() override;
    void capture(FrameBuffer& buffer, FrameNeeds needs) const override;
    void set_state(std::span<const Vec3d> x, std::span<const Vec3d> v) override;

    void change_integrator() override;
    void change_obstacles() override;
    void set_grips(std::span<const Grip> grips) override;
    [[nodiscard]] Vec3d grip_force() const override;
    SettleReport settle() override;
    [[nodiscard]] const std::optional<SettleReport>& settle_report() const override {
        return settle_report_;
    }
    [[nodiscard]] const MethodChoice& method() const override { return method_; }
    [[nodiscard]] std::string_view linear_solver() override {
        return kind() == IntegratorKind::implicit
                   ? motion_.system().implicit_system()->solver_name()
                   : std::string_view{};
    }
    [[nodiscard]] SolverCounts solver_counts() const override {
        return counts_before_ + motion_.counts();
    }
    [[nodiscard]] const std::vector<std::string>& warnings() const override {
        return motion_.system().warnings();
    }
    [[nodiscard]] LinearAnalysis linear_analysis() const override;
    [[nodiscard]] double stable_step(std::string_view method) const override {
        return modes_.stable_step(method);
    }
    [[nodiscard]] std::size_t frame() const override { return motion_.frame(); }
    [[nodiscard]] double time() const override { return motion_.state().time; }
    [[nodiscard]] std::size_t step_count() const override { return motion_.step_count(); }
    [[nodiscard]] std::size_t steps_per_frame() const override { return steps_per_frame_; }
    [[nodiscard]] Energy energy() const override { return motion_.measures().energy(x(), v()); }
    [[nodiscard]] Work work() const override { return motion_.work(); }
    [[nodiscard]] SpringStrain largest_strain() const override { return motion_.largest_strain(); }
    [[nodiscard]] std::uint64_t state_hash() const override {
        return motion_.measures().state_hash(x(), v());
    }

private:
    [[nodiscard]] ConstVec3View<Real> x() const { return motion_.state().x.view(); }
    [[nodiscard]] ConstVec3View<Real> v() const { return motion_.state().v.view(); }

    [[nodiscard]] bool is_auto() const { return !scene_.integrator.time_step.has_value(); }
    // Whether the step is kept stable while the cloth moves.
    [[nodiscard]] bool follows_stability() const {
        return is_auto() && kind() == IntegratorKind::explicit_steps;
    }
    [[nodiscard]] std::size_t steps_of(const std::string& method) const {
        return steps_a_frame(scene_, method, modes_);
    }
    [[nodiscard]] IntegratorKind kind() const { return find_integrator(method_.method)->kind; }
    void put_grips();
    void put_at_start();
    void go_on_from(const ClothEngine& previous);
    void follow_stretching();
    void keep_stable();
    [[nodiscard]] std::size_t steps_of_next_frame() const;
    Divergence divergence(const std::optional<StepFailure>& failure, std::size_t steps,
                          bool restarted);
    [[nodiscard]] bool may_halve(int in_frame) const;
    void start_at_rest();

    const ClothModel& cloth_;
    const SceneDescription& scene_;
    EngineOptions options_;
    ClothMotion<Real> motion_;
    std::vector<Grip> grips_;
    StabilityModes modes_;
    MethodChoice method_;
    SolverCounts counts_before_;  // of integrators before the present one
    std::optional<SettleReport> settle_report_;
    std::optional<StabilityAnalysis<Real>> analysis_;  // while the step follows it
    std::size_t steps_per_frame_ = 1;
    int halvings_ = 0;
};

template <typename Real>
ClothEngine<Real>::ClothEngine(const ClothModel& cloth, const SceneDescription& scene,
                               const EngineOptions& options, const ClothEngine* previous)
    : cloth_(cloth),
      scene_(scene),
      options_(options),
      motion_(cloth, scene, options.instruction_set, options.threads) {
    analysis_.emplace(cloth, scene.forces, options.instruction_set, options.threads);
    modes_ = analysis_->find(x());
    if (previous != nullptr) {
        go_on_from(*previous);
    } else if (scene.start.state) {
        put_at_start();
    }
    change_integrator();
    if (scene.output.settle && previous == nullptr) start_at_rest();
}

// The stable step is that of the cloth at rest, as in the run that the state may come from, unless
// the cloth is stretched.
template <typename Real>
void ClothEngine<Real>::put_at_start() {
    const ClothState& start = *scene_.start.state;
    if (start.positions.size() != cloth_.particle_count) {
        throw scene_error("start.state",
                          fmt::format("a state of {} particles", start.positions.size()),
                          fmt::format("this cloth has {}", cloth_.particle_count));
    }
    set_state(start.positions, start.velocities);
    follow_stretching();
}

template <typename Real>
void ClothEngine<Real>::go_on_from(const ClothEngine& previous) {
    motion_.go_on_from(previous.motion_);
    counts_before_ = previous.solver_counts();
    settle_report_ = previous.settle_report_;
    grips_ = previous.grips_;
    follow_stretching();
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
    if (motion_.has_integrator()) counts_before_ = solver_counts();
    method_ = choice;
    motion_.system().forget_implicit_system();
    if (follows_stability() && !analysis_) {
        analysis_.emplace(cloth_, scene_.forces, options_.instruction_set, options_.threads);
        modes_ = analysis_->find(x());
    } else if (!follows_stability()) {
        analysis_.reset();
    }
    const IntegratorDescription& chosen = scene_.integrator;
    motion_.set_integrator(make_integrator<Real>(
        method_.method, {options_.instruction_set, solver_tolerance(scene_, cloth_, method_.method),
                         chosen.iterations, chosen.time_step}));
    motion_.filter().suit(*find_integrator(method_.method));
    put_grips();
}

template <typename Real>
void ClothEngine<Real>::change_obstacles() {
    // The automatic step depends on whether there are any: to find it takes milliseconds.
    if (scene_.obstacles.empty() != motion_.filter().is_free()) {
        steps_per_frame_ = steps_of(method_.method);
    }
    motion_.filter().set_obstacles(scene_.obstacles);
    motion_.system().supports().list.clear();  // of the last step; settle() would rest on them
}

template <typename Real>
void ClothEngine<Real>::set_grips(std::span<const Grip> grips) {
    grips_.assign(grips.begin(), grips.end());
    put_grips();
}

template <typename Real>
void ClothEngine<Real>::put_grips() {
    GripSprings springs = grip_springs(grips_, cloth_);
    for (GripSpring& spring : springs) spring.velocity = vec3_cast<double>(v()[spring.slot]);
    motion_.system().set_grips(std::move(springs));
}

template <typename Real>
Vec3d ClothEngine<Real>::grip_force() const {
    const bool in_equations = kind() == IntegratorKind::implicit;
    Vec3d force;
    for (const GripSpring& grip : motion_.system().grips()) {
        force += grip.force(vec3_cast<double>(x()[grip.slot]),
                            in_equations ? vec3_cast<double>(v()[grip.slot]) : grip.velocity);
    }
    return force;
}

template <typename Real>
LinearAnalysis ClothEngine<Real>::linear_analysis() const {
    const Mode& fastest = modes_.modes.front();
    return {fastest.omega,
            fastest.omega > 0.0 ? fastest.damping_rate / (2.0 * fastest.omega) : 0.0};
}

// The largest frequency rises as the cloth stretches.
template <typename Real>
void ClothEngine<Real>::follow_stretching() {
    const double squared = analysis_->follow(x(), products_per_estimate);
    Mode& fastest = modes_.modes.front();
    if (squared > fastest.omega * fastest.omega) fastest.omega = std::sqrt(squared);
}

// Under "auto", refines the step.
template <typename Real>
void ClothEngine<Real>::keep_stable() {
    if (!follows_stability() || motion_.frame() == 0 ||
        motion_.frame() % frames_between_estimates != 0)
        return;
    const double before = modes_.modes.front().omega;
    follow_stretching();
    if (modes_.modes.front().omega == before) return;
    steps_per_frame_ = std::max(steps_per_frame_, steps_of(method_.method));
}

// A grip that is not in a method's equations holds the more, the shorter the steps; and at their
// limit, the inner steps of a composition that lead back in time are upset by it.
template <typename Real>
std::size_t ClothEngine<Real>::steps_of_next_frame() const {
    if (grips_.empty() || !is_auto()) return steps_per_frame_;
    const IntegratorInfo& info = *find_integrator(method_.method);
    switch (info.kind) {
        case IntegratorKind::implicit:
            return steps_per_frame_;
        case IntegratorKind::explicit_steps:
            return info.symplectic && info.order > 2 ? 2 * steps_per_frame_ : steps_per_frame_;
        case IntegratorKind::adaptive:
        case IntegratorKind::by_springs:
            break;
    }
    return std::max(steps_per_frame_, steps_in_frame(motion_.frame_length(), gripped_step));
}

// What ended a frame of so many steps.
template <typename Real>
Divergence ClothEngine<Real>::divergence(const std::optional<StepFailure>& failure,
                                         std::size_t steps, bool restarted) {
    Divergence found =
        failure ? motion_.failed_step(steps) : motion_.trace_divergence(steps, restarted);
    found.stable_step = modes_.stable_step(method_.method);
    if (failure) {
        describe_failure(found, *failure, method_.method);
    } else {
        describe_divergence(found, cloth_, method_.method);
    }
    return found;
}

template <typename Real>
SettleReport ClothEngine<Real>::settle() {
    if (!scene_.obstacles.empty()) {
        throw scene_error("output.settle", "settling",
                          std::string(scene_rules::settle_among_obstacles));
    }
    ParticleState<Real>& state = motion_.state();
    Vec3Array<double> place(cloth_.layout.slot_count());
    cloth_.layout.for_each(
        [&](std::size_t, std::size_t slot) { place.set(slot, vec3_cast<double>(state.x[slot])); });
    const double weight = length(scene_.forces.gravity) * cloth_.total_mass() /
                          static_cast<double>(cloth_.particle_count);
    settle_report_ =
        weft::settle(*motion_.system().implicit_system(), state.time, weight, {}, place);
    if (settle_report_->converged) {
        cloth_.layout.for_each([&](std::size_t, std::size_t slot) {
            state.x.set(slot, vec3_cast<Real>(place[slot]));
        });
        state.v.fill_zero();
        motion_.state_changed();
    }
    return *settle_report_;
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
    std::size_t steps = steps_of_next_frame();
    while (true) {
        const std::optional<StepFailure> failure = motion_.run_frame(steps);
        report.steps = steps;
        report.time_step = motion_.frame_length() / static_cast<double>(steps);
        if (!failure && !motion_.find_divergence()) break;
        if (!may_halve(report.halvings)) {
            report.divergence = divergence(failure, steps, report.halvings > 0);
            motion_.go_back();
            return report;
        }
        motion_.go_back();
        motion_.forget_history();  // what it keeps belongs to the longer step
        steps *= 2;
        ++report.halvings;
        if (kind() == IntegratorKind::implicit) continue;
        steps_per_frame_ *= 2;
        ++halvings_;
    }
    motion_.count_frame(report.steps);
    return report;
}

template <typename Real>
void ClothEngine<Real>::capture(FrameBuffer& buffer, FrameNeeds needs) const {
    buffer.index = motion_.frame();
    buffer.time = motion_.state().time;
    const auto count = [&](bool needed) { return needed ? cloth_.particle_count : 0; };
    buffer.positions.resize(count(needs.positions));
    buffer.velocities.resize(count(needs.velocities));
    buffer.normals.resize(count(needs.normals));
    buffer.rounded_positions.resize(count(needs.rounded_positions));
    ClothMeasures<Real>& measures = motion_.measures();
    if (needs.positions) measures.copy(x(), std::span(buffer.positions));
    if (needs.velocities) measures.copy(v(), std::span(buffer.velocities));
    if (needs.normals) measures.normals(x(), buffer.normals);
    if (needs.rounded_positions) measures.copy(x(), std::span(buffer.rounded_positions));
}

template <typename Real>
void ClothEngine<Real>::set_state(std::span<const Vec3d> x, std::span<const Vec3d> v) {
    ParticleState<Real>& state = motion_.state();
    cloth_.layout.for_each([&](std::size_t p, std::size_t slot) {
        state.x.set(slot, vec3_cast<Real>(x[p]));
        state.v.set(slot, vec3_cast<Real>(v[p]));
    });
    motion_.state_changed();
    put_grips();
}

}  // namespace

template <typename Real>
std::unique_ptr<Engine> make_engine(const ClothModel& cloth, const SceneDescription& scene,
                                    const EngineOptions& options, const Engine* previous) {
    return std::make_unique<ClothEngine<Real>>(cloth, scene, options,
                                               static_cast<const ClothEngine<Real>*>(previous));
}

template std::unique_ptr<Engine> make_engine<float>(const ClothModel&, const SceneDescription&,
                                                    const EngineOptions&, const Engine*);
template std::unique_ptr<Engine> make_engine<double>(const ClothModel&, const SceneDescription&,
                                                     const EngineOptions&, const Engine*);

}  // namespace weft
