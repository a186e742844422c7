#include "weft/simulation.h"

#include "math/parallel.h"
#include "simulation/engine.h"
#include "weft/error.h"
#include "weft/version.h"

namespace weft {

// On the heap as a whole: the engine refers to the scene and the cloth.
struct Simulation::Parts {
    SceneDescription scene;
    ThreadTeam team;
    ClothModel cloth;
    EngineOptions options;
    std::unique_ptr<Engine> engine;

    Parts(const SceneDescription& description, int threads) : scene(description), team(threads) {
        check_scene(scene);
        cloth = build_cloth(scene);
        options.threads = team.size();
        engine = scene.integrator.precision == Precision::f32
                     ? make_engine<float>(cloth, scene, options)
                     : make_engine<double>(cloth, scene, options);
    }
};

Simulation::Simulation(const SceneDescription& scene, int threads)
    : parts_(std::make_unique<Parts>(scene, threads)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const SceneDescription& Simulation::scene() const {
    return parts_->scene;
}
const Surface& Simulation::surface() const {
    return parts_->cloth.surface;
}
std::size_t Simulation::particle_count() const {
    return parts_->cloth.particle_count;
}
std::size_t Simulation::pinned_count() const {
    return parts_->cloth.pins.size();
}
std::array<std::size_t, 3> Simulation::spring_counts() const {
    return parts_->cloth.spring_counts();
}
double Simulation::total_mass() const {
    return parts_->cloth.total_mass();
}
const std::vector<std::string>& Simulation::mesh_findings() const {
    return parts_->cloth.report.findings;
}
int Simulation::threads() const {
    return parts_->team.size();
}

std::string_view Simulation::instruction_set() const {
    return name_of(parts_->options.instruction_set);
}

LinearAnalysis Simulation::linear_analysis() const {
    return parts_->engine->linear_analysis();
}
double Simulation::stable_step(std::string_view method) const {
    return parts_->engine->stable_step(method);
}

std::string_view Simulation::method() const {
    return parts_->engine->method().method;
}
const std::string& Simulation::method_reason() const {
    return parts_->engine->method().reason;
}
std::string_view Simulation::linear_solver() const {
    return parts_->engine->linear_solver();
}
SolverCounts Simulation::solver_counts() const {
    return parts_->engine->solver_counts();
}

const std::vector<std::string>& Simulation::warnings() const {
    return parts_->engine->warnings();
}

void Simulation::set_integrator(const IntegratorDescription& integrator) {
    SceneDescription changed = parts_->scene;
    changed.integrator = integrator;
    check_scene(changed);
    if (integrator.precision != parts_->scene.integrator.precision) {
        throw scene_error("integrator.precision", "another than the running one",
                          "the same in the middle of a run; begin another with set_state()");
    }
    std::swap(parts_->scene.integrator, changed.integrator);
    try {
        parts_->team.run([&] { parts_->engine->change_integrator(); });
    } catch (...) {
        parts_->scene.integrator = changed.integrator;
        throw;
    }
}

SettleReport Simulation::settle() {
    SettleReport report;
    parts_->team.run([&] { report = parts_->engine->settle(); });
    return report;
}
const std::optional<SettleReport>& Simulation::settle_report() const {
    return parts_->engine->settle_report();
}

std::size_t Simulation::frame() const {
    return parts_->engine->frame();
}
double Simulation::time() const {
    return parts_->engine->time();
}
std::size_t Simulation::step_count() const {
    return parts_->engine->step_count();
}
std::size_t Simulation::steps_per_frame() const {
    return parts_->engine->steps_per_frame();
}
double Simulation::time_step() const {
    return 1.0 / scene().output.frames_per_second / static_cast<double>(steps_per_frame());
}

FrameReport Simulation::advance_frame() {
    FrameReport report;
    parts_->team.run([&] { report = parts_->engine->advance_frame(); });
    return report;
}

void Simulation::capture(FrameBuffer& buffer, FrameNeeds needs) const {
    parts_->team.run([&] { parts_->engine->capture(buffer, needs); });
}
void Simulation::set_state(std::span<const Vec3d> positions, std::span<const Vec3d> velocities) {
    parts_->engine->set_state(positions, velocities);
}

Energy Simulation::energy() const {
    Energy energy;
    parts_->team.run([&] { energy = parts_->engine->energy(); });
    return energy;
}
Work Simulation::work() const {
    return parts_->engine->work();
}
SpringStrain Simulation::largest_strain() const {
    SpringStrain strain;
    parts_->team.run([&] { strain = parts_->engine->largest_strain(); });
    return strain;
}
std::uint64_t Simulation::state_hash() const {
    return parts_->engine->state_hash();
}

std::string_view version() {
    return WEFT_VERSION;
}

}  // namespace weft
