#include "weft/simulation.h"

#include "math/parallel.h"
#include "simulation/engine.h"
#include "simulation/grip_check.h"
#include "simulation/scene_change.h"
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
        engine = new_engine(nullptr);
    }

    std::unique_ptr<Engine> new_engine(const Engine* previous) {
        return scene.integrator.precision == Precision::f32
                   ? make_engine<float>(cloth, scene, options, previous)
                   : make_engine<double>(cloth, scene, options, previous);
    }

    // The engine goes on with `changed`. Where that throws, all is as it was, down to the addresses
    // of what the old engine refers to.
    void take_over(SceneDescription& changed, const SceneChange& change);
    void rebuild(const SceneChange& change);
};

void Simulation::Parts::take_over(SceneDescription& changed, const SceneChange& change) {
    std::swap(scene, changed);
    try {
        if (change.forces || change.cloth) {
            rebuild(change);
        } else {
            if (change.integrator) engine->change_integrator();
            if (change.obstacles) engine->change_obstacles();
        }
    } catch (...) {
        std::swap(scene, changed);
        throw;
    }
}

void Simulation::Parts::rebuild(const SceneChange& change) {
    if (!change.cloth) {
        engine = new_engine(engine.get());
        return;
    }
    ClothModel other = build_cloth(scene);
    // Who draws it holds the surface, which is the same.
    const auto exchange = [&] {
        std::swap(cloth, other);
        std::swap(cloth.surface, other.surface);
    };
    exchange();
    try {
        engine = new_engine(engine.get());
    } catch (...) {
        exchange();
        throw;
    }
}

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
    SceneChange change = scene_change(parts_->scene, changed);
    change.integrator = true;  // also where it is the same: begun anew
    parts_->team.run([&] { parts_->take_over(changed, change); });
}

void Simulation::change_scene(const SceneDescription& scene) {
    check_scene(scene);
    SceneDescription changed = scene;
    const SceneChange change = scene_change(parts_->scene, changed);
    parts_->team.run([&] { parts_->take_over(changed, change); });
}

void Simulation::set_grips(std::span<const Grip> grips) {
    check_grips(grips, particle_count());
    parts_->engine->set_grips(grips);
}
Vec3d Simulation::grip_force() const {
    return parts_->engine->grip_force();
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
